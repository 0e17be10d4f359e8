// Every placement method on the same data: a row a method and size or tolerance, each checked like any fit.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "knotfit/fit_surface.h"
namespace [[gnu::visibility("default")]] knotfit {

struct CompareOptions {
  /// Names of placement_methods(), "criterion:curvature" and the like for a feature measure other than
  /// FitOptions::feature ("criterion:given": FitOptions::user_features, which methods without a measure in their name
  /// use too), or "all": every method, and the criterion on every measure.
  std::vector<std::string> methods{"all"};
  std::vector<std::pair<int, int>> sizes;    ///< control points along u and v
  std::vector<ToleranceRequest> tolerances;  ///< sizes searched to each
  FitOptions fit;  ///< degrees, smoothing, effort, ...; its method and sizes are not used
};

/// One fit of the table.
struct CompareRow {
  std::string method;  ///< as asked: "criterion:curvature"
  int asked_u = 0, asked_v = 0;
  ToleranceRequest tolerance;  ///< value 0: a fixed size
  bool fitted = false;
  std::string failure;  ///< why there is no surface; empty where there is
  FitResult result;
  double seconds = 0;  ///< wall clock of placement, fit, check and the numbers between
};

/// The jobs in the order they are run: sizes first, then tolerances, each by every method.
/// \throws InvalidInput  an unknown method or measure (lists those there are), neither a size nor a tolerance, a size
/// that the degrees do not allow
std::vector<CompareRow> comparison_rows(const CompareOptions& options);

/// Runs them one after another; `done` hears of each row as it ends, so that what is there when the caller stops is
/// kept. A method that fails on this data gives a row that says why, and the next is run.
/// \return the rows that ended
std::vector<CompareRow> compare_methods(const ParameterizedPoints& points, const CompareOptions& options,
                                        const Control& control = {},
                                        const std::function<void(const CompareRow&)>& done = {});

/// "criterion:curvature" as a method and a measure; "given" is no measure and gives `otherwise`. \throws InvalidInput  unknown
std::pair<std::string, FeatureMeasure> split_method(std::string_view name, FeatureMeasure otherwise);

}  // namespace knotfit
