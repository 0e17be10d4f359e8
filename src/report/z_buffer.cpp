#include "report/z_buffer.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
namespace knotfit::report {
namespace {
constexpr int kBand = 32;  // rows a task

double side(double ax, double ay, double bx, double by, double x, double y) {
  return (bx - ax) * (y - ay) - (by - ay) * (x - ax);
}
}  // namespace

std::array<double, 3> weights_at(const ScreenPoint& a, const ScreenPoint& b, const ScreenPoint& c, double x,
                                 double y) {
  std::array<double, 3> w{side(b.x, b.y, c.x, c.y, x, y) * a.nearness,
                          side(c.x, c.y, a.x, a.y, x, y) * b.nearness,
                          side(a.x, a.y, b.x, b.y, x, y) * c.nearness};
  const double sum = w[0] + w[1] + w[2];
  if (sum == 0 || !std::isfinite(sum)) return {1, 0, 0};
  for (double& x_k : w) x_k = std::clamp(x_k / sum, 0.0, 1.0);
  return w;
}

ZBuffer::ZBuffer(int width, int height, std::span<const ScreenPoint> p, std::span<const Triangle> triangles)
    : width_(width),
      height_(height),
      nearness_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0.0f),
      triangle_(nearness_.size(), -1) {
  const int bands = (height + kBand - 1) / kBand;
  // Triangles of each band of rows, in their order.
  auto band_range = [&](const Triangle& t) {
    const double top = std::min({p[t[0]].y, p[t[1]].y, p[t[2]].y});
    const double bottom = std::max({p[t[0]].y, p[t[1]].y, p[t[2]].y});
    if (!(bottom >= 0.0 && top <= height)) return std::pair(0, -1);
    return std::pair(static_cast<int>(std::max(top, 0.0)) / kBand,
                     std::min(static_cast<int>(std::min(bottom, height - 1.0)) / kBand, bands - 1));
  };
  std::vector<std::size_t> start(static_cast<std::size_t>(bands) + 1, 0);
  for (const Triangle& t : triangles) {
    const auto [first, last] = band_range(t);
    for (int b = first; b <= last; ++b) ++start[b + 1];
  }
  for (int b = 0; b < bands; ++b) start[b + 1] += start[b];
  std::vector<std::int32_t> list(start.back());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for (std::size_t k = 0; k < triangles.size(); ++k) {
    const auto [first, last] = band_range(triangles[k]);
    for (int b = first; b <= last; ++b) list[next[b]++] = static_cast<std::int32_t>(k);
  }

  parallel_for(bands, [&](Index band) {
    const int row_begin = static_cast<int>(band) * kBand, row_end = std::min(height_, row_begin + kBand);
    for (std::size_t at = start[band]; at < start[band + 1]; ++at) {
      const Triangle& t = triangles[list[at]];
      const ScreenPoint &a = p[t[0]], &b = p[t[1]], &c = p[t[2]];
      const double area = side(a.x, a.y, b.x, b.y, c.x, c.y);
      if (area == 0 || !std::isfinite(area)) continue;
      const int x0 =
          static_cast<int>(std::clamp(std::floor(std::min({a.x, b.x, c.x}) - 0.5), 0.0, width_ - 1.0));
      const int x1 =
          static_cast<int>(std::clamp(std::ceil(std::max({a.x, b.x, c.x}) - 0.5), 0.0, width_ - 1.0));
      const int y0 = static_cast<int>(std::clamp(std::floor(std::min({a.y, b.y, c.y}) - 0.5),
                                                 static_cast<double>(row_begin), row_end - 1.0));
      const int y1 = static_cast<int>(std::clamp(std::ceil(std::max({a.y, b.y, c.y}) - 0.5),
                                                 static_cast<double>(row_begin), row_end - 1.0));
      const double inverse = 1 / area;
      for (int y = y0; y <= y1; ++y)
        for (int x = x0; x <= x1; ++x) {
          const double px = x + 0.5, py = y + 0.5;
          const double wa = side(b.x, b.y, c.x, c.y, px, py) * inverse;
          const double wb = side(c.x, c.y, a.x, a.y, px, py) * inverse;
          const double wc = 1 - wa - wb;
          constexpr double kEdge = -1e-9;  // both triangles of an edge take it: no cracks
          if (wa < kEdge || wb < kEdge || wc < kEdge) continue;
          const float near = static_cast<float>(wa * a.nearness + wb * b.nearness + wc * c.nearness);
          const std::size_t k = index(x, y);
          if (near > nearness_[k]) {
            nearness_[k] = near;
            triangle_[k] = list[at];
          }
        }
    }
  });
}

bool ZBuffer::visible(const ScreenPoint& p, double slack) const {
  const double column = std::floor(p.x), row = std::floor(p.y);
  if (!(column >= -1 && column <= width_ && row >= -1 && row <= height_)) return true;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const int x = static_cast<int>(column) + dx, y = static_cast<int>(row) + dy;
      if (x < 0 || x >= width_ || y < 0 || y >= height_) return true;
      if (p.nearness + slack >= nearness_[index(x, y)]) return true;
    }
  return false;
}

}  // namespace knotfit::report
