#include "pipeline/choose_knots.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/deadline.h"
#include "fit/fit_problem.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

/// At the degrees of the options.
Chosen choose_at_degree(const ParameterizedPoints& inside, const FitOptions& options,
                        const Tolerance& tolerance, double noise, const Keeping& keeping,
                        const Control& control) {
  Chosen chosen;
  chosen.method = options.method;
  chosen.degree_u = options.degree_u;
  chosen.degree_v = options.degree_v;
  if (options.knots) {
    chosen.knots = *options.knots;
    chosen.method = "given";
    return chosen;
  }
  if (options.control_points_u > 0 || options.control_points_v > 0) {
    PlacementOptions place;
    static_cast<KnotOptions&>(place) = static_cast<const KnotOptions&>(options);
    place.interior_u = options.control_points_u - options.degree_u - 1;
    place.interior_v = options.control_points_v - options.degree_v - 1;
    place.energy = keeping.energy;
    if (tolerance.value > 0) place.keep_by = {0, tolerance.measure, tolerance.share};
    const Placement placement = place_knots(options.method, inside, place, control);
    chosen.knots = placement.knots;
    chosen.criterion = placement.criterion;
    chosen.fits = placement.fits;
    chosen.sample = placement.sample;
    chosen.notes = placement.notes;
    if (placement.status == PlacementStatus::stopped)
      chosen.status = control.stop.stop_requested() ? Status::stopped : Status::time_limit;
    return chosen;
  }
  RefineOptions refine;
  static_cast<SearchOptions&>(refine) = static_cast<const SearchOptions&>(options);
  refine.tolerance = tolerance;
  refine.noise = noise;
  refine.energy = keeping.energy;
  refine.sites = keeping.sites;
  RefineResult found = refine_to_tolerance(inside, refine, control);
  chosen.knots = std::move(found.knots);
  chosen.metric = std::move(found.metric);
  chosen.status = found.status;
  chosen.error = found.error;
  chosen.swings = found.swings;
  chosen.tried = std::move(found.tried);
  chosen.fits = found.fits;
  chosen.fill_points = found.fill_points;
  chosen.sample = found.sample;
  chosen.notes = std::move(found.notes);
  if (!found.least_squares) chosen.surface = std::move(found.surface);
  chosen.method = found.method;
  return chosen;
}

Index size_of(const Chosen& c) {
  return (static_cast<Index>(c.knots.u.size()) + c.degree_u + 1) *
         (static_cast<Index>(c.knots.v.size()) + c.degree_v + 1);
}

bool better(const Chosen& a, const Chosen& b) {
  const bool ra = a.status == Status::reached, rb = b.status == Status::reached;
  if (ra != rb) return ra;
  if (ra && size_of(a) != size_of(b)) return size_of(a) < size_of(b);
  if (a.swings != b.swings) return !a.swings;
  return a.error < b.error;
}

/// Tries degrees one after the other and keeps the best.
class Degrees {
 public:
  Degrees(const ParameterizedPoints& inside, const FitOptions& options, const Tolerance& tolerance,
          double noise, const Keeping& keeping, const Control& control)
      : inside_(inside),
        options_(options),
        tolerance_(tolerance),
        noise_(noise),
        keeping_(keeping),
        control_(control),
        deadline_(control) {}

  void try_degrees(int degree_u, int degree_v) {
    FitOptions options = options_;
    options.degree_u = degree_u;
    options.degree_v = degree_v;
    const Index patch = Index{degree_u + 1} * (degree_v + 1);
    const bool fixed = options.control_points_u > 0;
    if (patch > inside_.size() || control_.stop.stop_requested()) return;
    if (fixed && (options.control_points_u <= degree_u || options.control_points_v <= degree_v)) return;
    if (best_ && deadline_.over()) return;
    // A larger surface than the best so far is of no use.
    if (!fixed && best_ && best_->status == Status::reached) options.max_control_points = size_of(*best_);
    if (options.max_control_points > 0 && options.max_control_points < patch) return;
    Chosen chosen = choose_at_degree(inside_, options, tolerance_, noise_, keeping_, deadline_.left());
    if (fixed) {
      LeastSquaresOptions fit;
      fit.smoothing = options.smoothing;
      fit.energy = keeping_.energy;
      FitProblem problem(inside_, degree_u, degree_v, fit);
      problem.solve(chosen.knots);
      chosen.error = tolerance_.value > 0 ? problem.measured(tolerance_) : problem.rms();
      chosen.fits += problem.fits();
    }
    fits_ += chosen.fits;
    const bool held = fixed || chosen.status == Status::reached;
    tried_ += fmt::format("{}{}x{}: {}", tried_.empty() ? "" : ", ", degree_u, degree_v,
                          !held   ? "no better"
                          : fixed ? fmt::format("error {:.3g}", chosen.error)
                                  : fmt::format("{} control points", size_of(chosen)));
    if (!best_ || better(chosen, *best_)) best_ = std::move(chosen);
  }
  const Chosen& best() const { return *best_; }
  Chosen result() {
    best_->fits = fits_;
    best_->notes.push_back("degrees tried, " + tried_);
    return std::move(*best_);
  }

 private:
  const ParameterizedPoints& inside_;
  const FitOptions& options_;
  const Tolerance& tolerance_;
  double noise_;
  const Keeping& keeping_;
  const Control& control_;
  Deadline deadline_;
  std::optional<Chosen> best_;
  long fits_ = 0;
  std::string tried_;
};

}  // namespace

Chosen choose_knots(const ParameterizedPoints& inside, const FitOptions& options, const Tolerance& tolerance,
                    double noise, const Keeping& keeping, const Control& control) {
  if (!options.degree_auto || options.knots)
    return choose_at_degree(inside, options, tolerance, noise, keeping, control);
  constexpr int kDegrees[] = {3, 4, 5};
  Degrees degrees(inside, options, tolerance, noise, keeping, control);
  for (int m : kDegrees) degrees.try_degrees(m, m);
  const int best = degrees.best().degree_u;
  for (int m : kDegrees) {
    if (m == best) continue;
    degrees.try_degrees(best, m);
    degrees.try_degrees(m, best);
  }
  return degrees.result();
}

}  // namespace knotfit
