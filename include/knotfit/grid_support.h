// Which nodes of a raster lie over scattered points, and not beyond them or in an opening.
#pragma once
#include <vector>

#include "knotfit/points.h"
#include "knotfit/source_data.h"
namespace knotfit {

/// A node is over the data where a point is within 1.5 spacings of it, or where it lies under triangles of the points and
/// one is within 2.5 (spacing: the median circle through the corners of a triangle, over two rings about the point); never in
/// an opening (CloudMap::openings).
/// \param points  their x, y are those of the map
/// \param grid    its z is not looked at
/// \return rows x columns as Raster::z has them: 1 over the data
/// \throws InvalidInput  all points on one line
std::vector<char> grid_support(const ParameterizedPoints& points, const Raster& grid);

}  // namespace knotfit
