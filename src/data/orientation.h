// Which way a triangle of the plane turns, exactly, and its area.
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

/// Twice the area of (a, b, c), up to rounding; negative: clockwise.
inline double twice_area(const double* a, const double* b, const double* c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
/// Of a triangle of a mesh at the parameters uv (n x 2).
inline double twice_area(std::span<const double> uv, const std::array<std::int32_t, 3>& t) {
  return twice_area(&uv[2 * t[0]], &uv[2 * t[1]], &uv[2 * t[2]]);
}

/// Triangles that are clockwise or flat at the parameters uv (n x 2).
Index count_flipped(std::span<const std::array<std::int32_t, 3>> faces, std::span<const double> uv);

}  // namespace knotfit
