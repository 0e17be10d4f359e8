#include "nearest/map_samples.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
namespace knotfit {

std::vector<double> centred_places(const SpanTable& t, int per_span) {
  std::vector<double> places;
  for (Index s = 0; s < t.spans(); ++s)
    for (int k = 0; k < per_span; ++k) places.push_back(t.low(s) + t.length(s) * (k + 0.5) / per_span);
  return places;
}

namespace {

/// Finds the first grid line at or above a place: buckets give the first guess.
class Lines {
 public:
  explicit Lines(const std::vector<double>& x) : x_(x), first_(x.front()) {
    const auto n = static_cast<Index>(x.size());
    per_length_ = static_cast<double>(n) / std::max(1e-300, x.back() - first_);
    bucket_.assign(static_cast<std::size_t>(n + 2), 0);
    Index k = 0;
    for (Index b = 0; b < n + 2; ++b) {
      const double at = first_ + (static_cast<double>(b) - 1e-9) / per_length_;
      while (k < n && x[k] < at) ++k;
      bucket_[b] = k;
    }
  }
  Index at_or_above(double x) const {
    if (!(x > first_)) return 0;
    const auto n = static_cast<Index>(x_.size());
    const double place = (x - first_) * per_length_;
    if (place >= static_cast<double>(n + 1)) return n;
    Index k = bucket_[static_cast<std::size_t>(place)];
    while (k < n && x_[k] < x) ++k;
    return k;
  }

 private:
  const std::vector<double>& x_;
  double first_, per_length_;
  std::vector<Index> bucket_;
};

}  // namespace

MapSamples sample_map(const MapView& map, std::vector<double> u, std::vector<double> v) {
  constexpr double rounding = 1e-12;  // of barycentric weights: a sample on an edge belongs to a triangle
  MapSamples r{std::move(u), std::move(v), {}};
  const Index nu = static_cast<Index>(r.u.size()), nv = static_cast<Index>(r.v.size());
  r.face.assign(static_cast<std::size_t>(nu * nv), -1);
  const Lines lines_u(r.u), lines_v(r.v);
  // Each thread takes a strip of the grid with all triangles that reach it, in their order.
  struct Range {
    std::int32_t face, u0, u1, v0, v1;
  };
  const auto faces = static_cast<Index>(map.faces.size());
  std::vector<std::vector<Range>> parts(static_cast<std::size_t>(chunk_count(faces)));
  parallel_chunks(faces, [&](Index c, Index begin, Index end) {
    for (Index f = begin; f < end; ++f) {
      const auto& t = map.faces[f];
      const double *a = &map.uv[2 * t[0]], *b = &map.uv[2 * t[1]], *d = &map.uv[2 * t[2]];
      const auto [u0, u1] = std::minmax({a[0], b[0], d[0]});
      const auto [v0, v1] = std::minmax({a[1], b[1], d[1]});
      const Range range{static_cast<std::int32_t>(f),
                        static_cast<std::int32_t>(lines_u.at_or_above(u0 - rounding)),
                        static_cast<std::int32_t>(lines_u.at_or_above(u1 + rounding)),
                        static_cast<std::int32_t>(lines_v.at_or_above(v0 - rounding)),
                        static_cast<std::int32_t>(lines_v.at_or_above(v1 + rounding))};
      if (range.u0 < range.u1 && range.v0 < range.v1) parts[c].push_back(range);
    }
  });
  const Index strips = std::min<Index>(16, nu);
  parallel_for(strips, [&](Index strip) {
    const auto from = static_cast<std::int32_t>(strip * nu / strips),
               to = static_cast<std::int32_t>((strip + 1) * nu / strips);
    for (const auto& part : parts)
      for (const Range& range : part) {
        const std::int32_t u0 = std::max(range.u0, from), u1 = std::min(range.u1, to);
        if (u0 >= u1) continue;
        const auto& t = map.faces[range.face];
        const double *a = &map.uv[2 * t[0]], *b = &map.uv[2 * t[1]], *d = &map.uv[2 * t[2]];
        const double bu = b[0] - a[0], bv = b[1] - a[1], du = d[0] - a[0], dv = d[1] - a[1];
        const double area = bu * dv - bv * du;
        if (std::abs(area) <= 1e-300) continue;
        for (std::int32_t i = u0; i < u1; ++i)
          for (std::int32_t j = range.v0; j < range.v1; ++j) {
            std::int32_t& face = r.face[r.index(i, j)];
            if (face >= 0) continue;
            const double x = r.u[i] - a[0], y = r.v[j] - a[1];
            const double wb = (x * dv - y * du) / area, wd = (bu * y - bv * x) / area;
            if (wb >= -rounding && wd >= -rounding && wb + wd <= 1 + rounding) face = range.face;
          }
      }
  });
  return r;
}

Vec3 MapView::normal(std::int32_t face) const {
  const auto& t = faces[face];
  return unit(cross(vertices[t[1]] - vertices[t[0]], vertices[t[2]] - vertices[t[0]]));
}

TriangleFrame triangle_frame(const MapView& map, std::int32_t face) {
  const auto& t = map.faces[face];
  const double *a = &map.uv[2 * t[0]], *b = &map.uv[2 * t[1]], *d = &map.uv[2 * t[2]];
  const double bu = b[0] - a[0], bv = b[1] - a[1], du = d[0] - a[0], dv = d[1] - a[1];
  const double inverse = 1 / (bu * dv - bv * du);
  const Vec3 p = map.vertices[t[1]] - map.vertices[t[0]], q = map.vertices[t[2]] - map.vertices[t[0]];
  return {inverse * (dv * p - bv * q), inverse * (bu * q - du * p), unit(cross(p, q))};
}

std::vector<double> window_means(std::span<const double> rows, int width, std::span<const char> use,
                                 Index n_u, Index n_v, Index reach) {
  // Sums over the window along v, then along u. The count is a last column.
  const int w = width + 1;
  std::vector<double> by_v(static_cast<std::size_t>(n_u * n_v * w), 0.0), result(rows.size(), 0.0);
  parallel_for(n_u, [&](Index i) {
    for (Index j = 0; j < n_v; ++j) {
      double* out = &by_v[(i * n_v + j) * w];
      for (Index k = std::max<Index>(0, j - reach); k <= std::min(n_v - 1, j + reach); ++k) {
        if (!use[i * n_v + k]) continue;
        for (int c = 0; c < width; ++c) out[c] += rows[(i * n_v + k) * width + c];
        out[width] += 1;
      }
    }
  });
  parallel_for(n_u, [&](Index i) {
    std::vector<double> sum(static_cast<std::size_t>(n_v * w), 0.0);
    for (Index k = std::max<Index>(0, i - reach); k <= std::min(n_u - 1, i + reach); ++k)
      for (Index x = 0; x < n_v * w; ++x) sum[x] += by_v[k * n_v * w + x];
    for (Index j = 0; j < n_v; ++j)
      if (sum[j * w + width] > 0)
        for (int c = 0; c < width; ++c)
          result[(i * n_v + j) * width + c] = sum[j * w + c] / sum[j * w + width];
  });
  return result;
}

}  // namespace knotfit
