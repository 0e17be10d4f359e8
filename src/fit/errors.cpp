#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/quantile.h"
#include "knotfit/exceptions.h"
#include "knotfit/fit_least_squares.h"
namespace knotfit {

double error_quantile(std::vector<double> errors, double share) {
  if (errors.empty() || !(share > 0 && share <= 1))
    throw InvalidInput("a quantile needs errors and a share in (0, 1]");
  const auto at = errors.begin() + static_cast<Index>(quantile_position(errors.size(), share));
  std::nth_element(errors.begin(), at, errors.end());
  return *at;
}

ErrorSummary summarize_errors(const std::vector<double>& errors, const ParameterizedPoints& points) {
  if (errors.empty()) throw InvalidInput("no errors to summarize");
  if (static_cast<Index>(errors.size()) != points.size())
    throw InvalidInput(fmt::format("{} errors for {} points", errors.size(), points.size()));
  ErrorSummary summary;
  double sum = 0, squares = 0;
  for (std::size_t k = 0; k < errors.size(); ++k) {
    if (!std::isfinite(errors[k]) || errors[k] < 0)
      throw InvalidInput(fmt::format("the error of point {} is {}", k, errors[k]));
    sum += errors[k];
    squares += errors[k] * errors[k];
    if (summary.worst < 0 || errors[k] > summary.max) {
      summary.max = errors[k];
      summary.worst = static_cast<Index>(k);
    }
  }
  const double n = static_cast<double>(errors.size());
  summary.mean = sum / n;
  summary.rms = std::sqrt(squares / n);
  summary.worst_u = points.u(summary.worst);
  summary.worst_v = points.v(summary.worst);
  // By selection, the largest first: each next one lies among those before.
  std::vector<double> parted = errors;
  auto end = parted.end();
  const auto quantile = [&](double share) {
    const auto at = parted.begin() + static_cast<Index>(quantile_position(parted.size(), share));
    if (at < end) std::nth_element(parted.begin(), at, end);
    end = at;
    return *at;
  };
  summary.p995 = quantile(0.995);
  summary.p99 = quantile(0.99);
  summary.p95 = quantile(0.95);
  summary.median = quantile(0.5);
  return summary;
}

}  // namespace knotfit
