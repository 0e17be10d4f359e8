// Data from one form to another: rasters to points, points on a grid to rasters.
#pragma once
#include <string>

#include "knotfit/source_data.h"
#include "sampling.h"
namespace knotfit::tool {

/// Columns x,y,z and what else the data has (u,v,w); holes are left out.
Table points_table(const SourceData& data);

/// The raster that the points of `data` fill, cells without a point as holes.
/// \throws InvalidInput  they do not lie on a grid of equal cells, or two are in one cell
Raster raster_of(const SourceData& data);

}  // namespace knotfit::tool
