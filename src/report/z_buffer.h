// Which triangle is seen at each pixel.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "knotfit/index.h"
#include "report/camera.h"
namespace knotfit::report {

using Triangle = std::array<std::int32_t, 3>;

/// Barycentric weights of a pixel's centre in a triangle, corrected for perspective.
std::array<double, 3> weights_at(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c, double x,
                                 double y);

class ZBuffer {
 public:
  /// Draws the triangles; corners in pixels, pixel (i, j) has its centre at (i + 0.5, j + 0.5).
  /// The same for any number of threads: of equally near triangles the first is kept.
  ZBuffer(int width, int height, std::span<const ScreenPoint> corners, std::span<const Triangle> triangles);
  int width() const { return width_; }
  int height() const { return height_; }
  std::int32_t triangle(int x, int y) const { return triangle_[index(x, y)]; }  ///< -1: none
  float nearness(int x, int y) const { return nearness_[index(x, y)]; }         ///< 0: none
  /// Whether a point is not behind the surface by more than `slack` (in nearness), looking also at
  /// the neighbours of its pixel: a line on a steep surface is not hidden by the surface itself.
  bool visible(const ScreenPoint& p, double slack) const;

 private:
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * width_ + x; }
  int width_, height_;
  std::vector<float> nearness_;
  std::vector<std::int32_t> triangle_;
};

}  // namespace knotfit::report
