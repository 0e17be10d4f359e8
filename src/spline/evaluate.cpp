#include "knotfit/evaluate.h"

#include <fmt/format.h>

#include "base/parallel.h"
#include "knotfit/exceptions.h"
#include "spline/contraction.h"
#include "spline/evaluation.h"
#include "spline/parameter_basis.h"
namespace knotfit {

void check_evaluation(const Surface& s, int derivative_u, int derivative_v) {
  if (s.empty()) throw InvalidInput("the surface to evaluate is empty");
  if (derivative_u < 0 || derivative_v < 0)
    throw InvalidInput(
        fmt::format("derivative ({}, {}) asked for; orders must be >= 0", derivative_u, derivative_v));
}

void evaluate_one(const Surface& s, double u, double v, int derivative_u, int derivative_v, double* out) {
  const KnotVector &ku = s.knots_u(), &kv = s.knots_v();
  if (std::isnan(u) || std::isnan(v)) {  // a derivative of order degree would not see it
    std::fill_n(out, s.dimension(), kNaN);
    return;
  }
  u = clamp_to_domain(ku, u);
  v = clamp_to_domain(kv, v);
  const Index i = ku.find_span(u), j = kv.find_span(v);
  const BasisRow bu = basis_row(ku, i, u, derivative_u), bv = basis_row(kv, j, v, derivative_v);
  contract<double>(bu.data(), ku.degree(), bv.data(), kv.degree(),
                   s.control_point(i - ku.degree(), j - kv.degree()).data(), s.size_v() * s.dimension(),
                   s.dimension(), out);
}

void evaluate(const Surface& s, double u, double v, std::span<double> out) {
  check_evaluation(s, 0, 0);
  if (out.size() < static_cast<std::size_t>(s.dimension()))
    throw InvalidInput(
        fmt::format("a point of dimension {} does not fit into {} numbers", s.dimension(), out.size()));
  evaluate_one(s, u, v, 0, 0, out.data());
}

std::vector<double> evaluate_derivatives(const Surface& s, double u, double v, int order) {
  check_evaluation(s, order, order);
  const KnotVector &ku = s.knots_u(), &kv = s.knots_v();
  const std::size_t side = static_cast<std::size_t>(order) + 1, dim = static_cast<std::size_t>(s.dimension());
  std::vector<double> result(side * side * dim, 0.0);
  const auto entry = [&](int a, int b) {
    return result.data() + (a * static_cast<Index>(side) + b) * s.dimension();
  };
  if (std::isnan(u) || std::isnan(v)) {
    for (int a = 0; a <= order; ++a) std::fill_n(entry(a, 0), (order - a + 1) * s.dimension(), kNaN);
    return result;
  }
  u = clamp_to_domain(ku, u);
  v = clamp_to_domain(kv, v);
  const Index i = ku.find_span(u), j = kv.find_span(v);
  const int p = ku.degree(), q = kv.degree(), order_u = std::min(order, p), order_v = std::min(order, q);
  std::array<double, (kMaxDegree + 1) * (kMaxDegree + 1)> bu, bv;
  basis_derivatives(ku, i, u, order_u, bu);
  basis_derivatives(kv, j, v, order_v, bv);
  const double* net = s.control_point(i - p, j - q).data();
  for (int a = 0; a <= order_u; ++a)
    for (int b = 0; b <= std::min(order - a, order_v); ++b)
      contract<double>(bu.data() + a * (p + 1), p, bv.data() + b * (q + 1), q, net,
                       s.size_v() * s.dimension(), s.dimension(), entry(a, b));
  return result;
}

namespace {

/// The basis rows of many parameters of one direction. A NaN has a row of NaN.
struct BasisTable {
  std::vector<Index> first;  ///< first function of each row
  std::vector<BasisRow> rows;
};

BasisTable basis_table(const KnotVector& knots, std::span<const double> x, int derivative) {
  BasisTable table;
  table.first.reserve(x.size());
  table.rows.reserve(x.size());
  for (double value : x) {
    const double inside = clamp_to_domain(knots, value);
    const Index span = knots.find_span(inside);
    table.first.push_back(span - knots.degree());
    table.rows.push_back(basis_row(knots, span, inside, derivative));
    if (std::isnan(value)) table.rows.back().fill(kNaN);
  }
  return table;
}

}  // namespace

std::vector<double> evaluate_grid(const Surface& s, std::span<const double> u, std::span<const double> v,
                                  int derivative_u, int derivative_v) {
  check_evaluation(s, derivative_u, derivative_v);
  const BasisTable bu = basis_table(s.knots_u(), u, derivative_u),
                   bv = basis_table(s.knots_v(), v, derivative_v);
  const Index dim = s.dimension(), row = static_cast<Index>(v.size()) * dim, net_row = s.size_v() * dim;
  // First v, for every row of the net that some u needs: the inner sums of contraction.h.
  std::vector<char> needed(static_cast<std::size_t>(s.size_u()), 0);
  for (Index first : bu.first) std::fill_n(needed.begin() + first, s.degree_u() + 1, 1);
  std::vector<double> half(static_cast<std::size_t>(s.size_u() * row), 0.0);
  parallel_for(s.size_u(), [&](Index i) {
    if (!needed[static_cast<std::size_t>(i)]) return;
    double* to = half.data() + i * row;
    for (std::size_t l = 0; l < v.size(); ++l, to += dim) {
      const double* c = s.net().data() + i * net_row + bv.first[l] * dim;
      for (int b = 0; b <= s.degree_v(); ++b)
        for (Index d = 0; d < dim; ++d) to[d] += bv.rows[l][static_cast<std::size_t>(b)] * *c++;
    }
  });
  std::vector<double> result(u.size() * static_cast<std::size_t>(row), 0.0);
  parallel_for(static_cast<Index>(u.size()), [&](Index k) {
    double* to = result.data() + k * row;
    for (int a = 0; a <= s.degree_u(); ++a) {
      const double weight = bu.rows[static_cast<std::size_t>(k)][static_cast<std::size_t>(a)];
      const double* from = half.data() + (bu.first[static_cast<std::size_t>(k)] + a) * row;
      for (Index l = 0; l < row; ++l) to[l] += weight * from[l];
    }
  });
  return result;
}

}  // namespace knotfit
