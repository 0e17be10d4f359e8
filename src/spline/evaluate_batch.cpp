// Many parameters at once: sorted by knot cell, then kLanes of one cell side by side.
#include <fmt/format.h>

#include <cstring>

#include "base/clones.h"
#include "base/counting_sort.h"
#include "base/narrow.h"
#include "base/parallel.h"
#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "spline/basis_lanes.h"
#include "spline/contraction.h"
#include "spline/evaluation.h"
#include "spline/parameter_basis.h"

namespace knotfit {
namespace {

constexpr Index kLeastBlock = 32768;

/// Which derivative, of which surface.
struct Task {
  const Surface& s;
  int derivative_u, derivative_v;
};

/// Points in the order of their knot cells, with their parameters clamped to the domain.
struct SortedPoints {
  std::vector<std::int32_t> order;  ///< point at each place
  std::vector<Index> cell;          ///< its cell, span_u * size_v + span_v; -1 for a NaN
  std::vector<double> uv;
};

SortedPoints sort_by_cell(const Surface& s, std::span<const double> uv) {
  const std::size_t n = uv.size() / 2;
  std::vector<std::int32_t> key(n);  // 0: a NaN
  for (std::size_t k = 0; k < n; ++k) {
    const double u = uv[2 * k], v = uv[2 * k + 1];
    if (!std::isnan(u) && !std::isnan(v))
      key[k] = narrow(1 + s.knots_u().find_span(u) * s.size_v() + s.knots_v().find_span(v));
  }
  SortedPoints sorted{{}, std::vector<Index>(n), std::vector<double>(2 * n)};
  counting_sort(key, s.control_point_count() + 1, sorted.order);
  for (std::size_t k = 0; k < n; ++k) {
    const std::int32_t from = sorted.order[k];
    sorted.cell[k] = key[from] - 1;
    sorted.uv[2 * k] = clamp_to_domain(s.knots_u(), uv[2 * from]);
    sorted.uv[2 * k + 1] = clamp_to_domain(s.knots_v(), uv[2 * from + 1]);
  }
  return sorted;
}

KNOTFIT_INLINE void lane_basis(const KnotVector& knots, Index span, const Lanes& x, int derivative,
                               Lanes* row) {
  const double* t = knots.knots().data() + span;
  const int width = knots.degree() + 1;
  if (derivative == 0) {
    basis_values(t, knots.degree(), x, row);
  } else if (derivative <= knots.degree()) {
    Lanes rows[kFunctions * kFunctions];
    basis_rows(t, knots.degree(), x, derivative, rows);
    std::copy_n(rows + derivative * width, width, row);
  } else {
    std::fill_n(row, width, Lanes{});
  }
}

/// kLanes points of one cell. \param out  dimension x kLanes, written
KNOTFIT_CLONES void evaluate_lanes(const Task& task, Index span_u, Index span_v, const double* u,
                                   const double* v, double* out) {
  const Surface& s = task.s;
  const KnotVector &ku = s.knots_u(), &kv = s.knots_v();
  Lanes x, y, bu[kFunctions], bv[kFunctions];
  std::memcpy(&x, u, sizeof x);
  std::memcpy(&y, v, sizeof y);
  lane_basis(ku, span_u, x, task.derivative_u, bu);
  lane_basis(kv, span_v, y, task.derivative_v, bv);
  const Index row = s.size_v() * s.dimension();
  const double* net = s.net().data() + (span_u - ku.degree()) * row + (span_v - kv.degree()) * s.dimension();
  contract(bu, ku.degree(), bv, kv.degree(), net, row, s.dimension(), out);
}

/// Values at uv, in the order given. \param result  n x dimension, written
void evaluate_sorted(const Task& task, std::span<const double> uv, double* result) {
  const SortedPoints sorted = sort_by_cell(task.s, uv);
  const Index end = static_cast<Index>(uv.size() / 2);
  const Index dim = task.s.dimension();
  std::vector<double> out(static_cast<std::size_t>(dim * kLanes));
  double u[kLanes], v[kLanes];
  for (Index k = 0; k < end;) {
    const Index cell = sorted.cell[k];
    Index next = k + 1;
    while (next < end && next - k < kLanes && sorted.cell[next] == cell) ++next;
    if (cell < 0) {
      for (; k < next; ++k) std::fill_n(result + Index{sorted.order[k]} * dim, dim, kNaN);
      continue;
    }
    if (next - k < kLanes / 4) {  // too few to share the work
      for (; k < next; ++k)
        evaluate_one(task.s, sorted.uv[2 * k], sorted.uv[2 * k + 1], task.derivative_u, task.derivative_v,
                     result + Index{sorted.order[k]} * dim);
      continue;
    }
    for (int l = 0; l < kLanes; ++l) {  // lanes without a point repeat the last one
      const Index from = std::min(k + l, next - 1);
      u[l] = sorted.uv[2 * from];
      v[l] = sorted.uv[2 * from + 1];
    }
    evaluate_lanes(task, cell / task.s.size_v(), cell % task.s.size_v(), u, v, out.data());
    for (int l = 0; k < next; ++k, ++l)
      for (Index d = 0; d < dim; ++d) result[Index{sorted.order[k]} * dim + d] = out[d * kLanes + l];
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
  if (n < s.control_point_count()) {  // hardly a point a cell: sorting does not pay
    parallel_chunks(n, [&](Index, Index begin, Index end) {
      for (Index k = begin; k < end; ++k)
        evaluate_one(s, uv[2 * k], uv[2 * k + 1], derivative_u, derivative_v, result.data() + k * dim);
    });
    return result;
  }
  const Task task{s, derivative_u, derivative_v};
  // Blocks that stay in the cache, yet fill the lanes of most cells.
  const Index block = std::max(kLeastBlock, 2 * kLanes * s.control_point_count());
  parallel_chunks(
      n,
      [&](Index, Index begin, Index end) {
        evaluate_sorted(task, uv.subspan(2 * begin, 2 * (end - begin)), result.data() + begin * dim);
      },
      block);
  return result;
}

}  // namespace knotfit
