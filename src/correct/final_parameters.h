// The corrected parameters of the mesh's own vertices, its own triangles none turned over.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "correct/foot_points.h"
namespace knotfit::correction {

/// The rounds keep the triangles of the holding mesh, whose edges are chains; those of the mesh itself have
/// straight ones.
/// \param first      parameters the correction began with
/// \param corrected  n x 2, of the last round
/// \return foot points as near as no triangle that lay right in `first` allows
std::vector<double> final_parameters(std::span<const std::array<std::int32_t, 3>> faces,
                                     const std::vector<Vec3>& position, std::span<const Slide> slide,
                                     const std::vector<double>& first, std::vector<double> corrected,
                                     const Surface& surface);

}  // namespace knotfit::correction
