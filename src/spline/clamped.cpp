#include "spline/clamped.h"

#include <algorithm>
namespace knotfit {
namespace {

/// Rows of control points of one direction, `inner` numbers each.
struct Rows {
  int degree = 0;
  std::vector<double> knots;
  std::vector<double> points;
  Index inner = 0;
};

/// Inserts `first`, the start of the domain, until it has `degree` copies, then cuts what lies before. Only
/// convex combinations [Piegl97 A5.1].
void clamp_start(Rows& r, double first) {
  const Index p = r.degree;
  for (;;) {
    const auto [begin, end] = std::equal_range(r.knots.begin(), r.knots.end(), first);
    const Index copies = end - begin, span = end - r.knots.begin() - 1;
    if (copies >= p) break;
    std::vector<double> points(r.points.begin(), r.points.begin() + (span - p + 1) * r.inner);
    for (Index i = span - p + 1; i <= span - copies; ++i) {
      const double after = (first - r.knots[i]) / (r.knots[i + p] - r.knots[i]);
      for (Index d = 0; d < r.inner; ++d)
        points.push_back((1 - after) * r.points[(i - 1) * r.inner + d] + after * r.points[i * r.inner + d]);
    }
    points.insert(points.end(), r.points.begin() + (span - copies) * r.inner, r.points.end());
    r.points = std::move(points);
    r.knots.insert(r.knots.begin() + span + 1, first);
  }
  const Index last = std::upper_bound(r.knots.begin(), r.knots.end(), first) - r.knots.begin() - 1;
  r.points.erase(r.points.begin(), r.points.begin() + (last - p) * r.inner);
  r.knots.erase(r.knots.begin(), r.knots.begin() + (last - p));
  r.knots.front() = first;  // the outermost knot takes no part
}

void reverse(Rows& r) {
  std::reverse(r.knots.begin(), r.knots.end());
  for (double& t : r.knots) t = -t;
  const Index rows = static_cast<Index>(r.points.size()) / r.inner;
  for (Index i = 0; i < rows / 2; ++i)
    std::swap_ranges(r.points.begin() + i * r.inner, r.points.begin() + (i + 1) * r.inner,
                     r.points.begin() + (rows - 1 - i) * r.inner);
}

Surface clamped_u(const Surface& s) {
  if (s.knots_u().is_clamped()) return s;
  Rows r{s.degree_u(), s.knots_u().knots(), s.net(), s.size_v() * s.dimension()};
  clamp_start(r, s.knots_u().first());
  reverse(r);
  clamp_start(r, -s.knots_u().last());
  reverse(r);
  return Surface(KnotVector(r.degree, std::move(r.knots)), s.knots_v(), s.dimension(), std::move(r.points));
}

}  // namespace

Surface clamped(const Surface& s) {
  const Surface half = clamped_u(s);
  return half.knots_v().is_clamped() ? half : transposed(clamped_u(transposed(half)));
}

}  // namespace knotfit
