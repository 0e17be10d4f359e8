// The corrected parameters of the mesh's own vertices, in which none of its triangles is turned over [METHOD 8.13].
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nearest/foot_points.h"
namespace knotfit::correction {

/// The rounds keep the triangles of the holding mesh from turning over. There an edge of the mesh is a chain; here it is
/// straight.
/// \param from       parameters in which no triangle is turned over: of the map, or untangled
/// \param corrected  n x 2, of the last round
/// \return foot points, as near as the triangles that lie right in `from` allow
std::vector<double> final_parameters(std::span<const std::array<std::int32_t, 3>> faces,
                                     const std::vector<Vec3>& position, std::span<const Slide> slide,
                                     std::vector<double> from, std::vector<double> corrected,
                                     const Surface& surface);

/// Vertices of triangles that are turned over, and those around them, go towards the mean of their neighbours as far as
/// the smallest of their triangles grows, so that none is turned over that was not; what is left is laid anew in
/// patches, by mean value coordinates of `first` [Floater03].
/// \return whether every triangle that lies right in `first` does in `uv`
bool untangle(std::span<const std::array<std::int32_t, 3>> faces, std::span<const Slide> slide,
              const std::vector<double>& first, std::vector<double>& uv);

/// Moves vertices whose error at their parameters is far larger than their distance to their foot points, one by one, as
/// far as no triangle turns over or shrinks to less than a thousandth. Where a whole patch lags behind, that takes many
/// sweeps.
/// \param feet      n x 2, of the closest points; NaN: the vertex is no data and stays
/// \param distance  n, from them; any sign
/// \return vertices moved
Index approach_feet(std::span<const std::array<std::int32_t, 3>> faces, const std::vector<Vec3>& position,
                    std::span<const Slide> slide, std::span<const double> feet,
                    std::span<const double> distance, const Surface& surface, std::vector<double>& uv);

}  // namespace knotfit::correction
