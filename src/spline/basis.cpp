#include "knotfit/basis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "knotfit/errors.h"
#include "spline/basis_lanes.h"
namespace knotfit {
namespace {

constexpr int kFunctions = kMaxDegree + 1;

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
  basis_lanes<1>(knots.knots().data() + span, knots.degree(), &x, values.data());
}

void basis_derivatives(const KnotVector& knots, Index span, double x, int order, std::span<double> values) {
  if (order < 0) throw InvalidInput(fmt::format("the order of a derivative is {}; it must be >= 0", order));
  const int p = knots.degree();
  check(knots, span, (static_cast<std::size_t>(order) + 1) * static_cast<std::size_t>(p + 1), values.size());
  std::fill(values.begin(), values.begin() + (static_cast<Index>(order) + 1) * (p + 1), 0.0);

  // ndu: functions of every degree above the diagonal, knot differences below [Piegl97 A2.3].
  std::array<std::array<double, kFunctions>, kFunctions> ndu;
  std::array<double, kFunctions> left, right;
  ndu[0][0] = 1;
  for (int j = 1; j <= p; ++j) {
    left[j] = x - knots[span + 1 - j];
    right[j] = knots[span + j] - x;
    double saved = 0;
    for (int r = 0; r < j; ++r) {
      ndu[j][r] = right[r + 1] + left[j - r];
      const double whole = ndu[r][j - 1], part = whole / ndu[j][r];  // as in basis_lanes
      ndu[r][j] = saved + (left[j - r] == 0 ? whole : right[r + 1] * part);
      saved = right[r + 1] == 0 ? whole : left[j - r] * part;
    }
    ndu[j][j] = saved;
  }
  for (int j = 0; j <= p; ++j) values[j] = ndu[j][p];

  const int highest = std::min(order, p);
  std::array<std::array<double, kFunctions>, 2> a;
  for (int r = 0; r <= p; ++r) {
    int from = 0, to = 1;
    a[0][0] = 1;
    double factor = p;  // p! / (p - k)!
    for (int k = 1; k <= highest; ++k) {
      const int rk = r - k, pk = p - k;
      double d = 0;
      if (r >= k) {
        a[to][0] = a[from][0] / ndu[pk + 1][rk];
        d = a[to][0] * ndu[rk][pk];
      }
      const int j_first = rk >= -1 ? 1 : -rk;
      const int j_last = r - 1 <= pk ? k - 1 : p - r;
      for (int j = j_first; j <= j_last; ++j) {
        a[to][j] = (a[from][j] - a[from][j - 1]) / ndu[pk + 1][rk + j];
        d += a[to][j] * ndu[rk + j][pk];
      }
      if (r <= pk) {
        a[to][k] = -a[from][k - 1] / ndu[pk + 1][r];
        d += a[to][k] * ndu[r][pk];
      }
      values[k * (p + 1) + r] = d * factor;
      factor *= pk;
      std::swap(from, to);
    }
  }
}

}  // namespace knotfit
