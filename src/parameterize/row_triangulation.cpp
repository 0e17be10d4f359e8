#include "parameterize/row_triangulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "base/median.h"
#include "parameterize/cloud_gaps.h"
#include "parameterize/row_parameters.h"
namespace knotfit::cloud {
namespace {

constexpr Index kMostCells = 4'000'000;  // of a strip; on longer rows a band of pairs is looked at
constexpr double kGap = 8;  // times as long as the others: a gap in a row, or a row that is stray

double apart(std::span<const double> points, Index a, Index b) {
  return parameterize::spacing_length(&points[3 * a], &points[3 * b], RowSpacing::chord);
}

/// From the first points of two rows to their last ones: 0, a step along `a`; 1, along `b`.
std::vector<char> steps_between(std::span<const double> points, std::span<const Index> a,
                                std::span<const Index> b) {
  const auto n = static_cast<Index>(a.size()), m = static_cast<Index>(b.size());
  const Index reach = std::max(std::max(m, n) / std::min(m, n) + 64, kMostCells / (2 * n));
  const auto from = [&](Index i) { return std::max<Index>(0, i * m / n - reach); };
  const auto to = [&](Index i) { return std::min(m, i * m / n + reach + 1); };
  const Index width = std::min(m, 2 * reach + 1);
  std::vector<char> along_b(static_cast<std::size_t>(n * width), 0);
  std::vector<double> cost, before;
  for (Index i = 0; i < n; ++i) {
    cost.assign(static_cast<std::size_t>(m), std::numeric_limits<double>::infinity());
    for (Index j = from(i); j < to(i); ++j) {
      const double over_a = i > 0 ? before[j] : std::numeric_limits<double>::infinity(),
                   over_b = j > from(i) ? cost[j - 1] : std::numeric_limits<double>::infinity();
      along_b[i * width + j - from(i)] = over_b < over_a;
      cost[j] = apart(points, a[i], b[j]) + (i + j > 0 ? std::min(over_a, over_b) : 0);
    }
    before.swap(cost);
  }
  std::vector<char> steps;
  for (Index i = n - 1, j = m - 1; i + j > 0;) {
    steps.push_back(along_b[i * width + j - from(i)]);
    --(steps.back() != 0 ? j : i);
  }
  std::reverse(steps.begin(), steps.end());
  return steps;
}

/// The points of each row, but those at the place of the one before. \return nothing where v does not rise
std::vector<std::vector<Index>> rows_of(std::span<const double> uv, Index& coincident) {
  std::vector<std::vector<Index>> rows;
  const auto n = static_cast<Index>(uv.size()) / 2;
  for (Index k = 0; k < n; ++k) {
    const double u = uv[2 * k], v = uv[2 * k + 1];
    if (k == 0 || v > uv[2 * k - 1]) {
      rows.push_back({k});
      continue;
    }
    const double last = uv[2 * rows.back().back()];
    if (v < uv[2 * k - 1] || u < last) return {};
    if (u > last)
      rows.back().push_back(k);
    else
      ++coincident;
  }
  for (const auto& row : rows)
    if (row.size() < 2) return {};
  return rows;
}

/// Triangles between two rows, and the edges that lead across.
struct Strip {
  std::vector<std::array<std::int32_t, 3>> faces;
  std::vector<double> along, across;  ///< lengths: of each face's edge in a row, and of the edge it ends with

  Strip(std::span<const double> points, std::span<const Index> a, std::span<const Index> b) {
    std::size_t i = 0, j = 0;
    for (const char step : steps_between(points, a, b)) {
      const Index from = step != 0 ? b[j] : a[i], next = step != 0 ? b[j + 1] : a[i + 1];
      const auto corner = [](Index k) { return static_cast<std::int32_t>(k); };
      faces.push_back({corner(a[i]), corner(next), corner(b[j])});
      along.push_back(apart(points, from, next));
      ++(step != 0 ? j : i);
      across.push_back(apart(points, a[i], b[j]));
    }
  }
  double width() const {
    return std::accumulate(across.begin(), across.end(), 0.0) / static_cast<double>(across.size());
  }
};

/// Between each row and the next, without rows that are far from both their neighbours, which are near each other.
std::vector<Strip> strips_of(std::span<const double> points, const std::vector<std::vector<Index>>& rows,
                             std::vector<Index>& stray) {
  std::vector<Strip> all, strips;
  std::vector<double> width;
  for (std::size_t r = 1; r < rows.size(); ++r) {
    all.emplace_back(points, rows[r - 1], rows[r]);
    width.push_back(all.back().width());
  }
  const double most = kGap * median(width);
  for (std::size_t r = 1; r < rows.size(); ++r) {
    if (r + 1 < rows.size() && width[r - 1] > most && width[r] > most)
      if (Strip across(points, rows[r - 1], rows[r + 1]); across.width() <= most) {
        stray.push_back(static_cast<Index>(r));
        strips.push_back(std::move(across));
        ++r;
        continue;
      }
    strips.push_back(std::move(all[r - 1]));
  }
  return strips;
}

}  // namespace

CloudMap triangulate_rows(std::span<const double> points, std::span<const double> uv) {
  CloudMap cloud;
  const std::vector<std::vector<Index>> rows = rows_of(uv, cloud.coincident);
  if (rows.size() < 2) return {};
  cloud.points = static_cast<Index>(uv.size()) / 2;
  Mesh& mesh = cloud.mesh;
  mesh.vertices.assign(points.begin(), points.end());
  for (Index k = 0; k < cloud.points; ++k) mesh.vertex_line.push_back(k + 1);
  std::vector<char> real(static_cast<std::size_t>(cloud.points), 0);
  for (const Strip& strip : strips_of(points, rows, cloud.stray_rows)) {
    const double longest = kGap * std::max(median(strip.along), median(strip.across));
    for (std::size_t f = 0; f < strip.faces.size(); ++f) {
      const bool gap = strip.along[f] > longest;
      mesh.faces.push_back(strip.faces[f]);
      mesh.virtual_face.push_back(gap);
      if (!gap)
        for (const std::int32_t k : strip.faces[f]) real[k] = 1;
    }
  }
  cloud.lone = cloud.points - cloud.coincident - std::count(real.begin(), real.end(), 1);
  cloud.map.uv.assign(uv.begin(), uv.end());
  cloud.map.corners = {rows.front().front(), rows.front().back(), rows.back().back(), rows.back().front()};
  cloud.openings = cloud_openings(mesh, loose_points(points, real));
  measure_openings(cloud.openings, mesh, cloud.map.uv);
  cloud.covered = covered_share(mesh, cloud.map.uv, cloud.openings);
  cloud.outlined = 1;
  cloud.map.quality = measure_map(mesh, cloud.map.uv);
  return cloud;
}

}  // namespace knotfit::cloud
