// The corrected parameters of the mesh's own vertices, its own triangles none turned over [METHOD 8.13].
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nearest/foot_points.h"
namespace knotfit::correction {

/// The rounds keep the triangles of the holding mesh, whose edges are chains; those of the mesh itself have
/// straight ones.
/// \param from       parameters in which no triangle is turned over: those the correction began with, or untangled ones
/// \param corrected  n x 2, of the last round
/// \return foot points as near as no triangle that lies right in `from` allows
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

/// Vertices whose error at their parameters is far larger than their distance go to their foot points one by one, as far
/// as no triangle turns over, or shrinks to less than a thousandth of what it was: where a whole patch lags behind, over many sweeps.
/// \param feet      n x 2, of the closest points; NaN: no data, stays
/// \param distance  n, from them; any sign
/// \return vertices moved
Index approach_feet(std::span<const std::array<std::int32_t, 3>> faces, const std::vector<Vec3>& position,
                    std::span<const Slide> slide, std::span<const double> feet,
                    std::span<const double> distance, const Surface& surface, std::vector<double>& uv);

}  // namespace knotfit::correction
