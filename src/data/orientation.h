// Which way a triangle of the plane turns, exactly.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "knotfit/index.h"
namespace knotfit {

/// Sign of the area of (a, b, c): 1 counter-clockwise, 0 on a line, -1 clockwise. Exact for finite
/// coordinates whose products do not underflow (magnitudes 0 or above 1e-140) or overflow.
int orientation(const double* a, const double* b, const double* c);

/// Triangles that are clockwise or flat at the parameters uv (n x 2).
Index count_flipped(std::span<const std::array<std::int32_t, 3>> faces, std::span<const double> uv);

}  // namespace knotfit
