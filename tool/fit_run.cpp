#include "fit_run.h"

#include <fmt/format.h>

#include "feature_file.h"
#include "knotfit/closest_point.h"
#include "knotfit/exceptions.h"
#include "knotfit/fit_sheared.h"
#include "options_json.h"
namespace knotfit::tool {
namespace {

void check_method(const std::string& method) {
  std::string names;
  for (const PlacementMethod& m : placement_methods()) {
    if (m.name == method) return;
    names += (names.empty() ? "" : ", ") + std::string(m.name);
  }
  throw InvalidInput(fmt::format("--knots: there is no method '{}'; there are {}", method, names));
}

// A mesh, or the sample of one or of a cloud with all the points that it is judged by.
MeshFit fit_corrected(FitInput& input, const FitOptions& options, const CorrectionOptions& how,
                      const Control& control) {
  MappedMesh& mapped = *input.mesh;
  if (mapped.sampled == nullptr) return fit_mesh(mapped.mesh, *mapped.map, options, how, control);
  const Sampled& sampled = *mapped.sampled;
  SampleFit fit = fit_sample(sampled.source, sampled.most, sampled.map, options, how, control);
  take_map(mapped, std::move(fit.map), sampled.line);
  mapped.loose = sampled.loose;
  if (!sampled.line.empty())
    for (Index& k : fit.fit.points.source) k = sampled.line[k - 1];
  input.summary.points = fit.fit.points.size();
  return std::move(fit.fit);
}

FitOptions fit_options(const FitChoices& c, const FitInput& input, const FitExtras& extras) {
  FitOptions options;
  if (input.mesh && input.mesh->map) options.span_ratio = input.mesh->map->quality.aspect;
  if (c.tolerance)
    options.tolerance = ToleranceRequest{.value = c.tolerance->value,
                                         .relative = c.tolerance->relative,
                                         .measure = c.measure->measure,
                                         .share = c.measure->share};
  if (c.control_points) {
    options.control_points_u = c.control_points->first;
    options.control_points_v = c.control_points->second;
  }
  options.knots = c.knots->given;
  if (!c.knots->given) options.method = c.knots->method;
  options.route = *c.refine;
  options.effort = *c.effort;
  options.guard = *c.guard;
  options.engine = *c.engine;
  options.degree_auto = c.degree->first == 0;
  if (!options.degree_auto) {
    options.degree_u = c.degree->first;
    options.degree_v = c.degree->second;
  }
  options.max_control_points = static_cast<Index>(c.max_control_points.value_or(0));
  options.max_fits = c.max_fits.value_or(FitOptions{}.max_fits);
  options.evaluations = c.evaluations.value_or(FitOptions{}.evaluations);
  options.smoothing = *c.smoothing;
  options.feature = *c.feature;
  if (c.feature_file) options.user_features = read_feature_file(*c.feature_file, input.points.map);
  if (!extras.features.empty()) options.user_features = extras.features;
  options.between = *c.between;
  return options;
}

// A duplicate that was merged still gets its line: its error is measured like any other.
std::vector<double> residuals_of_every_point(const FitResult& result, const FitInput& input) {
  if (input.all_points.size() == 0) return result.errors;
  return recheck_errors(result.surface, input.all_points);
}

// Points that no triangle has have no parameters: their feet on the surface stand for them.
void find_loose_feet(FitInput& input, const Surface& surface) {
  if (!input.mesh || input.mesh->loose.empty() || surface.empty()) return;
  ClosestPoints closest = closest_points(surface, input.mesh->loose);
  input.mesh->loose_uv = std::move(closest.uv);
  input.mesh->loose_distance = std::move(closest.distances);
}

// Whatever the fairness.
int rounds_of(const FitChoices& c, const FitInput& input) {
  const bool mapped = input.mesh && input.mesh->map && (*c.correct > 0 || input.points.weights.empty());
  const bool plain =
      *c.refine == RefineRoute::insert || c.degree->first == 0;  // made for errors at the parameters
  if (*c.correct <= 0) return *c.correct < 0 && mapped && !plain ? CorrectionOptions{}.rounds : 0;
  if (!mapped)
    throw InvalidInput(
        "--correct needs points or a mesh in space that are mapped: height fields keep their parameters "
        "(--new-parameters maps a mesh that has some)");
  if (!input.points.weights.empty())
    throw InvalidInput("--correct knows no weights of the points: leave column w out, with - in --columns");
  if (plain) throw InvalidInput("--correct goes with --refine search and given degrees");
  return *c.correct;
}

}  // namespace

int correction_rounds(const FitChoices& choices, const FitInput& input) {
  const int rounds = rounds_of(choices, input);
  if (rounds == 0 && *choices.fairness != 1)
    throw InvalidInput(
        fmt::format("--fairness {} acts in a correction of parameters, and there is none: see --correct",
                    *choices.fairness));
  return rounds;
}

bool complete_choices(Arguments& arguments) {
  if (!arguments.tolerances.empty())
    throw InvalidInput("several tolerances, where one fit is asked for: give one");
  FitChoices& c = arguments.choices;
  if (c.control_points && c.control_points->first == 0) c.control_points.reset();
  add_usual_options(arguments);
  if (!c.knots->given) check_method(c.knots->method);
  const bool default_tolerance = !c.tolerance && !c.control_points && !c.knots->given;
  if (default_tolerance) c.tolerance = kDefaultTolerance;
  return default_tolerance;
}

FitRun fit_input(FitInput& input, const FitChoices& choices, const FitExtras& extras,
                 const Control& control) {
  const int rounds = correction_rounds(choices, input);
  const FitOptions options = fit_options(choices, input, extras);
  FitRun run;
  if (rounds > 0) {
    run.corrected = fit_corrected(
        input, options, {.rounds = rounds, .fairness = *choices.fairness * CorrectionOptions{}.fairness},
        control);
    run.result = run.corrected.result;
    run.is_corrected = !run.corrected.signed_distances.empty();
    input.points = run.corrected.points;
    input.all_points = {};
  } else if (choices.shear->asked()) {
    if (choices.feature_file || !extras.features.empty())
      throw InvalidInput("--feature-file is over the parameters as they are: leave out --shear");
    std::optional<Shear> shear;
    if (!choices.shear->automatic) shear = Shear{choices.shear->u, choices.shear->v};
    ShearedFit fit = fit_sheared(input.points, options, shear, control);
    run.result = std::move(fit.result);
    if (run.result.map.sheared() && input.all_points.size() > 0)
      input.all_points = sheared(input.all_points, run.result.map.shear_u, run.result.map.shear_v);
    input.points = std::move(fit.points);
  } else {
    run.result = fit_surface(input.points, options, control);
  }
  find_loose_feet(input, run.result.surface);
  judge_all_points(run.result, errors_of_all(run.result, input));
  return run;
}

std::vector<double> errors_of_all(const FitResult& result, const FitInput& input) {
  std::vector<double> errors = residuals_of_every_point(result, input);
  if (input.mesh)
    errors.insert(errors.end(), input.mesh->loose_distance.begin(), input.mesh->loose_distance.end());
  return errors;
}

// All of them, with those that no triangle has.
ParameterizedPoints points_of_all(const FitInput& input) {
  ParameterizedPoints all = input.every_point();
  if (!input.mesh || input.mesh->loose_uv.empty() || all.dimension != 3) return all;
  const auto count = static_cast<Index>(input.mesh->loose_distance.size());
  for (Index k = 0; k < count; ++k) {
    const auto [a, b] = std::pair{input.mesh->loose_uv[2 * k], input.mesh->loose_uv[2 * k + 1]};
    all.uv.insert(all.uv.end(), {a, b});
    all.values.insert(all.values.end(), &input.mesh->loose[3 * k], &input.mesh->loose[3 * k] + 3);
    if (!all.weights.empty()) all.weights.push_back(1);
    if (!all.source.empty()) all.source.push_back(0);
  }
  return all;
}

}  // namespace knotfit::tool
