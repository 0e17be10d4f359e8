// Knot vectors: a degree and a non-decreasing sequence of knots.
#pragma once
#include <span>
#include <vector>

#include "knotfit/index.h"
namespace [[gnu::visibility("default")]] knotfit {

inline constexpr int kMaxDegree = 9;

/// A knot vector of a spline of a given degree: knots t_0 <= ... <= t_{n+degree}, n = size()
/// basis functions, domain [t_degree, t_n]. Spans are half open, the last one closed.
/// Interior knots have multiplicity at most degree + 1 (degree + 1 makes a jump).
class KnotVector {
 public:
  KnotVector() = default;
  /// \throws InvalidInput  degree outside [1,9], fewer than 2 (degree + 1) knots, a knot that
  ///   is not finite or less than its predecessor, a multiplicity above degree + 1, an empty domain
  KnotVector(int degree, std::vector<double> knots);

  /// Clamped on [first, last]: end knots of multiplicity degree + 1, interior knots between.
  /// \throws InvalidInput  an interior knot outside (first, last) or decreasing
  static KnotVector clamped(int degree, std::span<const double> interior, double first = 0, double last = 1);
  /// Clamped with `interior` equally spaced simple knots.
  static KnotVector uniform(int degree, int interior, double first = 0, double last = 1);

  int degree() const { return degree_; }
  const std::vector<double>& knots() const { return knots_; }
  double operator[](Index i) const { return knots_[static_cast<std::size_t>(i)]; }
  Index size() const { return static_cast<Index>(knots_.size()) - degree_ - 1; }  ///< basis functions
  double first() const { return knots_[static_cast<std::size_t>(degree_)]; }
  double last() const { return knots_[knots_.size() - 1 - static_cast<std::size_t>(degree_)]; }
  bool is_clamped() const;

  /// Index i with t_i <= x < t_{i+1}, t_i < t_{i+1}, degree <= i < size(); x clamped to the domain
  /// [Piegl97 A2.1].
  Index find_span(double x) const;
  /// Non-empty spans of the domain.
  Index span_count() const;
  /// Distinct knots of the domain, both ends included.
  std::vector<double> breaks() const;
  /// Knots strictly inside the domain, repeated by multiplicity.
  std::vector<double> interior() const;
  int multiplicity(double knot) const;
  /// Greville abscissae (t_{i+1} + ... + t_{i+degree}) / degree, one a basis function.
  std::vector<double> greville() const;

  bool operator==(const KnotVector&) const = default;

 private:
  int degree_ = 0;
  std::vector<double> knots_;
};

/// Both vectors' knots, each with the larger of its two multiplicities.
/// \throws InvalidInput  degrees or domains differ
KnotVector merge(const KnotVector& a, const KnotVector& b);

}  // namespace knotfit
