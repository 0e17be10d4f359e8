#include "knotfit/curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "knotfit/exceptions.h"
#include "spline/contraction.h"
#include "spline/insertion.h"
#include "spline/parameter_basis.h"
namespace knotfit {
namespace {

void check(const Curve& c) {
  if (c.control_points().empty()) throw InvalidInput("the curve is empty");
}

/// sum_i B_i c_i over the functions of one span.
void blend(const Curve& c, Index span, const double* basis, double* out) {
  const double one = 1;
  contract<double>(basis, c.degree(), &one, 0,
                   c.control_points().data() + (span - c.degree()) * c.dimension(), c.dimension(),
                   c.dimension(), out);
}

}  // namespace

Curve::Curve(KnotVector knots, int dimension, std::vector<double> control_points)
    : knots_(std::move(knots)), dimension_(dimension), control_points_(std::move(control_points)) {
  if (knots_.degree() == 0) throw InvalidInput("a curve needs a knot vector; it is empty");
  if (dimension_ < 1)
    throw InvalidInput(fmt::format("a curve's dimension is {}; it must be >= 1", dimension_));
  const std::size_t wanted = static_cast<std::size_t>(size()) * static_cast<std::size_t>(dimension_);
  if (control_points_.size() != wanted)
    throw InvalidInput(
        fmt::format("the control polygon has {} numbers; {} control points of dimension {} need {}",
                    control_points_.size(), size(), dimension_, wanted));
  const auto bad = std::find_if(control_points_.begin(), control_points_.end(),
                                [](double x) { return !std::isfinite(x); });
  if (bad != control_points_.end())
    throw InvalidInput(fmt::format("control point {} has the coordinate {}; it must be finite",
                                   (bad - control_points_.begin()) / dimension_, *bad));
}

std::vector<double> evaluate_derivatives(const Curve& c, double t, int order) {
  check(c);
  if (order < 0) throw InvalidInput(fmt::format("the order of a derivative is {}; it must be >= 0", order));
  std::vector<double> result((static_cast<std::size_t>(order) + 1) * static_cast<std::size_t>(c.dimension()),
                             0.0);
  if (std::isnan(t)) {
    std::fill(result.begin(), result.end(), kNaN);
    return result;
  }
  t = clamp_to_domain(c.knots(), t);
  const Index span = c.knots().find_span(t);
  const int highest = std::min(order, c.degree());
  std::array<double, (kMaxDegree + 1) * (kMaxDegree + 1)> basis;
  basis_derivatives(c.knots(), span, t, highest, basis);
  for (int k = 0; k <= highest; ++k)
    blend(c, span, basis.data() + k * (c.degree() + 1), result.data() + k * c.dimension());
  return result;
}

std::vector<double> evaluate(const Curve& c, std::span<const double> t) {
  check(c);
  std::vector<double> result(t.size() * static_cast<std::size_t>(c.dimension()));
  parallel_chunks(static_cast<Index>(t.size()), [&](Index, Index begin, Index end) {
    for (Index k = begin; k < end; ++k) {
      double* out = result.data() + k * c.dimension();
      if (std::isnan(t[k])) {
        std::fill_n(out, c.dimension(), kNaN);
        continue;
      }
      const double x = clamp_to_domain(c.knots(), t[k]);
      const Index span = c.knots().find_span(x);
      blend(c, span, basis_row(c.knots(), span, x, 0).data(), out);
    }
  });
  return result;
}

Curve refine(const Curve& c, std::span<const double> added) {
  check(c);
  RefinedPoints r = refine_points(c.knots(), added, c.control_points(), 1, c.dimension());
  return Curve(std::move(r.knots), c.dimension(), std::move(r.points));
}

Curve insert_knot(const Curve& c, double knot) {
  return refine(c, {&knot, 1});
}

}  // namespace knotfit
