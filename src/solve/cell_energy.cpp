#include "solve/cell_energy.h"

#include <Eigen/Dense>

#include "solve/degrees.h"
#include "solve/spans_in_turn.h"
namespace knotfit {
namespace {

template <int rows, int columns>
using Matrix = Eigen::Matrix<double, rows, columns, Eigen::RowMajor>;

/// Of one span: Legendre coefficients (row a, function i) of the functions and their derivatives by the local
/// coordinate, and the means over the span of products of two of the same order. `w` functions, or any number.
template <int w>
struct SpanTerms {
  Matrix<w, w> derivative[3], gram[3];
};

template <int w>
std::vector<SpanTerms<w>> span_terms(const Axis& axis) {
  const int width = axis.width();
  Eigen::VectorXd mean(width);  // of P_a^2
  for (int a = 0; a < width; ++a) mean(a) = 1.0 / (2 * a + 1);
  std::vector<SpanTerms<w>> terms(axis.spans());
  for (Index s = 0; s < axis.spans(); ++s) {
    if (!(axis.length(s) > 0)) continue;
    SpanTerms<w>& t = terms[s];
    t.derivative[0] = Eigen::Map<const Matrix<Eigen::Dynamic, Eigen::Dynamic>>(axis.basis(s), width, width);
    for (int r = 1; r < 3; ++r) {  // P_a' = (2a-1) P_{a-1} + (2a-5) P_{a-3} + ... [Abramowitz64 8.5.4]
      t.derivative[r] = Matrix<w, w>::Zero(width, width);
      for (int a = 1; a < width; ++a)
        for (int b = a - 1; b >= 0; b -= 2)
          t.derivative[r].row(b) += (2 * b + 1) * t.derivative[r - 1].row(a);
    }
    for (int r = 0; r < 3; ++r) t.gram[r] = t.derivative[r].transpose() * mean.asDiagonal() * t.derivative[r];
  }
  return terms;
}

/// The kinds as derivatives of the outer and the inner direction.
struct Orders {
  int outer, inner;
};

Orders orders(int kind, bool swapped) {
  constexpr Orders kUnswapped[] = {{2, 0}, {1, 1}, {0, 2}, {1, 0}, {0, 1}};
  const Orders o = kUnswapped[kind];
  return swapped ? Orders{o.inner, o.outer} : o;
}

/// Weights and goals of a cell, times what a derivative by the parameter is in derivatives by the local coordinate.
class CellIntegrals {
 public:
  CellIntegrals(const DataEnergy& energy, const NetLayout& layout)
      : energy_(energy), layout_(layout), goal_(energy.goal_size()), scratch_(energy.scratch_size()) {}

  void at(Index s, Index r, double factor) {
    const Axis &o = layout_.outer, &i = layout_.inner;
    const double lo = o.length(s), li = i.length(r), x = o.low(s), y = i.low(r);
    if (layout_.swapped)
      energy_.integrate(y, y + li, x, x + lo, weight_, goal_.data(), scratch_.data());
    else
      energy_.integrate(x, x + lo, y, y + li, weight_, goal_.data(), scratch_.data());
    for (int k = 0; k < DataEnergy::kKinds; ++k) {
      const Orders order = orders(k, layout_.swapped);
      scale_[k] = (order.outer > 0 ? 2 / lo : 1) * (order.outer > 1 ? 2 / lo : 1) *
                  (order.inner > 0 ? 2 / li : 1) * (order.inner > 1 ? 2 / li : 1);
      quadratic[k] = factor * weight_[k] * scale_[k] * scale_[k];
      scale_[k] *= factor;
    }
  }
  double quadratic[DataEnergy::kKinds] = {};
  /// Of kind k, component e: the moment against P_a of the outer and P_b of the inner direction.
  double goal(int k, int e, int a, int b) const {
    const int at = layout_.swapped ? b * DataEnergy::kOrder + a : a * DataEnergy::kOrder + b;
    return scale_[k] * goal_[(Index{at} * DataEnergy::kKinds + k) * energy_.dimension() + e];
  }

 private:
  const DataEnergy& energy_;
  const NetLayout& layout_;
  double weight_[DataEnergy::kKinds] = {}, scale_[DataEnergy::kKinds] = {};
  std::vector<double> goal_, scratch_;
};

/// Calls body(s, r, integrals) for every cell of positive area; spans of the outer direction in turn.
template <class Body>
void for_cells(const DataEnergy& energy, const NetLayout& layout, double factor, const Body& body) {
  for_spans_in_turn(layout.outer, [&](Index s) {
    if (!(layout.outer.length(s) > 0)) return;
    CellIntegrals cell(energy, layout);
    for (Index r = 0; r < layout.inner.spans(); ++r) {
      if (!(layout.inner.length(r) > 0)) continue;
      cell.at(s, r, factor);
      body(s, r, cell);
    }
  });
}

}  // namespace

void add_energy(const DataEnergy& energy, const NetLayout& layout, double factor, BandMatrix& matrix,
                std::vector<double>& right) {
  constexpr int kOrder = DataEnergy::kOrder;
  const int wo = layout.outer.width(), wi = layout.inner.width(), d = energy.dimension();
  const Index ni = layout.inner.functions();
  for_degrees(layout.outer.degree(), layout.inner.degree(), [&]<int degree>() {
    constexpr int w = width_of(degree);
    const std::vector<SpanTerms<w>> outer = span_terms<w>(layout.outer), inner = span_terms<w>(layout.inner);
    for_cells(energy, layout, factor, [&](Index s, Index r, const CellIntegrals& cell) {
      const SpanTerms<w>&o = outer[s], &i = inner[r];
      Matrix<w, w> block(wi, wi);
      for (int a = 0; a < wo; ++a)
        for (int a2 = 0; a2 <= a; ++a2) {
          double before[3] = {};
          for (int k = 0; k < DataEnergy::kKinds; ++k) {
            const Orders order = orders(k, layout.swapped);
            before[order.inner] += cell.quadratic[k] * o.gram[order.outer](a, a2);
          }
          block = before[0] * i.gram[0] + before[1] * i.gram[1] + before[2] * i.gram[2];
          for (int b = 0; b < wi; ++b)
            for (int b2 = 0; b2 < (a == a2 ? b + 1 : wi); ++b2)
              matrix.add((s + a) * ni + r + b, (s + a2) * ni + r + b2, block(b, b2));
        }
      Matrix<w, w> sum(wo, wi);
      Matrix<kOrder, w> half(kOrder, wi);
      Matrix<kOrder, kOrder> goal;
      for (int e = 0; e < d; ++e) {
        sum.setZero();
        for (int k = 0; k < DataEnergy::kKinds; ++k) {
          const Orders order = orders(k, layout.swapped);
          for (int x = 0; x < kOrder; ++x)
            for (int y = 0; y < kOrder; ++y) goal(x, y) = cell.goal(k, e, x, y);
          half.noalias() = goal * i.derivative[order.inner].template topRows<kOrder>();
          sum.noalias() += o.derivative[order.outer].template topRows<kOrder>().transpose() * half;
        }
        for (int a = 0; a < wo; ++a)
          for (int b = 0; b < wi; ++b) right[((s + a) * ni + r + b) * d + e] += sum(a, b);
      }
    });
  });
}

void add_energy_gradient(const DataEnergy& energy, const NetLayout& layout, double factor,
                         const std::vector<double>& net, std::vector<double>& right) {
  constexpr int w = Eigen::Dynamic;
  constexpr int kOrder = DataEnergy::kOrder;
  const std::vector<SpanTerms<w>> outer = span_terms<w>(layout.outer), inner = span_terms<w>(layout.inner);
  const int wo = layout.outer.width(), wi = layout.inner.width(), d = energy.dimension();
  const Index no = layout.outer.functions(), ni = layout.inner.functions();
  for_cells(energy, layout, factor, [&](Index s, Index r, const CellIntegrals& cell) {
    Matrix<w, w> c(wo, wi), sum(wo, wi);
    Matrix<kOrder, kOrder> goal;
    for (int e = 0; e < d; ++e) {
      for (int a = 0; a < wo; ++a)
        for (int b = 0; b < wi; ++b)
          c(a, b) = net[(layout.swapped ? (r + b) * no + s + a : (s + a) * ni + r + b) * d + e];
      sum.setZero();
      for (int k = 0; k < DataEnergy::kKinds; ++k) {
        const Orders order = orders(k, layout.swapped);
        sum += cell.quadratic[k] * outer[s].gram[order.outer] * c * inner[r].gram[order.inner];
        for (int x = 0; x < kOrder; ++x)
          for (int y = 0; y < kOrder; ++y) goal(x, y) = cell.goal(k, e, x, y);
        sum -= outer[s].derivative[order.outer].topRows(kOrder).transpose() * goal *
               inner[r].derivative[order.inner].topRows(kOrder);
      }
      for (int a = 0; a < wo; ++a)
        for (int b = 0; b < wi; ++b) right[((s + a) * ni + r + b) * d + e] += sum(a, b);
    }
  });
}

}  // namespace knotfit
