// De Boor's triangle on a control net: an evaluation apart from the library's own and the fit's.
#pragma once
#include <span>

#include "knotfit/surface.h"
namespace knotfit::verify {

/// The weights of one direction at one parameter: repeated affine combinations of the degree + 1
/// coefficients from `first` on give the value [deBoor01 X(14)].
class Triangle {
 public:
  /// x is clamped to the domain.
  Triangle(const KnotVector& knots, double x);
  Index first() const { return first_; }
  int degree() const { return degree_; }
  /// The value from the degree + 1 coefficients of the span, which are overwritten.
  double value(double* coefficients) const;

 private:
  int degree_ = 0;
  Index first_ = 0;
  double alpha_[kMaxDegree][kMaxDegree + 1];  // alpha_[r - 1][j]: share of coefficient j in round r
};

/// S(u,v), every component. \param out  dimension entries
void de_boor(const Surface& surface, double u, double v, std::span<double> out);

/// |a - b| without overflow or underflow of the squares. Both have the same length.
double distance(std::span<const double> a, std::span<const double> b);

}  // namespace knotfit::verify
