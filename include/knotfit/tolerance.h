// What "within tolerance" means.
#pragma once
#include <string>
#include <vector>
namespace [[gnu::visibility("default")]] knotfit {

enum class ErrorMeasure { max, rms, percentile };

struct Tolerance {
  double value = 0;  ///< absolute, in the data's unit, > 0
  ErrorMeasure measure = ErrorMeasure::max;
  double share = 1;  ///< percentile: share of the points in (0,1), 0.995 = 99.5 %
};

/// The error that counts: max, RMS, or the quantile at `share`.
double measured_error(const std::vector<double>& errors, const Tolerance& tolerance);

}  // namespace knotfit
