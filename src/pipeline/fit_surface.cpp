#include "knotfit/fit_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "base/deadline.h"
#include "data/crowding.h"
#include "fit/fit_problem.h"
#include "knotfit/exceptions.h"
#include "knotfit/remedy.h"
#include "pipeline/choose_knots.h"
#include "pipeline/message.h"
#include "pipeline/request.h"
#include "pipeline/verdict.h"
#include "place/shares.h"
#include "verify/local_reference.h"
#include "verify/swing_limits.h"
#include "verify/swings.h"
namespace knotfit {
namespace {

/// The surface of the knots chosen: their least squares, with the refinement step that takes the smoothing
/// floor's share out, or the control points the search found. The problem holds it.
bool fit_chosen(FitProblem& problem, const Chosen& chosen, const Tolerance& tolerance) {
  if (!problem.solve(chosen.knots)) return false;
  if (chosen.surface) {
    problem.evaluate(chosen.knots, chosen.surface->net());
    return true;
  }
  // Where the search's own surface holds the tolerance and the refined one by a hair does not.
  if (tolerance.value > 0 && chosen.status == Status::reached &&
      problem.measured(tolerance) > tolerance.value) {
    problem.set_refinement_steps(0);
    return problem.solve(chosen.knots);
  }
  return true;
}

/// The check of a surface as it is handed out: residuals measured on a path of their own, finite, and what
/// the fit says they are. Fills errors and recheck_difference. \return false where it fails
bool check(FitResult& result, const ParameterizedPoints& points, const std::vector<double>& fitted,
           const Frame& frame) {
  result.errors = recheck_errors(result.surface, points);
  bool sound = true;
  for (std::size_t k = 0; k < fitted.size(); ++k) {
    if (!std::isfinite(result.errors[k])) sound = false;
    result.recheck_difference =
        std::max(result.recheck_difference, std::abs(result.errors[k] - fitted[k] * frame.scale()));
  }
  // Both paths round: a few ulps of the data, and of the net times the degree.
  const double rounding = 64 * (frame.rounding() + result.surface.scale() * 1.2e-16) *
                              (result.surface.degree_u() + result.surface.degree_v()) +
                          1e-10 * frame.scale();
  return sound && result.recheck_difference <= rounding;
}

/// What is left of the time for a look between the points, which a cut search is given a few seconds for.
Control last_look(const Control& control, const Deadline& deadline) {
  constexpr double kLeast = 5;
  Control left = deadline.left(control);
  if (left.time_limit > 0) left.time_limit = std::max(left.time_limit, kLeast);
  return left;
}

/// Progress in the data's unit, as the result has it.
Control outside(const Control& control, double scale) {
  Control scaled = control;
  if (control.progress)
    scaled.progress = [report = control.progress, scale](const Progress& inside) {
      Progress progress = inside;
      for (double* x : {&progress.error, &progress.tolerance})
        if (*x > 0) *x *= scale;
      report(progress);
    };
  return scaled;
}

/// Knots chosen and their surface, with what it does between the points. Works in the frame.
struct Fitted {
  Chosen chosen;
  std::optional<FitProblem> problem;  ///< holds the surface
  bool solved = false;
  bool plain = true;  ///< the least squares of the knots, without an energy
  SwingReport swings;

  Fitted(const ParameterizedPoints& inside, const FitOptions& options, const Tolerance& tolerance,
         double noise, const Keeping& keeping, const Control& control)
      : chosen(choose_knots(inside, options, tolerance, noise, keeping, control)) {
    solve(inside, options, tolerance, keeping, nullptr);
    const bool lost = chosen.status == Status::reached && problem->measured(tolerance) > tolerance.value;
    if (!keeping.energy || chosen.surface || problem->on_grid() || (solved && !swings.swings && !lost))
      return;
    plain = false;
    solve(inside, options, tolerance, keeping, keeping.energy);
  }

 private:
  void solve(const ParameterizedPoints& inside, const FitOptions& options, const Tolerance& tolerance,
             const Keeping& keeping, std::shared_ptr<const DataEnergy> energy) {
    LeastSquaresOptions fit;
    fit.smoothing = options.smoothing;
    fit.use_grid = !chosen.surface;
    fit.energy = std::move(energy);
    problem.emplace(inside, chosen.degree_u, chosen.degree_v, fit);
    solved = fit_chosen(*problem, chosen, tolerance);
    if (!solved) return;
    const double unit = tolerance.value > 0 ? tolerance.value : problem->rms();
    if (unit > 0) swings = keeping.sites->measure(problem->surface(), problem->errors(), unit);
  }
};

/// By that name a method of the table, and not "given" or "insert".
bool moves_knots(std::string_view name) {
  return std::any_of(placement_methods().begin(), placement_methods().end(),
                     [&](const PlacementMethod& m) { return m.name == name && m.traits.moves_knots; });
}

/// The same size on uniform knots and on those of the error model.
void compare(FitResult& result, FitProblem& problem, const ParameterizedPoints& inside,
             const Tolerance& tolerance, double scale) {
  const Surface& s = result.surface;
  PlacementOptions options;
  options.degree_u = s.degree_u();
  options.degree_v = s.degree_v();
  options.interior_u = static_cast<int>(s.size_u()) - s.degree_u() - 1;
  options.interior_v = static_cast<int>(s.size_v()) - s.degree_v() - 1;
  options.keep_by = {0, tolerance.measure, tolerance.share};
  options.rounds = 8;
  const double order = std::min(s.degree_u(), s.degree_v()) + 1;
  auto measure = [&](const InteriorKnots& knots) {
    Comparison c;
    if (!problem.solve(knots)) return c;
    c.error = problem.measured({1, tolerance.measure, tolerance.share}) * scale;
    const double aim = result.tolerance > 0 && result.reached ? result.tolerance : result.measured;
    if (aim > 0)
      c.control_points = static_cast<double>(s.control_point_count()) * std::pow(c.error / aim, 2 / order);
    return c;
  };
  result.against_uniform = measure({uniform_knots(options.interior_u), uniform_knots(options.interior_v)});
  const Placement model = place_knots("error-model", inside, options);
  result.fits += model.fits + 2;
  result.against_error_model = measure(model.knots);
}

/// The honest numbers, in the frame, where heights of 1e8 cost the reference no digits.
BetweenReport between_points(const Surface& inside_surface, const ParameterizedPoints& inside,
                             std::shared_ptr<const IndexedPoints> indexed, double unit,
                             const InteriorKnots& metric, double scale, const Control& control) {
  BetweenOptions options;
  options.metric_u = metric.u;
  options.metric_v = metric.v;
  options.indexed = std::move(indexed);
  BetweenReport report = measure_between(inside_surface, inside, unit / scale, options, control);
  for (std::optional<double>* x : {&report.between, &report.bound})
    if (*x) **x *= scale;
  report.noise *= scale;
  for (ThinPlace& place : report.thin_places) place.error_bar *= scale;
  return report;
}

}  // namespace

FitResult fit_surface(const ParameterizedPoints& points, const FitOptions& options, const Control& given) {
  const Deadline deadline(given);
  check_requirements(points, options);

  FitResult result;
  result.map = points.map;
  result.height_field = points.height_field;
  const Frame frame(points);
  const Control control = outside(given, frame.scale());
  const Request request =
      make_request(options.tolerance, has_size_or_knots(options), points, frame.rounding(), frame.scale());
  const Tolerance& tolerance = request.inside;
  result.diagonal = request.diagonal;
  result.asked = request.asked;
  result.tolerance = request.asked.value;

  const ParameterizedPoints inside = frame.inside(points);
  const auto indexed = std::make_shared<const IndexedPoints>(inside);
  note_duplicates(*indexed, result.notes);
  const double crowded = points.dimension == 3 && !points.height_field ? crowded_share(*indexed) : 0;
  Keeping keeping;
  keeping.sites = std::make_shared<const verify::SwingSites>(inside, verify::kSearchPlaces, indexed);
  if (request.searched) {
    const double noise = verify::find_noise(*indexed);
    if (noise > 0.02 * tolerance.value) result.noise = noise * frame.scale();
    keeping.energy = make_data_energy(inside, energy_scale(tolerance), indexed);
  }
  auto fitted = std::make_unique<Fitted>(inside, options, tolerance, result.noise / frame.scale(), keeping,
                                         deadline.left(control));
  const bool in_time = !deadline.over();
  if (!request.searched && in_time && fitted->solved && fitted->swings.swings &&
      !fitted->problem->on_grid()) {
    // A size or knots of the user's, whose least squares swing: the same held to the data by its energy, for errors of the
    // size that it leaves.
    keeping.energy = own_energy(inside, tolerance, fitted->problem->rms(), indexed);
    auto held = std::make_unique<Fitted>(inside, options, tolerance, 0.0, keeping, deadline.left(control));
    held->chosen.fits += fitted->chosen.fits + fitted->problem->fits();
    if (held->solved && held->swings.largest < fitted->swings.largest) {
      held->chosen.notes.push_back(held_note(fitted->swings.largest, held->swings.largest, "surface"));
      fitted.swap(held);
    }
  }
  Chosen& chosen = fitted->chosen;
  FitProblem& problem = *fitted->problem;
  result.fits = chosen.fits + problem.fits();
  result.method = chosen.method;
  result.effort = options.effort;
  result.criterion = chosen.criterion;
  result.tried = std::move(chosen.tried);
  result.fill_points = chosen.fill_points;
  result.sample = chosen.sample;
  result.notes.insert(result.notes.end(), chosen.notes.begin(), chosen.notes.end());
  if (!fitted->solved) {
    result.status = Status::failed;
    result.message =
        "no surface: the normal equations of these knots cannot be solved; ask for fewer control points";
    return result;
  }
  const Surface inside_surface = problem.surface();
  result.surface = frame.outside(inside_surface);
  result.least_squares = !chosen.surface && fitted->plain;
  result.condition = problem.condition();
  result.smoothing = problem.smoothing();
  result.empty_cells = problem.empty_cells();
  if (!check(result, points, problem.errors(), frame)) {
    result.status = Status::failed;
    result.message =
        fmt::format("the surface failed its own check: errors measured apart from the fit differ by {:.3g}",
                    result.recheck_difference);
    return result;
  }
  result.swings = fitted->swings;
  for (double* x : {&result.swings.distance, &result.swings.beyond_box}) *x *= frame.scale();
  judge(result, points, chosen.status, request.with_tolerance(), request.searched);
  if (result.empty_cells > 0)
    result.notes.push_back(
        fmt::format("{} knot cells hold no point: {} shapes the surface there", result.empty_cells,
                    result.least_squares ? "the smoothing floor" : "the energy that holds it to the data"));
  if (moves_knots(chosen.method) && !deadline.over())
    compare(result, problem, inside, tolerance, frame.scale());
  if (options.between && !deadline.stopped()) {
    const double unit =
        options.tolerance ? result.tolerance : std::max(result.error.max, 16 * frame.rounding());
    if (unit > 0)
      result.between = between_points(inside_surface, inside, indexed, unit, chosen.metric, frame.scale(),
                                      last_look(control, deadline));
  }
  if (crowded > kCrowded)
    result.notes.insert(
        result.notes.begin(),
        fmt::format(
            "{:.2g} % of the points stand far closer in the parameters than on the surface: parameters that "
            "squeeze parts of it need many control points; {} moves them with the surface, which "
            "then needs far fewer",
            100 * crowded, remedy_text(Remedy::correct)));
  note_swings(result);
  result.message = message_of(result, points.size());
  return result;
}

}  // namespace knotfit
