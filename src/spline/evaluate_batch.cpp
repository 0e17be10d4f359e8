// Many parameters at once: sorted by knot cell, then kLanes of one cell side by side.
#include <fmt/format.h>

#include <limits>

#include "base/parallel.h"
#include "knotfit/errors.h"
#include "knotfit/evaluate.h"
#include "spline/basis_lanes.h"
#include "spline/contraction.h"
#include "spline/evaluation.h"
#include "spline/parameter_basis.h"
namespace knotfit {
namespace {

constexpr int kLanes = 8;

/// Points in the order of their knot cells.
struct SortedPoints {
  std::vector<Index> order;  ///< point at each place
  std::vector<Index> cell;   ///< cell of each point, span_u * size_v + span_v; -1 for a NaN
};

SortedPoints sort_by_cell(const Surface& s, std::span<const double> uv) {
  const Index n = static_cast<Index>(uv.size() / 2), cells = s.control_point_count();
  SortedPoints sorted;
  sorted.cell.resize(static_cast<std::size_t>(n));
  parallel_chunks(n, [&](Index, Index begin, Index end) {
    for (Index k = begin; k < end; ++k) {
      const double u = uv[2 * k], v = uv[2 * k + 1];
      sorted.cell[k] = std::isnan(u) || std::isnan(v)
                           ? -1
                           : s.knots_u().find_span(u) * s.size_v() + s.knots_v().find_span(v);
    }
  });
  std::vector<Index> place(static_cast<std::size_t>(cells) + 2, 0);  // counting sort, NaN first
  for (Index cell : sorted.cell) ++place[cell + 2];
  for (std::size_t c = 2; c < place.size(); ++c) place[c] += place[c - 1];
  sorted.order.resize(static_cast<std::size_t>(n));
  for (Index k = 0; k < n; ++k) sorted.order[place[sorted.cell[k] + 1]++] = k;
  return sorted;
}

void basis_of_lanes(const KnotVector& knots, Index span, const double* x, int derivative, double* values) {
  if (derivative == 0) {
    basis_lanes<kLanes>(knots.knots().data() + span, knots.degree(), x, values);
    return;
  }
  for (int l = 0; l < kLanes; ++l) {
    const BasisRow row = basis_row(knots, span, x[l], derivative);
    for (int a = 0; a <= knots.degree(); ++a) values[a * kLanes + l] = row[static_cast<std::size_t>(a)];
  }
}

}  // namespace

std::vector<double> evaluate(const Surface& s, std::span<const double> uv, int derivative_u,
                             int derivative_v) {
  check_evaluation(s, derivative_u, derivative_v);
  if (uv.size() % 2 != 0)
    throw InvalidInput(fmt::format("parameters come in pairs (u, v); there are {} numbers", uv.size()));
  const Index n = static_cast<Index>(uv.size() / 2), dim = s.dimension();
  std::vector<double> result(static_cast<std::size_t>(n * dim));
  if (n < s.control_point_count() / 4) {  // cells with hardly two points: sorting does not pay
    parallel_chunks(n, [&](Index, Index begin, Index end) {
      for (Index k = begin; k < end; ++k)
        evaluate_one(s, uv[2 * k], uv[2 * k + 1], derivative_u, derivative_v, result.data() + k * dim);
    });
    return result;
  }
  const SortedPoints sorted = sort_by_cell(s, uv);
  const KnotVector &ku = s.knots_u(), &kv = s.knots_v();
  parallel_chunks(n, [&](Index, Index begin, Index end) {
    double u[kLanes], v[kLanes], bu[(kMaxDegree + 1) * kLanes], bv[(kMaxDegree + 1) * kLanes];
    std::vector<double> out(static_cast<std::size_t>(dim * kLanes));
    for (Index k = begin; k < end;) {
      const Index cell = sorted.cell[sorted.order[k]];
      Index next = k + 1;
      while (next < end && next - k < kLanes && sorted.cell[sorted.order[next]] == cell) ++next;
      if (cell < 0 || next - k < kLanes / 4) {
        for (; k < next; ++k) {
          const Index point = sorted.order[k];
          evaluate_one(s, uv[2 * point], uv[2 * point + 1], derivative_u, derivative_v,
                       result.data() + point * dim);
        }
        continue;
      }
      for (int l = 0; l < kLanes; ++l) {  // lanes without a point repeat the last one
        const Index point = sorted.order[std::min(k + l, next - 1)];
        u[l] = clamp_to_domain(ku, uv[2 * point]);
        v[l] = clamp_to_domain(kv, uv[2 * point + 1]);
      }
      const Index i = cell / s.size_v(), j = cell % s.size_v();
      basis_of_lanes(ku, i, u, derivative_u, bu);
      basis_of_lanes(kv, j, v, derivative_v, bv);
      contract<kLanes>(bu, ku.degree(), bv, kv.degree(),
                       s.control_point(i - ku.degree(), j - kv.degree()).data(), s.size_v() * dim,
                       s.dimension(), out.data());
      for (int l = 0; k < next; ++k, ++l)
        for (Index d = 0; d < dim; ++d) result[sorted.order[k] * dim + d] = out[d * kLanes + l];
    }
  });
  return result;
}

}  // namespace knotfit
