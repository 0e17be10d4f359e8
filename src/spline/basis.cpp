#include "knotfit/basis.h"

#include <fmt/format.h>

#include <algorithm>

#include "knotfit/exceptions.h"
#include "spline/basis_lanes.h"
namespace knotfit {
namespace {

void check(const KnotVector& knots, Index span, std::size_t wanted, std::size_t given) {
  if (span < knots.degree() || span >= knots.size() || !(knots[span] < knots[span + 1]))
    throw InvalidInput(
        fmt::format("span {} is not a non-empty span of the domain; take it from find_span", span));
  if (given < wanted)
    throw InvalidInput(fmt::format("{} basis values do not fit into {} entries", wanted, given));
}

}  // namespace

void basis_functions(const KnotVector& knots, Index span, double x, std::span<double> values) {
  check(knots, span, static_cast<std::size_t>(knots.degree()) + 1, values.size());
  basis_values<double>(knots.knots().data() + span, knots.degree(), x, values.data());
}

void basis_derivatives(const KnotVector& knots, Index span, double x, int order, std::span<double> values) {
  if (order < 0) throw InvalidInput(fmt::format("the order of a derivative is {}; it must be >= 0", order));
  const int p = knots.degree();
  check(knots, span, (static_cast<std::size_t>(order) + 1) * static_cast<std::size_t>(p + 1), values.size());
  const Index width = p + 1;
  const int highest = std::min(order, p);
  basis_rows<double>(knots.knots().data() + span, p, x, highest, values.data());
  std::fill(values.begin() + (highest + 1) * width, values.begin() + (static_cast<Index>(order) + 1) * width,
            0.0);
}

}  // namespace knotfit
