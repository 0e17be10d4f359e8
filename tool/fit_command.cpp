#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <utility>

#include "applicable_options.h"
#include "cad_output.h"
#include "commands.h"
#include "exit_status.h"
#include "fit_report.h"
#include "fit_run.h"
#include "fit_writer.h"
#include "knotfit/exceptions.h"
#include "knotfit/io.h"
#include "knotfit/threads.h"
#include "mesh_outputs.h"
#include "options_json.h"
#include "outputs.h"
#include "remedy_words.h"
#include "signals.h"
#include "standard_streams.h"
#include "surface_file.h"
#include "terminal_progress.h"
namespace knotfit::tool {
namespace {

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
  default_tolerance = complete_choices(completed);
  return c;
}

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

// One fit of a call: there are as many as tolerances.
struct Planned {
  FitChoices choices;
  bool default_tolerance = false;
  std::vector<OutputFile> files;
};

// "face.json" as "face-2.json".
std::string numbered(const std::string& path, std::size_t number) {
  if (is_dash(path))
    throw InvalidInput("-o -: standard output takes one surface, and there are several tolerances");
  const std::filesystem::path p(path);
  return (p.parent_path() / fmt::format("{}-{}{}", p.stem().string(), number, p.extension().string()))
      .string();
}

std::vector<Planned> plan(const Arguments& arguments) {
  std::vector<Planned> runs;
  const std::size_t count = std::max<std::size_t>(1, arguments.tolerances.size());
  for (std::size_t k = 0; k < count; ++k) {
    Arguments one = arguments;
    one.tolerances.clear();
    if (count > 1) {
      one.choices.tolerance = arguments.tolerances[k];
      for (std::string& path : one.output.paths) path = numbered(path, k + 1);
    }
    Planned run;
    run.choices = complete(one, run.default_tolerance);
    run.files = plan_outputs(one.output, one.input);
    refuse_idle_output_options(options_of_outputs(one, run.files), run.files);
    runs.push_back(std::move(run));
  }
  return runs;
}

// Points with equal parameters are judged by the least.
const FitChoices& strictest(const std::vector<Planned>& runs) {
  const auto& least = *std::min_element(runs.begin(), runs.end(), [](const Planned& a, const Planned& b) {
    return a.choices.tolerance && b.choices.tolerance &&
           a.choices.tolerance->value < b.choices.tolerance->value;
  });
  return least.choices;
}

// Fits, writes, reports. \return the exit status
int run_one(const Planned& planned, FitInput input, const Raster& grid, const Arguments& arguments,
            const Control& control, TerminalProgress& terminal, std::chrono::steady_clock::time_point start) {
  const FitChoices& choices = planned.choices;
  correction_rounds(choices, input);  // what it refuses is no fault of the input
  FitRun run;
  try {
    run = fit_input(input, choices, {}, control);
    put_in_tool_words(run.result);
  } catch (const InvalidInput& e) {
    throw InvalidInput(input_name(arguments.input) + ": " + e.what());
  }
  FitResult& result = run.result;
  terminal.report({.stage = "write"});
  const std::vector<char> support = output_support(grid, input, result, choices);
  if (const auto without = std::count(support.begin(), support.end(), 0); without > 0)
    result.notes.push_back(fmt::format(
        "{} of the {} heights written lie beyond the data or in an opening of it: nodata; --fill-holes "
        "writes the surface there",
        without, support.size()));

  FitReport report{.result = result,
                   .input = input,
                   .choices = choices,
                   .corrected = run.correction(),
                   .default_tolerance = planned.default_tolerance,
                   .outputs = {}};
  int status = exit_status(result);
  if (result.surface.empty() || result.status == Status::failed) {
    terminal.clear();
    complain(result.message.empty() ? "no surface was found" : result.message);
  } else {
    const FitWriter writer(report, grid, support, arguments.output.force, arguments.reflections);
    const int written = write_each(
        planned.files, [&](const OutputFile& file) { writer.write(file); }, report.outputs);
    if (written != kReached) status = written;
    terminal.clear();
  }
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  report.peak_memory_bytes = peak_memory_bytes();
  if (arguments.json)
    print(report_to_json(report) + "\n");
  else if (!arguments.quiet)
    print_summary(report_to_text(report), planned.files);
  return status;
}

}  // namespace

int run_fit(const Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<Planned> runs = plan(arguments);
  const FitChoices& choices = strictest(runs);
  StopOnSignal stop;
  set_thread_count(arguments.threads);
  TerminalProgress terminal(!arguments.quiet, choices.time_limit.value_or(0));

  terminal.report({.stage = "read"});
  Control control = terminal.control(stop.token());
  control.time_limit = choices.time_limit.value_or(0);
  FitInput input = read_fit_input(arguments.input, choices, control);
  const std::vector<OutputFile>& files = runs.front().files;
  for (const OutputFile& file : files) {
    if (file.kind == OutputKind::mesh)
      check_surface_mesh(file, input.points.dimension, input.points.height_field);
    if (file.kind == OutputKind::cad)
      check_cad_output(file, input.points.dimension, input.points.height_field);
  }
  const Raster grid = asks_for(files, OutputKind::raster) ? output_grid(input, choices) : Raster{};
  const bool mapped = input.mesh.has_value();
  int status = kReached;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (stop.requested()) {
      terminal.clear();
      complain(k == 0 ? "stopped before there was a surface"
                      : fmt::format("stopped: {} of {} tolerances are left", runs.size() - k, runs.size()));
      return kStopped;
    }
    const auto begun = k == 0 ? start : std::chrono::steady_clock::now();
    // A map of a mesh, and the fits before, took their share of the time.
    const Control left = mapped || k > 0 ? time_left(control, start) : control;
    const int one = run_one(runs[k], k + 1 < runs.size() ? input : std::exchange(input, {}), grid, arguments,
                            left, terminal, begun);
    if (one != kReached && (status == kReached || one != kNotReached)) status = one;
  }
  return status;
}

}  // namespace knotfit::tool
