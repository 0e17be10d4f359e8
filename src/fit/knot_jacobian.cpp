#include "fit/knot_jacobian.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>

#include "knotfit/basis.h"
#include "solve/banded.h"
#include "solve/banded_system.h"
#include "solve/degrees.h"
#include "solve/gauss_rule.h"
#include "solve/point_kernels.h"
#include "solve/spans_in_turn.h"
namespace knotfit {

std::vector<double> knot_derivatives(const Axis& axis) {
  const int m = axis.degree(), w = axis.width(), q = axis.moments();
  const Index spans = axis.spans();
  const GaussRule& rule = gauss_rule(m);
  std::vector<double> result(spans * 2 * m * w * w, 0.0), b(w);
  const std::vector<double>& t = axis.knots().knots();
  for (Index l = 0; l + 1 < spans; ++l) {  // interior knot l stands before span l + 1
    const Index k = l + m + 1;
    // dB_i/du_k = -B~_i / (u_{i+m} - u_i) + B~_{i+1} / (u_{i+1+m} - u_{i+1}), each where its function's
    // support holds u_k; B~ on the knots with u_k once more.
    std::vector<double> doubled = t;
    doubled.insert(doubled.begin() + k, t[k]);
    if (axis.knots().multiplicity(t[k]) > m) continue;  // a jump: both sides stand alone
    const KnotVector tilde(m, std::move(doubled));
    for (Index s = std::max<Index>(0, l - m + 1); s <= std::min(spans - 1, l + m); ++s) {
      if (axis.length(s) <= 0) continue;
      const Index span = s + m + (s > l ? 1 : 0);
      const Index e = l - (s - m);
      if (e < 0 || e >= 2 * m) continue;
      double* out = result.data() + (s * 2 * m + e) * w * w;
      for (int g = 0; g < q; ++g) {
        basis_functions(tilde, span, axis.low(s) + axis.length(s) * (rule.node[g] + 1) / 2, b);
        auto term = [&](Index i) {
          const Index local = i - (span - m);
          if (i < k - m || i > k || local < 0 || local > m) return 0.0;
          const double support = t[i + m] - t[i];
          return support > 0 ? b[local] / support : 0.0;
        };
        for (int i = 0; i < w; ++i) {
          const double value = term(s + i + 1) - term(s + i);
          for (int a = 0; a < w; ++a)
            out[a * w + i] += (a + 0.5) * rule.weight[g] * rule.legendre[g * q + a] * value;
        }
      }
    }
  }
  return result;
}

namespace {

template <int rows, int columns>
using ConstMap =
    Eigen::Map<const Eigen::Matrix<double, rows, columns,
                                   (rows != 1 && columns == 1) ? Eigen::ColMajor : Eigen::RowMajor>>;
template <int rows, int columns>
using Matrix = Eigen::Matrix<double, rows, columns, Eigen::RowMajor>;
static_assert(kDynamic == Eigen::Dynamic);

/// Legendre coefficients of the products P_a P_{a2 <= a}: pairs x moments.
std::vector<double> make_legendre_products(int degree) {
  const GaussRule& rule = gauss_rule(degree);
  const int w = degree + 1, q = 2 * degree + 1;
  std::vector<double> result(w * (w + 1) / 2 * q, 0.0);
  for (int g = 0; g < q; ++g) {
    const double* p = rule.legendre.data() + g * q;
    int row = 0;
    for (int a = 0; a < w; ++a)
      for (int a2 = 0; a2 <= a; ++a2, ++row)
        for (int c = 0; c < q; ++c) result[row * q + c] += (c + 0.5) * rule.weight[g] * p[c] * p[a] * p[a2];
  }
  return result;
}

const std::vector<double>& legendre_products(int degree) {
  static const auto all = [] {
    std::array<std::vector<double>, kMaxDegree + 1> products;
    for (int m = 1; m <= kMaxDegree; ++m) products[m] = make_legendre_products(m);
    return products;
  }();
  return all[degree];
}

int pair_index(int a, int b) {
  return a >= b ? a * (a + 1) / 2 + b : b * (b + 1) / 2 + a;
}

}  // namespace

namespace {

/// Sums of one outer span.
struct SpanSums {
  std::vector<double> matrix, gradient;  // knots x knots, knots
};

}  // namespace

KnotJacobian knot_jacobian(const BandedSystem& system, const std::vector<double>& net, bool golub_pereyra) {
  const Axis &outer = system.outer(), &inner = system.inner();
  const CellOrder& order = system.points();
  const bool swapped = system.swapped();
  const int d = order.dimension(), mo = outer.degree(), mi = inner.degree();
  const Index no = outer.functions(), ni = inner.functions(), n = no * ni;
  const Index ko = outer.spans() - 1, ki = inner.spans() - 1, knots = ko + ki;
  // Columns in the order outer knots, inner knots; put right at the end.
  const std::vector<double> outer_derivatives = knot_derivatives(outer),
                            inner_derivatives = knot_derivatives(inner);
  const std::vector<double>&outer_products = legendre_products(mo), &inner_products = legendre_products(mi);
  const int stride = padded(inner.moments()), coefficients = outer.width() * inner.width();
  const Index rhs_size = Index{d} * coefficients;
  const auto& start = order.piece_start();
  const auto& pieces = order.pieces();

  // Moments of w r, by piece.
  std::vector<double> residual_moments(pieces.size() * rhs_size, 0.0);
  parallel_for(static_cast<Index>(pieces.size()), [&](Index i) {
    add_rhs_moments(order, pieces[i], mo, mi, system.residual().data(),
                    residual_moments.data() + i * rhs_size);
  });

  std::vector<SpanSums> partial(outer.spans());
  Panel projected(n, knots * d), weighted(golub_pereyra ? n : 0, knots * d);  // A^T W D and, where asked, Q
  for_degrees(mo, mi, [&]<int degree>() {
    constexpr int w = width_of(degree), q = moments_of(degree), np = pairs_of(degree);
    constexpr int ww = degree < 0 ? Eigen::Dynamic : (degree + 1) * (degree + 1);
    constexpr int na = degree < 0 ? Eigen::Dynamic : 4 * degree;
    const int wo = outer.width(), wi = inner.width(), alive = 2 * mo + 2 * mi;
    const ConstMap<np, q> po(outer_products.data(), outer.pairs(), outer.moments()),
        pi(inner_products.data(), inner.pairs(), inner.moments());
    for_spans_in_turn(outer, [&](Index s) {
      SpanSums& sum = partial[s];
      sum.matrix.assign(knots * knots, 0.0);
      sum.gradient.assign(knots, 0.0);
      if (outer.length(s) <= 0) return;
      const ConstMap<w, w> bo(outer.basis(s), wo, wo);
      Matrix<w, w> c(wo, wi), left(wo, wi), right(wo, wi), y(wo, wi), z(wo, wi), r(wo, wi);
      Matrix<np, q> half(outer.pairs(), inner.moments());
      Matrix<np, np> gram(outer.pairs(), inner.pairs());
      Matrix<ww, ww> full(coefficients, coefficients);
      // A knot a row: dS/dknot as polynomials of the cell, and the Gram matrix times them.
      Matrix<na, ww> rows(alive, coefficients), image(alive, coefficients);
      Matrix<na, na> products(alive, alive);
      std::vector<Index> id(alive);
      for (int e = 0; e < 2 * mo; ++e) {
        const Index l = s - mo + e;
        id[e] = l >= 0 && l < ko ? l : -1;
      }
      for (Index t = 0; t < inner.spans(); ++t) {
        const Index cell = s * inner.spans() + t;
        if (start[cell] == start[cell + 1]) continue;
        const Eigen::Map<const Matrix<q, q>, 0, Eigen::OuterStride<>> moments(
            system.cell_moments(cell), outer.moments(), inner.moments(), Eigen::OuterStride<>(stride));
        half.noalias() = po.lazyProduct(moments);
        gram.noalias() = half.lazyProduct(pi.transpose());
        for (int a = 0; a < wo; ++a)
          for (int a2 = 0; a2 < wo; ++a2)
            for (int b = 0; b < wi; ++b)
              for (int b2 = 0; b2 < wi; ++b2)
                full(a * wi + b, a2 * wi + b2) = gram(pair_index(a, a2), pair_index(b, b2));
        for (int e = 0; e < 2 * mi; ++e) {
          const Index l = t - mi + e;
          id[2 * mo + e] = l >= 0 && l < ki ? ko + l : -1;
        }
        const ConstMap<w, w> bi(inner.basis(t), wi, wi);
        for (int x = 0; x < d; ++x) {
          for (int i = 0; i < wo; ++i)
            for (int j = 0; j < wi; ++j)
              c(i, j) = net[(swapped ? (t + j) * no + s + i : (s + i) * ni + t + j) * d + x];
          left.noalias() = c * bi.transpose();  // functions of u, powers of v
          right.noalias() = bo * c;
          r.setZero();
          for (Index p = start[cell]; p < start[cell + 1]; ++p)
            r += ConstMap<w, w>(residual_moments.data() + p * rhs_size + x * coefficients, wo, wi);
          for (int e = 0; e < alive; ++e) {
            if (id[e] < 0) {
              rows.row(e).setZero();
              continue;
            }
            const bool along_outer = e < 2 * mo;
            const ConstMap<w, w> derivative(
                along_outer ? outer_derivatives.data() + (s * 2 * mo + e) * wo * wo
                            : inner_derivatives.data() + (t * 2 * mi + e - 2 * mo) * wi * wi,
                along_outer ? wo : wi, along_outer ? wo : wi);
            if (along_outer)
              y.noalias() = derivative * left;
            else
              y.noalias() = right * derivative.transpose();
            Eigen::Map<Matrix<w, w>>(rows.data() + e * coefficients, wo, wi) = y;
            sum.gradient[id[e]] += y.cwiseProduct(r).sum();
            if (golub_pereyra) {
              if (along_outer)
                z.noalias() = derivative.transpose() * (r * bi);
              else
                z.noalias() = (bo.transpose() * r) * derivative;
              for (int i = 0; i < wo; ++i)
                for (int j = 0; j < wi; ++j) weighted((s + i) * ni + t + j, x * knots + id[e]) += z(i, j);
            }
          }
          image.noalias() = rows.lazyProduct(full);
          products.noalias() = rows.lazyProduct(image.transpose());
          for (int e = 0; e < alive; ++e) {
            if (id[e] < 0) continue;
            for (int e2 = 0; e2 < alive; ++e2)
              if (id[e2] >= 0) sum.matrix[id[e] * knots + id[e2]] += products(e, e2);
            y.noalias() = ConstMap<w, w>(image.data() + e * coefficients, wo, wi) * bi;
            z.noalias() = bo.transpose() * y;
            for (int i = 0; i < wo; ++i)
              for (int j = 0; j < wi; ++j) projected((s + i) * ni + t + j, x * knots + id[e]) += z(i, j);
          }
        }
      }
    });
  });

  std::vector<double> matrix(knots * knots, 0.0), gradient(knots, 0.0);
  for (const SpanSums& p : partial) {
    for (std::size_t i = 0; i < matrix.size(); ++i) matrix[i] += p.matrix[i];
    for (std::size_t i = 0; i < gradient.size(); ++i) gradient[i] += p.gradient[i];
  }
  system.matrix().forward(projected);
  if (golub_pereyra) system.matrix().forward(weighted);
  for (int x = 0; x < d; ++x) {
    projected.add_gram(x * knots, knots, -1, matrix.data());
    if (golub_pereyra) weighted.add_gram(x * knots, knots, 1, matrix.data());
  }

  KnotJacobian result;
  result.knots = static_cast<std::size_t>(knots);
  result.matrix.resize(knots * knots);
  result.gradient.resize(knots);
  auto place = [&](Index k) { return swapped ? (k < ko ? ki + k : k - ko) : k; };
  for (Index i = 0; i < knots; ++i) {
    result.gradient[place(i)] = gradient[i];
    for (Index j = 0; j < knots; ++j) result.matrix[place(i) * knots + place(j)] = matrix[i * knots + j];
  }
  return result;
}

}  // namespace knotfit
