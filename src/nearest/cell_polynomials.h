// A surface in space as one polynomial for each knot cell: fast values and derivatives at many places.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec3.h"
#include "knotfit/surface.h"
namespace knotfit {

/// Value and first derivatives.
struct Jet {
  Vec3 s, u, v;
};
struct SecondDerivatives {
  Vec3 uu, uv, vv;
};

/// The non-empty spans of one direction.
class SpanTable {
 public:
  explicit SpanTable(const KnotVector& knots);
  int degree() const { return degree_; }
  Index spans() const { return static_cast<Index>(breaks_.size()) - 1; }
  double first() const { return breaks_.front(); }
  double last() const { return breaks_.back(); }
  double low(Index s) const { return breaks_[s]; }
  double high(Index s) const { return breaks_[s + 1]; }
  double length(Index s) const { return breaks_[s + 1] - breaks_[s]; }
  double mean_length() const { return (last() - first()) / static_cast<double>(spans()); }
  Index function(Index s) const { return function_[s]; }  ///< first basis function that lives on the span
  /// The span that holds x. The last one holds its end too. \param x  in the domain
  Index span(double x) const {
    Index s = bucket_[static_cast<std::size_t>((x - first()) * per_length_)];
    while (s + 1 < spans() && x >= breaks_[s + 1]) ++s;
    return s;
  }
  double local(Index s, double x) const { return (x - middle_[s]) * inverse_half_[s]; }  ///< in [-1,1]
  double inverse_half(Index s) const { return inverse_half_[s]; }
  /// (degree + 1)^2: entry [k * (degree + 1) + a] is the coefficient of t^k of function a of the span.
  const double* powers(Index s) const { return powers_.data() + s * (degree_ + 1) * (degree_ + 1); }

 private:
  int degree_;
  double per_length_ = 0;
  std::vector<double> breaks_, middle_, inverse_half_, powers_;
  std::vector<Index> function_, bucket_;
};

class CellPolynomials {
 public:
  /// \param s  in R^3, not empty
  explicit CellPolynomials(const Surface& s);
  const SpanTable& u() const { return u_; }
  const SpanTable& v() const { return v_; }
  Index cells() const { return u_.spans() * v_.spans(); }
  Index cell(double u, double v) const { return u_.span(u) * v_.spans() + v_.span(v); }
  /// t^k s^l coefficients of a cell, [(k * (degree_v + 1) + l) * 3 + d], t and s in [-1,1].
  const double* coefficients(Index cell) const { return coefficients_.data() + cell * stride_; }

  /// Takes runs of places in one cell side by side, so that places sorted by cell are fastest. The bits of a place do not
  /// depend on its neighbours. \param uv  n x 2, in the domain
  void jets(std::span<const double> uv, Jet* out) const;
  Jet jet(double u, double v) const;
  Jet jet(double u, double v, SecondDerivatives& second) const;
  /// Evaluates the polynomial of span a in u and span b in v. u and v may lie outside.
  Jet jet(Index a, Index b, double u, double v, SecondDerivatives& second) const;

 private:
  SpanTable u_, v_;
  Index stride_ = 0;
  std::vector<double> coefficients_;
};

/// The places in the order of their cells; those of one cell keep their order.
std::vector<std::int32_t> order_by_cell(const CellPolynomials& surface, std::span<const double> uv);

}  // namespace knotfit
