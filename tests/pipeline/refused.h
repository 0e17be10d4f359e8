// What fit_surface() refuses.
#pragma once
#include <limits>
#include <string>

#include "knotfit/exceptions.h"
#include "pipeline/fits.h"
#include "support/expect_throw.h"
namespace knotfit::test {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline void expect_refused(const ParameterizedPoints& points, const FitOptions& options,
                           const std::string& words) {
  expect_throw<InvalidInput>([&] { fit_surface(points, options); }, words);
}

}  // namespace knotfit::test
