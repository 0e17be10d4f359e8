#include "search/cover.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "base/uniform_cell.h"
namespace knotfit {
namespace {

struct Node {
  bool border;
  double gap, u, v;
};

/// Marks the nodes within `radius` of a point. Bands of grid rows go in parallel: each reads the points
/// that reach it, found through the bins of the rows.
std::vector<char> near_nodes(const Neighbours& points, Index size, double radius, double border_radius) {
  const double step = 1.0 / static_cast<double>(size);
  std::vector<char> near((size + 1) * (size + 1), 0);
  std::vector<std::vector<Index>> row(size + 1);
  for (Index k = 0; k < points.size(); ++k)
    row[std::min(size, static_cast<Index>(points.x(k) * static_cast<double>(size)))].push_back(k);
  const Index reach = static_cast<Index>(std::ceil(radius / step)) + 1;
  parallel_for(size + 1, [&](Index i) {
    const double u = static_cast<double>(i) * step;
    for (Index r = std::max<Index>(0, i - reach); r <= std::min(size, i + reach); ++r)
      for (Index k : row[r]) {
        const double du = points.x(k) - u;
        auto mark = [&](double distance, bool border_only) {
          const double inside = distance * distance - du * du;
          if (inside < 0) return;
          const double dv = std::sqrt(inside);
          const Index first = std::max<Index>(0, static_cast<Index>(std::ceil((points.y(k) - dv) / step)));
          const Index last = std::min(size, static_cast<Index>(std::floor((points.y(k) + dv) / step)));
          for (Index j = first; j <= last; ++j) {
            const bool border = i == 0 || i == size || j == 0 || j == size;
            if (border == border_only) near[i * (size + 1) + j] = 1;
          }
        };
        mark(radius, false);
        mark(border_radius, true);
      }
  });
  return near;
}

}  // namespace

std::vector<std::array<double, 2>> cover_gaps(const Neighbours& points, double radius, double border_radius) {
  const double root = std::sqrt(static_cast<double>(points.size()));
  const Index size = std::max<Index>(1, static_cast<Index>(4 * root));
  const double reach = radius / root, border_reach = border_radius / root;
  const std::vector<char> near = near_nodes(points, size, reach, border_reach);
  std::vector<Node> nodes;
  for (Index i = 0; i <= size; ++i)
    for (Index j = 0; j <= size; ++j)
      if (!near[i * (size + 1) + j])
        nodes.push_back({i == 0 || i == size || j == 0 || j == size, 0,
                         static_cast<double>(i) / static_cast<double>(size),
                         static_cast<double>(j) / static_cast<double>(size)});
  parallel_chunks(
      static_cast<Index>(nodes.size()),
      [&](Index, Index begin, Index end) {
        for (Index k = begin; k < end; ++k) nodes[k].gap = points.gap(nodes[k].u, nodes[k].v);
      },
      256);
  std::stable_sort(nodes.begin(), nodes.end(), [](const Node& a, const Node& b) {
    return a.border != b.border ? a.border : a.gap > b.gap;
  });

  const Index bins = std::max<Index>(1, static_cast<Index>(1 / reach));
  std::vector<std::vector<Index>> taken(bins * bins);
  std::vector<std::array<double, 2>> places;
  for (const Node& node : nodes) {
    const double distance = node.border ? border_reach : reach;
    const Index a = uniform_cell(node.u, bins), b = uniform_cell(node.v, bins);
    bool covered = false;
    for (Index x = std::max<Index>(0, a - 1); x <= std::min(bins - 1, a + 1) && !covered; ++x)
      for (Index y = std::max<Index>(0, b - 1); y <= std::min(bins - 1, b + 1) && !covered; ++y)
        for (Index k : taken[x * bins + y])
          covered |= std::hypot(places[k][0] - node.u, places[k][1] - node.v) <= distance;
    if (covered) continue;
    taken[a * bins + b].push_back(static_cast<Index>(places.size()));
    places.push_back({node.u, node.v});
  }
  return places;
}

}  // namespace knotfit
