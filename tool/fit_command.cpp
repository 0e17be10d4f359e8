#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <limits>

#include "applicable_options.h"
#include "cad_output.h"
#include "cloud_input.h"
#include "commands.h"
#include "exit_status.h"
#include "feature_file.h"
#include "fit_report.h"
#include "knotfit/closest_point.h"
#include "knotfit/exceptions.h"
#include "knotfit/fit_sheared.h"
#include "knotfit/fit_surface.h"
#include "knotfit/grid_support.h"
#include "knotfit/io.h"
#include "knotfit/threads.h"
#include "mesh_outputs.h"
#include "options_json.h"
#include "outputs.h"
#include "remedy_words.h"
#include "sampling.h"
#include "signals.h"
#include "standard_streams.h"
#include "surface_file.h"
#include "terminal_progress.h"
#include "text_values.h"
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

// The options in force: the command line, then what --options stored, then the defaults.
FitChoices complete(const Arguments& arguments, bool& default_tolerance) {
  Arguments completed = arguments;
  FitChoices& c = completed.choices;
  if (!arguments.knots_from.empty()) {
    const Surface surface = read_one_surface(arguments.knots_from, {}).surface;
    const auto unit = [](const KnotVector& k) { return k.is_clamped() && k.first() == 0 && k.last() == 1; };
    if (!unit(surface.knots_u()) || !unit(surface.knots_v()))
      throw FileError(arguments.knots_from, "--knots-from wants knots that are clamped on [0,1]");
    c.knots = KnotSource{"", InteriorKnots{surface.knots_u().interior(), surface.knots_v().interior()}};
    if (!c.degree) c.degree = IntegerPair{surface.degree_u(), surface.degree_v()};
  }
  if (!arguments.options_from.empty()) add_stored_options(completed, arguments.options_from);
  if (c.control_points && c.control_points->first == 0) c.control_points.reset();
  add_usual_options(completed);
  if (!c.knots->given) check_method(c.knots->method);
  default_tolerance = !c.tolerance && !c.control_points && !c.knots->given;
  if (default_tolerance) c.tolerance = kDefaultTolerance;
  return c;
}

FitOptions fit_options(const FitChoices& c, const FitInput& input) {
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
  options.between = *c.between;
  return options;
}

// Rounds of parameter correction; 0: none.
int correction_rounds(const FitChoices& c, const FitInput& input) {
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

// The grid of an .asc output, checked before the fit: nothing is found out after minutes.
Raster output_grid(const FitInput& input, const FitChoices& c) {
  if (!input.points.height_field)
    throw InvalidInput("an .asc output holds heights over x, y: use --height-field, or leave it out");
  if (c.cell) return grid_over(input.points.map, *c.cell);
  if (!input.raster) throw InvalidInput("an .asc output of scattered points needs --cell SIZE");
  Raster grid = *input.raster;
  grid.z.clear();
  return grid;
}

/// \param support  of scattered points: 0 where they leave a node without data; empty: all nodes have heights
Raster fitted_heights(Raster grid, const FitResult& result, const FitInput& input, const FitChoices& c,
                      const std::vector<char>& support) {
  fill_heights(grid, result.surface, result.map);
  if (input.raster && !*c.fill_holes) keep_holes(grid, *input.raster);
  for (std::size_t k = 0; k < support.size(); ++k)
    if (support[k] == 0) grid.z[k] = std::numeric_limits<double>::quiet_NaN();
  return grid;
}

// A duplicate that was merged still gets its line: its error is measured like any other.
std::vector<double> residuals_of_every_point(const FitResult& result, const FitInput& input) {
  if (input.all_points.size() == 0) return result.errors;
  return recheck_errors(result.surface, input.all_points);
}

// A mesh, or the sample of a cloud with the points that it is judged by.
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

// Points that no triangle has have no parameters: their feet on the surface stand for them.
void find_loose_feet(FitInput& input, const Surface& surface) {
  if (!input.mesh || input.mesh->loose.empty() || surface.empty()) return;
  ClosestPoints closest = closest_points(surface, input.mesh->loose);
  input.mesh->loose_uv = std::move(closest.uv);
  input.mesh->loose_distance = std::move(closest.distances);
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

// Corrected parameters, the distance, the same signed by the normal, the error at the parameters, and where on the surface
// the distance is.
Table corrected_residuals(const MeshFit& fit, const MappedMesh& mapped) {
  std::vector<double> columns[10];
  const std::vector<double> at_parameters = recheck_errors(fit.result.surface, fit.points);
  for (Index k = 0; k < fit.points.size(); ++k) {
    for (int c = 0; c < 3; ++c) columns[c].push_back(fit.points.value(k)[c]);
    columns[3].push_back(fit.points.u(k));
    columns[4].push_back(fit.points.v(k));
    columns[5].push_back(fit.result.errors[k]);
    columns[6].push_back(fit.signed_distances[k]);
    columns[7].push_back(at_parameters[k]);
    for (int c = 0; c < 2; ++c) columns[8 + c].push_back(fit.foot_uv[2 * k + c]);
  }
  for (std::size_t k = 0; k < mapped.loose_distance.size();
       ++k) {  // points that no triangle has, at their feet
    for (int c = 0; c < 3; ++c) columns[c].push_back(mapped.loose[3 * k + c]);
    for (int c = 5; c < 8; ++c) columns[c].push_back(mapped.loose_distance[k]);
    for (int c = 0; c < 2; ++c) {
      columns[3 + c].push_back(mapped.loose_uv[2 * k + c]);
      columns[8 + c].push_back(mapped.loose_uv[2 * k + c]);
    }
  }
  Table table;
  const char* names[] = {"x",      "y",     "z", "u", "v", "error", "distance", "error_at_parameters",
                         "foot_u", "foot_v"};
  for (int c = 0; c < 10; ++c) table.add(names[c], std::move(columns[c]));
  return table;
}

class FitWriter {
 public:
  FitWriter(const FitReport& report, const Raster& grid, const std::vector<char>& support, bool force,
            bool reflections)
      : report_(report), grid_(grid), support_(support), force_(force), reflections_(reflections) {}

  void write(const OutputFile& file) const {
    const FitResult& result = report_.result;
    const FitInput& input = report_.input;
    switch (file.kind) {
      case OutputKind::surface:
        return write_text_file(file.path, force_,
                               to_json({.surface = result.surface,
                                        .map = result.map,
                                        .height_field = result.height_field,
                                        .options = options_to_json(report_.choices),
                                        .result = stored_result(report_)}));
      case OutputKind::table: {
        if (report_.corrected != nullptr)
          return write_text_file(file.path, force_,
                                 to_csv(corrected_residuals(*report_.corrected, *input.mesh)));
        const std::vector<double> errors = errors_of_all(result, input);
        return write_file(file.path, force_,
                          [&](std::ostream& out) { write_residuals(out, points_of_all(input), errors); });
      }
      case OutputKind::raster:
        return write_raster_file(file.path, force_,
                                 fitted_heights(grid_, result, input, report_.choices, support_));
      case OutputKind::mesh:
        return write_surface_mesh(file, force_, result.surface, result.map, result.height_field,
                                  *report_.choices.samples, &input.points, result.errors);
      case OutputKind::cad:
        return write_cad_file(file, force_, result.surface, result.map, result.height_field,
                              report_.choices.cad);
      case OutputKind::picture:
        return write_picture_file(file, force_, picture());
    }
  }

 private:
  PictureInput picture() const {
    const FitResult& result = report_.result;
    PictureInput p;
    p.surface = &result.surface;
    p.points = &report_.input.points;
    if (report_.corrected != nullptr) {
      // Errors are distances: drawn where on the surface they are.
      feet_ = report_.input.points;
      feet_.uv = report_.corrected->foot_uv;
      p.points = &feet_;
      for (const double d : report_.corrected->signed_distances) p.signed_errors.push_back(-d);  // S - P
      p.fold_places = report_.corrected->correction.folds.places;
    } else {
      p.signed_errors = signed_errors(result.surface, report_.input.points);
    }
    p.tolerance = result.tolerance;
    p.title = std::filesystem::path(report_.input.summary.path).filename().string() + ", " + verdict(report_);
    p.subtitle = "knotfit fit " + options_to_text(report_.choices);
    p.thin_places = result.between.thin_places;
    if (const auto& mapped = report_.input.mesh; mapped && !parameters_of(*mapped).empty()) {
      const std::vector<double>& uv =
          report_.corrected != nullptr && !report_.corrected->correction.uv.empty()
              ? report_.corrected->correction.uv
              : parameters_of(*mapped);
      for (const Opening& o : mapped->openings)
        for (const std::int32_t f : o.faces) {
          const auto& t = mapped->mesh.faces[f];
          p.openings.push_back({uv[2 * t[0]], uv[2 * t[0] + 1], uv[2 * t[1]], uv[2 * t[1] + 1], uv[2 * t[2]],
                                uv[2 * t[2] + 1]});
        }
    }
    p.reflections = reflections_;
    return p;
  }

  const FitReport& report_;
  const Raster& grid_;
  const std::vector<char>& support_;
  bool force_, reflections_;
  mutable ParameterizedPoints feet_;  ///< what a picture draws
};

int exit_status(const FitResult& result) {
  switch (result.status) {
    case Status::stopped:
      return kStopped;
    case Status::failed:
    case Status::not_run:
      return kOther;
    case Status::fixed_size:
      return kReached;
    case Status::time_limit:  // the search did not end, whatever it has
      return kNotReached;
    default:
      return result.reached ? kReached : kNotReached;
  }
}

// Those that act on outputs of their kind alone. The others are stored in the surface's JSON and in --json, to be
// repeated where such an output is asked for.
std::vector<std::string> options_of_outputs(const Arguments& arguments,
                                            const std::vector<OutputFile>& files) {
  std::vector<std::string> given = arguments.choices.input.given;
  if (arguments.json || asks_for(files, OutputKind::surface))
    std::erase_if(given, [](const std::string& option) { return option != "--reflections"; });
  return given;
}

void complain(const std::string& message) {
  std::fprintf(stderr, "knotfit: %s\n", message.c_str());
}

}  // namespace

int run_fit(const Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  bool default_tolerance = false;
  const FitChoices choices = complete(arguments, default_tolerance);
  const std::vector<OutputFile> files = plan_outputs(arguments.output, arguments.input);
  refuse_idle_output_options(options_of_outputs(arguments, files), files);
  StopOnSignal stop;
  set_thread_count(arguments.threads);
  TerminalProgress terminal(!arguments.quiet, choices.time_limit.value_or(0));

  terminal.report({.stage = "read"});
  Control control = terminal.control(stop.token());
  control.time_limit = choices.time_limit.value_or(0);
  FitInput input = read_fit_input(arguments.input, choices, control);
  for (const OutputFile& file : files) {
    if (file.kind == OutputKind::mesh)
      check_surface_mesh(file, input.points.dimension, input.points.height_field);
    if (file.kind == OutputKind::cad)
      check_cad_output(file, input.points.dimension, input.points.height_field);
  }
  const Raster grid = asks_for(files, OutputKind::raster) ? output_grid(input, choices) : Raster{};
  if (stop.requested()) {
    terminal.clear();
    complain("stopped before there was a surface");
    return kStopped;
  }

  // A map of a mesh took its share of the time.
  if (input.mesh) control = time_left(control, start);
  const int rounds = correction_rounds(choices, input);
  if (rounds == 0 && *choices.fairness != 1)
    throw InvalidInput(
        fmt::format("--fairness {} acts in a correction of parameters, and there is none: see --correct",
                    *choices.fairness));
  FitResult result;
  MeshFit corrected;
  try {
    if (rounds > 0) {
      corrected = fit_corrected(
          input, fit_options(choices, input),
          {.rounds = rounds, .fairness = *choices.fairness * CorrectionOptions{}.fairness}, control);
      result = corrected.result;
      input.points = corrected.points;
      input.all_points = {};
    } else if (choices.shear->asked()) {
      if (choices.feature_file)
        throw InvalidInput("--feature-file is over the parameters as they are: leave out --shear");
      std::optional<Shear> shear;
      if (!choices.shear->automatic) shear = Shear{choices.shear->u, choices.shear->v};
      ShearedFit fit = fit_sheared(input.points, fit_options(choices, input), shear, control);
      result = std::move(fit.result);
      if (result.map.sheared() && input.all_points.size() > 0)
        input.all_points = sheared(input.all_points, result.map.shear_u, result.map.shear_v);
      input.points = std::move(fit.points);
    } else {
      result = fit_surface(input.points, fit_options(choices, input), control);
    }
    find_loose_feet(input, result.surface);
    judge_all_points(result, errors_of_all(result, input));
    put_in_tool_words(result);
  } catch (const InvalidInput& e) {
    throw InvalidInput(input_name(arguments.input) + ": " + e.what());
  }
  terminal.report({.stage = "write"});
  std::vector<char> support;
  if (grid.rows > 0 && !input.raster && !*choices.fill_holes && !result.surface.empty()) {
    support = grid_support(input.points, grid);
    if (const auto without = std::count(support.begin(), support.end(), 0); without > 0)
      result.notes.push_back(fmt::format(
          "{} of the {} heights written lie beyond the data or in an opening of it: nodata; --fill-holes "
          "writes the surface there",
          without, support.size()));
  }

  FitReport report{.result = result,
                   .input = input,
                   .choices = choices,
                   .corrected = corrected.signed_distances.empty() ? nullptr : &corrected,
                   .default_tolerance = default_tolerance,
                   .outputs = {}};
  int status = exit_status(result);
  if (result.surface.empty() || result.status == Status::failed) {
    terminal.clear();
    complain(result.message.empty() ? "no surface was found" : result.message);
  } else {
    const FitWriter writer(report, grid, support, arguments.output.force, arguments.reflections);
    const int written = write_each(
        files, [&](const OutputFile& file) { writer.write(file); }, report.outputs);
    if (written != kReached) status = written;
    terminal.clear();
  }
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  report.peak_memory_bytes = peak_memory_bytes();
  if (arguments.json)
    print(report_to_json(report) + "\n");
  else if (!arguments.quiet)
    print_summary(report_to_text(report), files);
  return status;
}

}  // namespace knotfit::tool
