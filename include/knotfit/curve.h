// B-spline curves in a space of any dimension.
#pragma once
#include <span>
#include <vector>

#include "knotfit/knot_vector.h"
namespace [[gnu::visibility("default")]] knotfit {

/// C(t) = sum_i B_i(t) c_i, c_i in R^dimension.
class Curve {
 public:
  Curve() = default;
  /// \param control_points  size x dimension, row-major
  /// \throws InvalidInput  the length does not fit the knots, or an entry is not finite
  Curve(KnotVector knots, int dimension, std::vector<double> control_points);
  const KnotVector& knots() const { return knots_; }
  int degree() const { return knots_.degree(); }
  Index size() const { return knots_.size(); }
  int dimension() const { return dimension_; }
  const std::vector<double>& control_points() const { return control_points_; }
  bool operator==(const Curve&) const = default;

 private:
  KnotVector knots_;
  int dimension_ = 0;
  std::vector<double> control_points_;
};

/// Value and derivatives up to `order` at t (clamped to the domain).
/// \return (order + 1) x dimension, row r the r-th derivative
std::vector<double> evaluate_derivatives(const Curve& c, double t, int order);
/// Values at many parameters. \return n x dimension
std::vector<double> evaluate(const Curve& c, std::span<const double> t);
/// S unchanged. \throws InvalidInput as insert_knot_u
Curve insert_knot(const Curve& c, double knot);
Curve refine(const Curve& c, std::span<const double> added);

}  // namespace knotfit
