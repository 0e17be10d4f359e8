#include "correct/tangent_system.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>

#include "correct/block_moments.h"
#include "knotfit/basis.h"
#include "solve/smoothing_floor.h"
#include "solve/spans_in_turn.h"
namespace knotfit::correction {
namespace {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using ConstMap = Eigen::Map<const RowMatrix>;

/// Points in the order of their cells: outer span, then inner span.
struct Order {
  std::vector<std::int32_t> point, cell;
  std::vector<Index> start;  ///< by cell
};

Order sort_cells(std::span<const double> uv, const Axis& outer, const Axis& inner, bool swapped) {
  const std::size_t n = uv.size() / 2;
  Order o;
  o.point.resize(n);
  o.cell.resize(n);
  o.start.assign(static_cast<std::size_t>(outer.spans() * inner.spans()) + 1, 0);
  for (std::size_t k = 0; k < n; ++k) {
    const double a = uv[2 * k + swapped], b = uv[2 * k + 1 - swapped];
    o.cell[k] = static_cast<std::int32_t>(outer.span(a) * inner.spans() + inner.span(b));
    ++o.start[o.cell[k] + 1];
  }
  for (std::size_t c = 1; c < o.start.size(); ++c) o.start[c] += o.start[c - 1];
  std::vector<Index> next(o.start.begin(), o.start.end() - 1);
  for (std::size_t k = 0; k < n; ++k) o.point[next[o.cell[k]]++] = static_cast<std::int32_t>(k);
  return o;
}

/// Basis functions and first derivatives at one place of one direction.
struct Basis1 {
  Index first = 0;
  std::array<double, 2 * (kMaxDegree + 1)> value{};
  Basis1(const KnotVector& knots, double x) {
    const Index span = knots.find_span(x);
    first = span - knots.degree();
    basis_derivatives(knots, span, x, 1, value);
  }
};

/// The functions alive at (u,v), by the number they have in the system, with `f` = by_u B'_i B_j + by_v B_i B'_j.
struct Pattern {
  int count = 0;
  std::array<Index, (kMaxDegree + 1) * (kMaxDegree + 1)> id;
  std::array<double, (kMaxDegree + 1) * (kMaxDegree + 1)> f;
};

}  // namespace

TangentSystem::TangentSystem(const KnotVector& u, const KnotVector& v, double aspect)
    : knots_u_(u), knots_v_(v), u_(u.degree(), u.interior()), v_(v.degree(), v.interior()) {
  swapped_ = v_.functions() > u_.functions();
  const Axis &outer = swapped_ ? v_ : u_, &inner = swapped_ ? u_ : v_;
  const Index ni = inner.functions();
  energy_.reset(outer.functions() * ni, outer.degree() * ni + inner.degree());
  // x = aspect u, y = v up to a common factor; degree 1 has no second derivative: the membrane energy.
  const bool membrane = std::min(outer.degree(), inner.degree()) == 1;
  const double so = swapped_ ? 1 : 1 / (aspect * aspect), si = swapped_ ? 1 / (aspect * aspect) : 1;
  const auto o0 = outer.gram(0), o1 = outer.gram(1), o2 = outer.gram(2);
  const auto i0 = inner.gram(0), i1 = inner.gram(1), i2 = inner.gram(2);
  const int wo = outer.width(), wi = inner.width();
  for (Index i = 0; i < outer.functions(); ++i)
    for (Index a = 0; a < wo && a <= i; ++a)
      for (Index j = 0; j < ni; ++j)
        for (Index b = 1 - wi; b < wi; ++b) {
          const Index row = i * ni + j, column = (i - a) * ni + j - b;
          if (j - b < 0 || j - b >= ni || column > row) continue;
          const Index x = i * wo + a, y = std::max(j, j - b) * wi + std::abs(b);
          energy_.add(row, column,
                      membrane
                          ? so * o1[x] * i0[y] + si * o0[x] * i1[y]
                          : so * so * o2[x] * i0[y] + 2 * so * si * o1[x] * i1[y] + si * si * o0[x] * i2[y]);
        }
}

double TangentSystem::add_points(const SystemPoints& points, int block, BandMatrix& matrix,
                                 std::vector<double>& rhs) const {
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
      const auto add = [&](Index x, Index y, int row, int column) {  // x >= y
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
      };
      int row = 0;
      for (int i = 0; i < wo; ++i)
        for (int i2 = 0; i2 <= i; ++i2, ++row) {
          int column = 0;
          const Index x = (s + i) * ni + r, y = (s + i2) * ni + r;
          for (int j = 0; j < wi; ++j)
            for (int j2 = 0; j2 <= j; ++j2, ++column) {
              add(x + j, y + j2, row, column);
              if (i != i2 && j != j2) add(x + j2, y + j, row, column);
            }
        }
      for (int i = 0; i < wo; ++i)
        for (int j = 0; j < wi; ++j)
          for (int d = 0; d < 3; ++d) {
            const Index x = (s + i) * ni + r + j;
            rhs[block == 1 ? d * size + x : 3 * x + d] += right[(d * wo + i) * wi + j];
          }
    }
  });
  double sum = 0;
  for (const double t : trace) sum += t;
  return sum;
}

void TangentSystem::add_gradient(std::span<const GradientDatum> data, int block, BandMatrix& scalar,
                                 std::vector<double>& rhs) const {
  const Index size = scalar.size();
  Pattern by_u, by_v;
  for (const GradientDatum& g : data) {
    const Basis1 bu(knots_u_, g.u), bv(knots_v_, g.v);
    const int wu = u_.width(), wv = v_.width();
    by_u.count = 0;
    for (int i = 0; i < wu; ++i)
      for (int j = 0; j < wv; ++j) {
        by_u.id[by_u.count] = index(bu.first + i, bv.first + j);
        by_u.f[by_u.count] = bu.value[wu + i] * bv.value[j];
        by_v.f[by_u.count++] = bu.value[i] * bv.value[wv + j];
      }
    for (int x = 0; x < by_u.count; ++x) {
      const double fu = g.weight_u * by_u.f[x], fv = g.weight_v * by_v.f[x];
      const Vec3 r = fu * g.xu + fv * g.xv;
      const Index k = by_u.id[x];
      const double value[3] = {r.x, r.y, r.z};
      for (int d = 0; d < 3; ++d) rhs[block == 1 ? d * size + k : 3 * k + d] += value[d];
      double* column = scalar.column(k) - k;
      for (int y = 0; y < by_u.count; ++y)
        if (by_u.id[y] >= k) column[by_u.id[y]] += fu * by_u.f[y] + fv * by_v.f[y];
    }
  }
}

void TangentSystem::add_hinge(std::span<const HingeRow> rows, BandMatrix& matrix,
                              std::vector<double>& rhs) const {
  for (const HingeRow& h : rows) {
    const Basis1 bu(knots_u_, h.u), bv(knots_v_, h.v);
    const int wu = u_.width(), wv = v_.width();
    Pattern p;
    for (int i = 0; i < wu; ++i)
      for (int j = 0; j < wv; ++j) {
        p.id[p.count] = index(bu.first + i, bv.first + j);
        p.f[p.count++] = h.a * bu.value[wu + i] * bv.value[j] + h.b * bu.value[i] * bv.value[wv + j];
      }
    const double y[3] = {h.y.x, h.y.y, h.y.z};
    for (int k = 0; k < p.count; ++k) {
      const double w = h.weight * p.f[k];
      for (int c = 0; c < 3; ++c) {
        const Index at = 3 * p.id[k] + c;
        rhs[at] += w * h.target * y[c];
        double* column = matrix.column(at) - at;
        for (int l = 0; l < p.count; ++l)
          for (int d = 0; d < 3; ++d)
            if (const Index row = 3 * p.id[l] + d; row >= at) column[row] += w * y[c] * p.f[l] * y[d];
      }
    }
  }
}

void TangentSystem::add_curvature(std::span<const CurvatureDatum> data, BandMatrix& matrix,
                                  std::vector<double>& rhs) const {
  constexpr int of_u[3] = {2, 1, 0}, of_v[3] = {0, 1, 2};
  constexpr std::size_t most = (kMaxDegree + 1) * (kMaxDegree + 1);
  const int wu = u_.width(), wv = v_.width();
  std::array<double, 3 * (kMaxDegree + 1)> bu{}, bv{};
  std::array<Index, most> id;
  std::array<std::array<double, 3>, most> f;
  for (const CurvatureDatum& g : data) {
    const Index su = knots_u_.find_span(g.u), sv = knots_v_.find_span(g.v);
    basis_derivatives(knots_u_, su, g.u, 2, bu);
    basis_derivatives(knots_v_, sv, g.v, 2, bv);
    int count = 0;
    for (int i = 0; i < wu; ++i)
      for (int j = 0; j < wv; ++j, ++count) {
        id[count] = index(su - knots_u_.degree() + i, sv - knots_v_.degree() + j);
        for (int k = 0; k < 3; ++k) f[count][k] = bu[of_u[k] * wu + i] * bv[of_v[k] * wv + j];
      }
    const double n[3] = {g.n.x, g.n.y, g.n.z};
    for (int x = 0; x < count; ++x) {
      std::array<double, 3> wf;
      double right = 0;
      for (int k = 0; k < 3; ++k) wf[k] = g.weight[k] * f[x][k], right += wf[k] * g.target[k];
      for (int c = 0; c < 3; ++c) {
        const Index at = 3 * id[x] + c;
        rhs[at] += right * n[c];
        double* column = matrix.column(at) - at;
        for (int y = 0; y < count; ++y) {
          const double w = n[c] * (wf[0] * f[y][0] + wf[1] * f[y][1] + wf[2] * f[y][2]);
          for (int d = 0; d < 3; ++d)
            if (const Index row = 3 * id[y] + d; row >= at) column[row] += w * n[d];
        }
      }
    }
  }
}

std::optional<BandMatrix> TangentSystem::factored(const BandMatrix& matrix, const BandMatrix& scalar,
                                                  int block, double lambda) const {
  BandMatrix whole = matrix;
  const Index size = energy_.size(), band = energy_.bandwidth();
  for (Index k = 0; k < size; ++k) {
    const double *e = energy_.column(k), *g = scalar.column(k);
    for (Index d = 0; d <= std::min(band, size - 1 - k); ++d) {
      const double x = lambda * e[d] + g[d];
      if (x == 0) continue;
      if (block == 1)
        whole.add(k + d, k, x);
      else
        for (Index c = 0; c < 3; ++c) whole.add(3 * (k + d) + c, 3 * k + c, x);
    }
  }
  if (!whole.factor()) return std::nullopt;
  return whole;
}

std::optional<Surface> TangentSystem::solve(const SystemPoints& points, double smoothing,
                                            const Holding& holding) const {
  const int block = points.matrix.empty() ? 1 : 3;
  const Index size = energy_.size(), band = energy_.bandwidth();
  BandMatrix matrix(block * size, block == 1 ? band : 3 * band + 2), scalar(size, band);
  std::vector<double> rhs(static_cast<std::size_t>(3 * size), 0.0);
  const double trace = add_points(points, block, matrix, rhs);
  add_gradient(holding.gradient, block, scalar, rhs);
  if (block == 3) {
    add_hinge(holding.hinge, matrix, rhs);
    add_curvature(holding.curvature, matrix, rhs);
  }
  const double energy_trace = energy_.trace();
  std::vector<double> x;
  const bool solved = with_smoothing_floor(smoothing, [&](double floor) {
    const std::optional<BandMatrix> whole =
        factored(matrix, scalar, block, energy_trace > 0 ? floor * trace / energy_trace : 0);
    if (!whole) return false;
    x = rhs;
    whole->solve(x.data(), block == 1 ? 3 : 1);
    return std::all_of(x.begin(), x.end(), [](double value) { return std::isfinite(value); });
  });
  if (!solved) return std::nullopt;
  std::vector<double> net(x.size());
  for (Index i = 0; i < u_.functions(); ++i)
    for (Index j = 0; j < v_.functions(); ++j)
      for (Index d = 0; d < 3; ++d)
        net[(i * v_.functions() + j) * 3 + d] = x[block == 1 ? d * size + index(i, j) : 3 * index(i, j) + d];
  return Surface(knots_u_, knots_v_, 3, std::move(net));
}

}  // namespace knotfit::correction
