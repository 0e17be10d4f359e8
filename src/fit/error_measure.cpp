#include "fit/error_measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "knotfit/exceptions.h"
#include "knotfit/fit_least_squares.h"
namespace knotfit {
namespace {

constexpr std::array kRows{
    ErrorMeasureRow{.measure = ErrorMeasure::max,
                    .name = "max",
                    .needs_share = false,
                    .of_errors = [](const std::vector<double>& e,
                                    double) { return *std::max_element(e.begin(), e.end()); },
                    .of_sums = [](double, double max) { return max; },
                    .every_point = true,
                    .by_least_squares = false,
                    .spares_worst = false,
                    .energy_scale = 1,
                    .guard_looseness = 1,
                    .words = "largest error",
                    .where = "at every point"},
    ErrorMeasureRow{.measure = ErrorMeasure::rms,
                    .name = "rms",
                    .needs_share = false,
                    .of_errors =
                        [](const std::vector<double>& e, double) {
                          double squares = 0;
                          for (const double x : e) squares += x * x;
                          return std::sqrt(squares / static_cast<double>(e.size()));
                        },
                    .of_sums = [](double rms, double) { return rms; },
                    .every_point = false,
                    .by_least_squares = true,
                    .spares_worst = false,
                    .energy_scale = 3,  // single errors may be larger: three times it is what most stay below
                    .guard_looseness = 3,
                    .words = "RMS error",
                    .where = "in root mean square"},
    ErrorMeasureRow{
        .measure = ErrorMeasure::percentile,
        .name = "percentile",
        .needs_share = true,
        .of_errors = [](const std::vector<double>& e, double share) { return error_quantile(e, share); },
        .of_sums = nullptr,
        .every_point = false,
        .by_least_squares = false,
        .spares_worst = true,
        .energy_scale = 1,
        .guard_looseness = 3,
        .words = "error of {:g} % of the points",
        .where = "at {:g}% of the points"},
};

}  // namespace

std::span<const ErrorMeasureRow> error_measures() {
  return kRows;
}

const ErrorMeasureRow& row_of(ErrorMeasure measure) {
  return *std::find_if(kRows.begin(), kRows.end(), [&](const auto& row) { return row.measure == measure; });
}

std::string words_of(const Tolerance& tolerance) {
  return fmt::format(fmt::runtime(row_of(tolerance.measure).words), 100 * tolerance.share);
}

double measured_error(const std::vector<double>& errors, const Tolerance& tolerance) {
  if (errors.empty()) throw InvalidInput("no errors to measure");
  return row_of(tolerance.measure).of_errors(errors, tolerance.share);
}

}  // namespace knotfit
