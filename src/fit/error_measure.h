// What "the error" is: one row a measure, from which fits, searches and sentences take all that they need to know of it.
#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "knotfit/tolerance.h"
namespace knotfit {

struct ErrorMeasureRow {
  ErrorMeasure measure;
  /// In reports, and as users write it; one that needs a share is written by that, "99.5%".
  std::string_view name;
  bool needs_share;  ///< Tolerance::share means something
  /// \param errors  not empty
  double (*of_errors)(const std::vector<double>& errors, double share);
  /// From the RMS and the maximum of a fit alone; null: every error is needed.
  double (*of_sums)(double rms, double max);

  // What a search does about it:
  bool every_point;  ///< a maximum: minimax lowers it, and it is one at every place between the points too
  bool by_least_squares;  ///< least squares minimise it themselves: no weights of the points lower it
  bool spares_worst;      ///< the worst points do not count: their weights end at the error that does
  double energy_scale;  ///< times the tolerance: errors that are all the same to the data energy [METHOD 5.1]
  double
      guard_looseness;  ///< times the slack: how far off a place between the data is before it joins [METHOD 4.4]

  std::string_view words;  ///< "largest error"; {} stands for the share in %
  std::string_view where;  ///< "at every point"; likewise
};

std::span<const ErrorMeasureRow> error_measures();
const ErrorMeasureRow& row_of(ErrorMeasure measure);
/// "largest error", "error of 99.5 % of the points".
std::string words_of(const Tolerance& tolerance);

}  // namespace knotfit
