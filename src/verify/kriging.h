// Polyharmonic kriging on one stencil of points, with its error bar and the likelihood of noise.
#pragma once
#include <memory>
#include <span>

#include "knotfit/index.h"
namespace knotfit::verify {

/// Points about a place, in coordinates that put the place at 0 and the farthest point at distance 1.
struct Stencil {
  std::span<const double> x, y;    ///< k coordinates
  std::span<const double> values;  ///< k x components, row-major, of order 1
  std::span<const double>
      weights;  ///< k, > 0: the noise of a point has the variance noise^2 / weight; empty: all 1
  int components = 1;
};

/// The kernel (-1)^(degree+1) r^(2 degree + 1) with polynomials up to `degree`:
///
///     [K P; P^T 0] [W; B] = [Z b; 0 p]        z* = b^T W_z + p^T B_z
///     e^2 = sigma^2 pi^2,  sigma^2 = sum over components of Z^T W_z / (k - q),  pi^2 = -(b^T W_b + p^T B_b)
///
/// solved in the null space of P^T, where K is positive definite [METHOD 5.3; Wahba90].
/// One object serves many stencils, one at a time.
class Kriging {
 public:
  Kriging();
  ~Kriging();
  Kriging(Kriging&&) noexcept;

  /// Sets the stencil up with the highest degree <= `degree` at which the polynomials are independent on
  /// its points, found by a rank-revealing QR.
  /// \return that degree; 0: below 1, or too few points: nothing can be said there
  int set(const Stencil& stencil, int degree);

  /// Value and error bar at the place.
  /// \param noise  standard deviation of the noise in the values; 0: they are interpolated
  /// \param value  components entries, written
  /// \return the error bar e >= 0, infinity where the system cannot be solved
  double predict(double noise, std::span<double> value);

  /// How the process fares at the points themselves: the largest error of those predicted from all others, each
  /// over its own error bar, of the first `nearest` points; about 2 where the bars are right. Well above where
  /// the data is rougher about the place than elsewhere in the stencil, as at a crease. After predict().
  double surprise(Index nearest);

  /// Standard deviation of the noise that is most likely for these values (restricted likelihood).
  double likely_noise();

 private:
  struct Work;
  std::unique_ptr<Work> work_;
};

/// Points a prediction needs at least for `degree`: as many again as there are polynomials, and 8
/// degrees of freedom, below which sigma itself is anybody's guess.
Index least_points(int degree);

}  // namespace knotfit::verify
