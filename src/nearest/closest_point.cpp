#include "knotfit/closest_point.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "base/stage.h"
#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "nearest/surface_tree.h"
namespace knotfit {
namespace {

void check(const Surface& surface, std::span<const double> points, std::span<const double> start) {
  if (surface.empty()) throw InvalidInput("the surface is empty: it has no closest points");
  if (surface.dimension() != 3)
    throw InvalidInput(fmt::format(
        "closest points are of surfaces in space; this one has {} coordinate{} (height_field_in_space makes "
        "one of a height field)",
        surface.dimension(), surface.dimension() == 1 ? "" : "s"));
  if (points.size() % 3 != 0)
    throw InvalidInput(fmt::format("{} numbers are no points: three each", points.size()));
  if (!start.empty() && start.size() / 2 != points.size() / 3)
    throw InvalidInput(fmt::format("{} points have {} parameters to start from: two each, or none",
                                   points.size() / 3, start.size()));
  for (std::size_t k = 0; k < points.size(); ++k)
    if (!std::isfinite(points[k])) throw InvalidInput(fmt::format("point {} is not finite", k / 3));
  for (std::size_t k = 0; k < start.size(); ++k)
    if (!std::isfinite(start[k]))
      throw InvalidInput(fmt::format("the start of point {} is not finite", k / 2));
}

}  // namespace

ClosestPoints closest_points(const Surface& surface, std::span<const double> points,
                             std::span<const double> start, const Control& control) {
  check(surface, points, start);
  constexpr Index batch = 256;
  const Index n = static_cast<Index>(points.size() / 3);
  ClosestPoints result;
  result.uv.assign(static_cast<std::size_t>(2 * n), 0.0);
  result.distances.assign(static_cast<std::size_t>(n), std::numeric_limits<double>::infinity());
  const CellPolynomials cells(surface);
  const SurfaceTree tree(cells);
  Stage stage(control, "closest points");
  const Index turn = 64 * batch;  // points between two reports, which come from the calling thread
  for (Index from = 0; from < n && !result.stopped; from += turn) {
    const Index count = std::min(turn, n - from);
    parallel_chunks(
        count,
        [&](Index, Index begin, Index end) {
          for (Index k = from + begin; k < from + end; ++k) {
            double near[2];
            if (!start.empty()) {
              near[0] = std::clamp(start[2 * k], cells.u().first(), cells.u().last());
              near[1] = std::clamp(start[2 * k + 1], cells.v().first(), cells.v().last());
            }
            const SurfaceTree::Closest c = tree.closest(at(&points[3 * k]), start.empty() ? nullptr : near);
            result.uv[2 * k] = c.u;
            result.uv[2 * k + 1] = c.v;
            result.distances[k] = std::sqrt(c.squared);
          }
        },
        batch);
    result.stopped =
        stage.report(static_cast<double>(from + count) / static_cast<double>(n)) && from + count < n;
  }
  // The points are those of evaluate(), to the last bit.
  result.points = evaluate(surface, result.uv);
  for (Index k = 0; k < n; ++k)
    if (std::isfinite(result.distances[k]))
      result.distances[k] = length(at(&result.points[3 * k]) - at(&points[3 * k]));
  return result;
}

ClosestPoint closest_point(const Surface& surface, const std::array<double, 3>& point) {
  const ClosestPoints c = closest_points(surface, point);
  return {c.uv[0], c.uv[1], {c.points[0], c.points[1], c.points[2]}, c.distances[0]};
}

}  // namespace knotfit
