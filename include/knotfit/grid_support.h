// Which nodes of a raster lie over scattered points, and not beyond them or in an opening.
#pragma once
#include <vector>

#include "knotfit/points.h"
#include "knotfit/source_data.h"
namespace [[gnu::visibility("default")]] knotfit {

/// A node is over the data where a point is within 2.5 spacings of it (spacing: the median circle through the corners of a
/// triangle, over two rings about the point) and it is in no opening (CloudMap::openings).
/// \param points  their x, y are those of the map
/// \param grid    its z is not looked at
/// \return rows x columns as Raster::z has them: 1 over the data
/// \throws InvalidInput  all points on one line
std::vector<char> grid_support(const ParameterizedPoints& points, const Raster& grid);

}  // namespace knotfit
