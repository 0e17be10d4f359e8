#include <fmt/format.h>

#include <algorithm>
#include <chrono>

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
