#include "search/curve_search.h"

#include <algorithm>

#include "search/noise_plateau.h"
#include "search/search_run.h"
#include "search/size_solver.h"
namespace knotfit {
namespace {

constexpr long kMostFits = 100'000;

/// Sizes {control points, 1}.
class CurveSizes final : public SizeSolver {
 public:
  CurveSizes(CurveFitter& fitter, SearchRun& run, NoisePlateau plateau)
      : fitter_(fitter), run_(run), plateau_(plateau) {
    nearest_.swings.swings = true;
  }

  const SizeOutcome& solve(const Spans& size, const Spans*) override {
    FittedCurve fitted = fitter_.size(size.first);
    SizeOutcome& outcome = outcomes_[size];
    outcome = {.error = fitted.error, .rms = fitted.rms, .holds = fitter_.holds(fitted), .tries = 1};
    only_noise_ = !outcome.holds && !fitted.empty() && plateau_.add(size.first, fitted.rms);
    held_but_swings_ = held_but_swings_ || (run_.holds(fitted.error) && !outcome.holds);
    run_.list(size.first, 1, fitted.error, outcome.holds);
    run_.show({fitted.error, size.first, 1}, fitter_.fits());
    if (outcome.holds)
      best_ = std::move(fitted);
    else if (nearer(fitted, nearest_))
      nearest_ = std::move(fitted);
    return outcome;
  }

  bool interrupted() const { return run_.interrupted(fitter_.fits()); }
  bool only_noise() const { return only_noise_; }  ///< the last sizes only followed it
  bool held_but_swings() const { return held_but_swings_; }
  FittedCurve best() { return std::move(best_.empty() ? nearest_ : best_); }

 private:
  /// Of two curves that do not hold, the one to keep: one that keeps to its data, else the least error.
  static bool nearer(const FittedCurve& a, const FittedCurve& b) {
    if (b.empty() || a.empty()) return !a.empty();
    if (a.swings.swings != b.swings.swings) return !a.swings.swings;
    return a.error < b.error;
  }

  CurveFitter& fitter_;
  SearchRun& run_;
  NoisePlateau plateau_;
  FittedCurve best_, nearest_;
  bool held_but_swings_ = false, only_noise_ = false;
};

/// From small to the first size that holds. \return the status where none does; else n is that size
Status grow(CurveSizes& sizes, Index most, Status above_most, int& n) {
  for (;; n = static_cast<int>(std::min<Index>(most, n + std::max(1, n / 10)))) {
    if (sizes.solve({n, 1}, nullptr).holds) return Status::reached;
    if (!sizes.interrupted() && !sizes.only_noise() && n < most) continue;
    return sizes.held_but_swings() ? Status::swings
           : sizes.only_noise()    ? Status::tolerance_below_noise
           : sizes.interrupted()   ? Status::limit_reached
                                   : above_most;
  }
}

/// One at a time, while one of two sizes below may hold.
void walk_down(CurveSizes& sizes, int n, int least) {
  for (int failed = 0; failed < 2 && n > least && !sizes.interrupted();) {
    const SizeOutcome* seen = sizes.seen({--n, 1});
    failed = (seen ? *seen : sizes.solve({n, 1}, nullptr)).holds ? 0 : failed + 1;
  }
}

}  // namespace

CurveSearch search_curve_sizes(CurveFitter& fitter, const CurvePoints& points, const SearchOptions& options,
                               const Tolerance& tolerance, Index most, double noise, double unit,
                               const Control& control) {
  SearchRun run(control, tolerance, options.max_fits > 0 ? options.max_fits : kMostFits, unit);
  CurveSizes sizes(fitter, run, NoisePlateau(noise, points.size(), points.dimension));
  int n = static_cast<int>(fitter.least());
  const Status unmet =
      grow(sizes, most, options.max_control_points > 0 ? Status::limit_reached : Status::data_too_sparse, n);
  if (unmet == Status::reached) walk_down(sizes, n, static_cast<int>(fitter.least()));
  return {run.cut_or(unmet), sizes.best(), run.tried()};
}

}  // namespace knotfit
