#include "correct/tangent_system.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "base/counting_sort.h"
#include "correct/block_moments.h"
#include "knotfit/basis.h"
#include "solve/gram_entries.h"
#include "solve/smoothing_floor.h"
#include "solve/spans_in_turn.h"
#include "solve/thin_plate.h"
namespace knotfit::correction {
namespace {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using ConstMap = Eigen::Map<const RowMatrix>;

/// Points in the order of their cells: outer span, then inner span.
struct Order {
  std::vector<std::int32_t> point;
  std::vector<Index> start;  ///< by cell
};

Order sort_cells(std::span<const double> uv, const Axis& outer, const Axis& inner, bool swapped) {
  std::vector<std::int32_t> cell;
  for (std::size_t k = 0; k < uv.size(); k += 2)
    cell.push_back(static_cast<std::int32_t>(outer.span(uv[k + swapped]) * inner.spans() +
                                             inner.span(uv[k + 1 - swapped])));
  Order order;
  order.start = counting_sort(cell, outer.spans() * inner.spans(), order.point);
  return order;
}

/// Basis functions and their derivatives at one place of one direction.
struct Derivatives {
  Index first = 0;  ///< function alive there
  int width;
  std::array<double, 3 * (kMaxDegree + 1)> row{};
  Derivatives(const KnotVector& knots, double x, int order) : width(knots.degree() + 1) {
    const Index span = knots.find_span(x);
    first = span - knots.degree();
    basis_derivatives(knots, span, x, order, row);
  }
  double operator()(int derivative, int function) const { return row[derivative * width + function]; }
};

/// The functions alive at a place, by the number they have in the system, with `kinds` factors each.
template <std::size_t kinds>
struct Pattern {
  int count = 0;
  std::array<Index, (kMaxDegree + 1) * (kMaxDegree + 1)> id;
  std::array<std::array<double, kinds>, (kMaxDegree + 1) * (kMaxDegree + 1)> f;

  /// \param number   of a function, from its numbers in u and v
  /// \param factors  std::array<double, kinds>(i, j), of the i-th and j-th function alive
  template <class Number, class Factors>
  Pattern(const Derivatives& u, const Derivatives& v, const Number& number, const Factors& factors) {
    for (int i = 0; i < u.width; ++i)
      for (int j = 0; j < v.width; ++j, ++count) {
        id[count] = number(u.first + i, v.first + j);
        f[count] = factors(i, j);
      }
  }
};

/// Adds sum_k weight_k (n . sum_x f_xk P_x - target_k)^2, P_x the control points, to a matrix of blocks.
/// \param product  (d, a, b): d sum_k a_k b_k, d a coordinate of n
template <std::size_t kinds, class Product>
void add_along(const Vec3& n, const Pattern<kinds>& at, const std::array<double, kinds>& weight,
               const std::array<double, kinds>& target, const Product& product, BandMatrix& matrix,
               std::vector<double>& rhs) {
  const double direction[3] = {n.x, n.y, n.z};
  for (int x = 0; x < at.count; ++x) {
    std::array<double, kinds> weighted;
    double right = 0;
    for (std::size_t k = 0; k < kinds; ++k)
      weighted[k] = weight[k] * at.f[x][k], right += weighted[k] * target[k];
    for (int c = 0; c < 3; ++c) {
      const Index column = 3 * at.id[x] + c;
      rhs[column] += right * direction[c];
      double* out = matrix.column(column) - column;
      for (int y = 0; y < at.count; ++y) {
        const double w = product(direction[c], weighted, at.f[y]);
        for (int d = 0; d < 3; ++d)
          if (const Index row = 3 * at.id[y] + d; row >= column) out[row] += w * direction[d];
      }
    }
  }
}

}  // namespace

TangentSystem::TangentSystem(const KnotVector& u, const KnotVector& v, double aspect)
    : knots_u_(u), knots_v_(v), u_(u.degree(), u.interior()), v_(v.degree(), v.interior()) {
  swapped_ = v_.functions() > u_.functions();
  const Axis &outer = swapped_ ? v_ : u_, &inner = swapped_ ? u_ : v_;
  const Index ni = inner.functions();
  energy_.reset(outer.functions() * ni, outer.degree() * ni + inner.degree());
  // x = aspect u, y = v up to a common factor.
  const double p = 1 / (aspect * aspect);
  each_energy_entry(
      EnergyGrams(outer), EnergyGrams(inner),
      [&](Index row, Index column, double entry) { energy_.add(row, column, entry); }, swapped_ ? 1 : p,
      swapped_ ? p : 1);
}

void TangentSystem::add_points(const SystemPoints& points, Sum& sum) const {
  BandMatrix& matrix = sum.matrix;
  const int block = sum.block;
  const Axis &outer = swapped_ ? v_ : u_, &inner = swapped_ ? u_ : v_;
  const Order order = sort_cells(points.uv, outer, inner, swapped_);
  const int qo = outer.moments(), qi = inner.moments(), wo = outer.width(), wi = inner.width();
  const int parts = block == 1 ? 1 : 6;
  const Index ni = inner.functions(), size = outer.functions() * ni;
  const int stride = padded_moments(qi);
  std::vector<double> trace(static_cast<std::size_t>(outer.spans()), 0.0);
  for_spans_in_turn(outer, [&](Index s) {
    const ConstMap po(outer.products(s), outer.pairs(), qo);
    std::vector<double> moments(static_cast<std::size_t>(parts * qo * stride)),
        right(static_cast<std::size_t>(3 * wo * wi));
    RowMatrix gram[6], half;
    std::vector<BlockPoint> cell;
    for (Index r = 0; r < inner.spans(); ++r) {
      const Index c = s * inner.spans() + r, begin = order.start[c], end = order.start[c + 1];
      if (begin == end) continue;
      cell.clear();
      for (Index k = begin; k < end; ++k) {
        const std::int32_t i = order.point[k];
        const Sym3 m = points.matrix.empty() ? Sym3{} : points.matrix[i];
        const double w = points.weight[i];
        cell.push_back({outer.local(s, points.uv[2 * i + swapped_]),
                        inner.local(r, points.uv[2 * i + 1 - swapped_]),
                        {w * m.xx, w * m.xy, w * m.xz, w * m.yy, w * m.yz, w * m.zz},
                        {},
                        w});
        const Vec3 p = w * (m * points.point[i]);
        cell.back().rhs[0] = p.x, cell.back().rhs[1] = p.y, cell.back().rhs[2] = p.z;
      }
      std::fill(moments.begin(), moments.end(), 0.0);
      std::fill(right.begin(), right.end(), 0.0);
      trace[s] += add_block_moments(cell, outer.degree(), inner.degree(), outer.basis(s), inner.basis(r),
                                    parts, moments.data(), right.data());
      const ConstMap pi(inner.products(r), inner.pairs(), qi);
      for (int part = 0; part < parts; ++part) {
        const Eigen::Map<const RowMatrix, 0, Eigen::OuterStride<>> m(moments.data() + part * qo * stride, qo,
                                                                     qi, Eigen::OuterStride<>(stride));
        half.noalias() = po * m;
        gram[part].noalias() = half * pi.transpose();
      }
      each_gram_entry({s, r, wo, wi, ni}, [&](Index x, Index y, int row, int column) {
        if (block == 1) {
          matrix.add(x, y, gram[0](row, column));
          return;
        }
        const double g[6] = {gram[0](row, column), gram[1](row, column), gram[2](row, column),
                             gram[3](row, column), gram[4](row, column), gram[5](row, column)};
        double *c0 = matrix.column(3 * y), *c1 = matrix.column(3 * y + 1), *c2 = matrix.column(3 * y + 2);
        const Index d = 3 * (x - y);
        c0[d] += g[0], c0[d + 1] += g[1], c0[d + 2] += g[2];
        if (d > 0) c1[d - 1] += g[1], c2[d - 2] += g[2], c2[d - 1] += g[4];
        c1[d] += g[3], c1[d + 1] += g[4];
        c2[d] += g[5];
      });
      for (int i = 0; i < wo; ++i)
        for (int j = 0; j < wi; ++j)
          for (int d = 0; d < 3; ++d) {
            const Index x = (s + i) * ni + r + j;
            sum.rhs[block == 1 ? d * size + x : 3 * x + d] += right[(d * wo + i) * wi + j];
          }
    }
  });
  for (const double t : trace) sum.trace += t;
}

void TangentSystem::add_gradient(std::span<const GradientDatum> data, Sum& sum) const {
  const Index size = sum.scalar.size();
  for (const GradientDatum& g : data) {
    const Derivatives u(knots_u_, g.u, 1), v(knots_v_, g.v, 1);
    const Pattern<2> at(u, v, numbers(), [&](int i, int j) {
      return std::array{u(1, i) * v(0, j), u(0, i) * v(1, j)};
    });
    for (int x = 0; x < at.count; ++x) {
      const double fu = g.weight_u * at.f[x][0], fv = g.weight_v * at.f[x][1];
      const Vec3 r = fu * g.xu + fv * g.xv;
      const Index k = at.id[x];
      const double value[3] = {r.x, r.y, r.z};
      for (int d = 0; d < 3; ++d) sum.rhs[sum.block == 1 ? d * size + k : 3 * k + d] += value[d];
      double* column = sum.scalar.column(k) - k;
      for (int y = 0; y < at.count; ++y)
        if (at.id[y] >= k) column[at.id[y]] += fu * at.f[y][0] + fv * at.f[y][1];
    }
  }
}

void TangentSystem::add_hinge(std::span<const HingeRow> rows, Sum& sum) const {
  for (const HingeRow& h : rows) {
    const Derivatives u(knots_u_, h.u, 1), v(knots_v_, h.v, 1);
    const Pattern<1> at(u, v, numbers(), [&](int i, int j) {
      return std::array{h.a * u(1, i) * v(0, j) + h.b * u(0, i) * v(1, j)};
    });
    add_along(
        h.y, at, {h.weight}, {h.target},
        [](double d, const auto& a, const auto& b) { return a[0] * d * b[0]; }, sum.matrix, sum.rhs);
  }
}

void TangentSystem::add_curvature(std::span<const CurvatureDatum> data, Sum& sum) const {
  for (const CurvatureDatum& g : data) {
    const Derivatives u(knots_u_, g.u, 2), v(knots_v_, g.v, 2);
    const Pattern<3> at(u, v, numbers(), [&](int i, int j) {
      return std::array{u(2, i) * v(0, j), u(1, i) * v(1, j), u(0, i) * v(2, j)};
    });
    add_along(
        g.n, at, g.weight, g.target,
        [](double d, const auto& a, const auto& b) { return d * (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]); },
        sum.matrix, sum.rhs);
  }
}

TangentSystem::Sum TangentSystem::summed(const SystemPoints& points, const Holding& holding) const {
  const int block = points.matrix.empty() ? 1 : 3;
  const Index size = energy_.size(), band = energy_.bandwidth();
  Sum sum{block, BandMatrix(block * size, block == 1 ? band : 3 * band + 2), BandMatrix(size, band),
          std::vector<double>(static_cast<std::size_t>(3 * size), 0.0), 0};
  add_points(points, sum);
  add_gradient(holding.gradient, sum);
  if (block == 3) {
    add_hinge(holding.hinge, sum);
    add_curvature(holding.curvature, sum);
  }
  return sum;
}

std::optional<BandMatrix> TangentSystem::factored(const Sum& sum, double smoothing) const {
  const double energy_trace = energy_.trace(),
               lambda = energy_trace > 0 ? smoothing * sum.trace / energy_trace : 0;
  BandMatrix whole = sum.matrix;
  const Index size = energy_.size(), band = energy_.bandwidth();
  for (Index k = 0; k < size; ++k) {
    const double *e = energy_.column(k), *g = sum.scalar.column(k);
    for (Index d = 0; d <= std::min(band, size - 1 - k); ++d) {
      const double x = lambda * e[d] + g[d];
      if (x == 0) continue;
      for (Index c = 0; c < sum.block; ++c) whole.add(sum.block * (k + d) + c, sum.block * k + c, x);
    }
  }
  if (!whole.factor()) return std::nullopt;
  return whole;
}

std::optional<Surface> TangentSystem::solve(const SystemPoints& points, double smoothing,
                                            const Holding& holding) const {
  const Sum sum = summed(points, holding);
  const Index size = energy_.size();
  std::vector<double> x;
  const bool solved = with_smoothing_floor(smoothing, [&](double floor) {
    const std::optional<BandMatrix> factor = factored(sum, floor);
    if (!factor) return false;
    x = sum.rhs;
    factor->solve(x.data(), sum.block == 1 ? 3 : 1);
    return std::all_of(x.begin(), x.end(), [](double value) { return std::isfinite(value); });
  });
  if (!solved) return std::nullopt;
  std::vector<double> net(x.size());
  for (Index i = 0; i < u_.functions(); ++i)
    for (Index j = 0; j < v_.functions(); ++j)
      for (Index d = 0; d < 3; ++d)
        net[(i * v_.functions() + j) * 3 + d] =
            x[sum.block == 1 ? d * size + index(i, j) : 3 * index(i, j) + d];
  return Surface(knots_u_, knots_v_, 3, std::move(net));
}

}  // namespace knotfit::correction
