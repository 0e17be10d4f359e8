// A derivative against central differences.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>
namespace knotfit::test {

/// Expects gradient_k = df/dx_k for every k, by central differences at two steps.
/// \param f      double f(const std::vector<double>& x)
/// \param step   of every x_k; f must be smooth within it
/// \param noise  rounding error of f as a multiple of eps max|f|
/// The extrapolated difference (4 D(h/2) - D(h)) / 3 has an error of order h^4, far below
/// |D(h) - D(h/2)|, which is of order h^2; rounding adds up to 6 noise eps max|f| / h.
template <class F>
void expect_gradient(const F& f, std::span<const double> x, std::span<const double> gradient,
                     double step = 1e-4, double noise = 16) {
  ASSERT_EQ(x.size(), gradient.size());
  std::vector<double> at(x.begin(), x.end());
  for (std::size_t k = 0; k < x.size(); ++k) {
    double largest = 0;
    const auto difference = [&](double h) {
      at[k] = x[k] + h;
      const double after = f(at), width_after = at[k];
      at[k] = x[k] - h;
      const double before = f(at), width = width_after - at[k];
      at[k] = x[k];
      largest = std::max({largest, std::abs(after), std::abs(before)});
      return (after - before) / width;
    };
    const double wide = difference(step), narrow = difference(step / 2);
    const double expected = (4 * narrow - wide) / 3;
    const double tolerance = std::abs(wide - narrow) + 6 * noise * 0x1p-52 * largest / step;
    EXPECT_NEAR(gradient[k], expected, tolerance) << "derivative by x_" << k;
  }
}

}  // namespace knotfit::test
