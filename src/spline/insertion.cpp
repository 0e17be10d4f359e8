#include "spline/insertion.h"

#include <fmt/format.h>

#include <algorithm>

#include "knotfit/exceptions.h"
#include "knotfit/surface.h"
namespace knotfit {
namespace {

void check_added(const KnotVector& knots, std::span<const double> added) {
  int copies = 0;
  for (std::size_t k = 0; k < added.size(); ++k) {
    const double knot = added[k];
    if (!(knot > knots.first() && knot < knots.last()))
      throw InvalidInput(fmt::format("knot {} cannot be inserted: it is not inside the domain ({}, {})", knot,
                                     knots.first(), knots.last()));
    if (k > 0 && knot < added[k - 1])
      throw InvalidInput(
          fmt::format("the knots to insert are not sorted: {} comes after {}", knot, added[k - 1]));
    copies = k > 0 && knot == added[k - 1] ? copies + 1 : 1;
    const int multiplicity = knots.multiplicity(knot);
    if (multiplicity + copies > knots.degree() + 1)
      throw InvalidInput(
          fmt::format("knot {} cannot be inserted: with {} there already its multiplicity would "
                      "pass degree + 1 = {}",
                      knot, multiplicity + copies - 1, knots.degree() + 1));
  }
}

/// [Piegl97 A5.4] on one array of control points with `inner` numbers each: from the last new
/// knot to the first, each point is moved or blended once, by convex combinations only.
void refine_one(const KnotVector& knots, std::span<const double> added, const std::vector<double>& refined,
                const double* from, double* to, Index inner) {
  const Index p = knots.degree(), n = knots.size(), count = static_cast<Index>(added.size());
  const Index a = knots.find_span(added.front()), b = knots.find_span(added.back()) + 1;
  const auto copy = [&](const double* source, double* target) { std::copy_n(source, inner, target); };
  for (Index j = 0; j <= a - p; ++j) copy(from + j * inner, to + j * inner);
  for (Index j = b - 1; j < n; ++j) copy(from + j * inner, to + (j + count) * inner);
  Index i = b + p - 1, k = b + p + count - 1;
  for (Index j = count - 1; j >= 0; --j) {
    const double x = added[j];
    while (x <= knots[i] && i > a) {
      copy(from + (i - p - 1) * inner, to + (k - p - 1) * inner);
      --k;
      --i;
    }
    copy(to + (k - p) * inner, to + (k - p - 1) * inner);
    for (Index l = 1; l <= p; ++l) {
      double* point = to + (k - p + l) * inner;
      const double right = refined[k + l] - x;
      if (right == 0) {
        copy(point, point - inner);
        continue;
      }
      const double width = refined[k + l] - knots[i - p + l];
      const double before = right / width, after = (x - knots[i - p + l]) / width;
      for (Index d = 0; d < inner; ++d) point[d - inner] = before * point[d - inner] + after * point[d];
    }
    --k;
  }
}

}  // namespace

RefinedPoints refine_points(const KnotVector& knots, std::span<const double> added,
                            std::span<const double> points, Index outer, Index inner) {
  check_added(knots, added);
  if (added.empty()) return {knots, {points.begin(), points.end()}};
  const Index n = knots.size(), count = static_cast<Index>(added.size());
  std::vector<double> all(knots.knots().size() + added.size());
  std::merge(knots.knots().begin(), knots.knots().end(), added.begin(), added.end(), all.begin());
  std::vector<double> result(static_cast<std::size_t>(outer * (n + count) * inner));
  for (Index o = 0; o < outer; ++o)
    refine_one(knots, added, all, points.data() + o * n * inner, result.data() + o * (n + count) * inner,
               inner);
  return {KnotVector(knots.degree(), std::move(all)), std::move(result)};
}

Surface refine_u(const Surface& s, std::span<const double> added) {
  if (s.empty()) throw InvalidInput("the surface to refine is empty");
  RefinedPoints r = refine_points(s.knots_u(), added, s.net(), 1, s.size_v() * s.dimension());
  return Surface(std::move(r.knots), s.knots_v(), s.dimension(), std::move(r.points));
}

Surface refine_v(const Surface& s, std::span<const double> added) {
  if (s.empty()) throw InvalidInput("the surface to refine is empty");
  RefinedPoints r = refine_points(s.knots_v(), added, s.net(), s.size_u(), s.dimension());
  return Surface(s.knots_u(), std::move(r.knots), s.dimension(), std::move(r.points));
}

Surface insert_knot_u(const Surface& s, double knot) {
  return refine_u(s, {&knot, 1});
}
Surface insert_knot_v(const Surface& s, double knot) {
  return refine_v(s, {&knot, 1});
}

}  // namespace knotfit
