// One direction of a fit: its spans, and the basis on every span as Legendre polynomials of the
// local coordinate t in [-1,1]. Products of the points' Legendre values are then all a fit needs.
#pragma once
#include <span>
#include <vector>

#include "knotfit/knot_vector.h"
namespace knotfit {

/// P_a = alpha_a t P_{a-1} - beta_a P_{a-2}, alpha = (2a-1)/a, beta = (a-1)/a [Abramowitz64 22.7.10].
struct LegendreRecurrence {
  double alpha[2 * kMaxDegree + 2] = {}, beta[2 * kMaxDegree + 2] = {};
  constexpr LegendreRecurrence() {
    for (int a = 1; a < 2 * kMaxDegree + 2; ++a) {
      alpha[a] = (2.0 * a - 1) / a;
      beta[a] = (a - 1.0) / a;
    }
  }
};
inline constexpr LegendreRecurrence kLegendre{};

/// Values P_0(t) .. P_{count-1}(t) of the Legendre polynomials, count >= 2.
inline void legendre_values(double t, int count, double* values) {
  values[0] = 1;
  values[1] = t;
  for (int a = 2; a < count; ++a)
    values[a] = kLegendre.alpha[a] * t * values[a - 1] - kLegendre.beta[a] * values[a - 2];
}

class Axis {
 public:
  /// Clamped on [0,1]. Coincident knots leave spans of no length, which hold no point.
  explicit Axis(int degree, std::span<const double> interior = {});
  /// All knots of a period of 1, increasing, at least degree + 1: as many functions, which run on over the seam.
  static Axis periodic(int degree, std::span<const double> period);

  int degree() const { return degree_; }
  int width() const { return degree_ + 1; }        ///< functions alive on a span
  int moments() const { return 2 * degree_ + 1; }  ///< Legendre degrees of products of two
  int pairs() const { return width() * (width() + 1) / 2; }
  Index spans() const { return spans_; }
  Index functions() const { return periodic_ ? spans_ : spans_ + degree_; }
  bool is_periodic() const { return periodic_; }
  /// The number of function i of a span, i = 0..degree.
  Index function(Index s, int i) const { return periodic_ ? (s + i) % spans_ : s + i; }
  const KnotVector& knots() const { return knots_; }

  double low(Index s) const { return knots_[s + degree_]; }
  double length(Index s) const { return knots_[s + degree_ + 1] - knots_[s + degree_]; }
  /// The non-empty span that holds x in [0,1], or in [first, first + 1] of a period.
  Index span(double x) const {
    Index s = bucket_[static_cast<std::size_t>((x - first_) * buckets_)];
    while (x >= upper_[s]) ++s;
    return s;
  }
  double local(Index s, double x) const { return (x - low_[s]) * scale_[s] - 1; }

  /// width x width: entry [a * width + i] the Legendre coefficient a of function i of the span.
  const double* basis(Index s) const { return basis_.data() + s * width() * width(); }
  /// pairs x moments: row (i, i2 <= i) holds the Legendre coefficients of the product.
  const double* products(Index s) const { return products_.data() + s * pairs() * moments(); }
  /// functions x (degree + 1) lower band: [i * width + k] = int B_i^(r) B_{i-k}^(r), k <= degree; of a period i - k runs on
  /// over the seam.
  std::vector<double> gram(int derivative) const;

 private:
  Axis(KnotVector knots, Index spans, bool periodic);

  int degree_;
  KnotVector knots_;
  Index spans_;
  bool periodic_;
  double first_;
  int buckets_;
  std::vector<Index> bucket_;
  std::vector<double> low_, upper_, scale_, basis_, products_;
};

}  // namespace knotfit
