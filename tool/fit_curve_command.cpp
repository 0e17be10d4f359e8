#include <chrono>
#include <cstdio>
#include <tuple>

#include "applicable_options.h"
#include "commands.h"
#include "curve_options.h"
#include "curve_report.h"
#include "exit_status.h"
#include "feature_file.h"
#include "input.h"
#include "knotfit/compare.h"
#include "knotfit/exceptions.h"
#include "knotfit/io.h"
#include "knotfit/parameterize_curve.h"
#include "knotfit/threads.h"
#include "remedy_words.h"
#include "signals.h"
#include "standard_streams.h"
#include "terminal_progress.h"
namespace knotfit::tool {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

CurvePoints read_points(const Arguments& arguments, Reading& reading) {
  const FitChoices& c = arguments.choices;
  ReadOptions read = read_options(c.input);
  read.places = read.curve = true;  // x, y alone
  read.block = arguments.block;
  const SourceData data = read_source(arguments.input, read);
  refuse_idle_reading(data, arguments.input, c.input);
  reading = reading_of(data);
  try {
    return curve_points_of(data, c.spacing.value_or(RowSpacing::chord), arguments.closed, arguments.function);
  } catch (const InvalidInput& e) {
    throw InvalidInput(input_name(arguments.input) + ": " + e.what());
  }
}

/// Method by method, each a row; Ctrl-C keeps those that ended.
int compare(const Arguments& arguments, const CurvePoints& points, const CurveFitOptions& options,
            const Reading& reading, const Control& control, TerminalProgress& terminal) {
  CompareOptions named;
  named.fit.user_features = options.user_features;
  named.methods = arguments.methods;
  named.sizes = {{4, 4}};
  std::vector<CurveRow> rows;
  for (const CompareRow& job : comparison_rows(named)) {
    terminal.report({.stage = job.method});
    CurveFitOptions one = options;
    std::tie(one.method, one.feature) = split_method(job.method, options.feature);
    // A measure that is named goes before one that is given for all.
    if (job.method.find(':') != std::string::npos && !job.method.ends_with(":given")) one.user_features = {};
    CurveRow row;
    row.method = job.method;
    const auto start = std::chrono::steady_clock::now();
    try {
      row.result = fit_curve(points, one, control);
      put_in_tool_words(row.result);
      if (row.result.status == Status::failed) row.failure = row.result.message;
    } catch (const InvalidInput& e) {
      row.failure = in_tool_words(e.what());
    }
    row.seconds = seconds_since(start);
    if (control.stop.stop_requested()) break;
    rows.push_back(std::move(row));
  }
  terminal.clear();
  const bool stopped = control.stop.stop_requested();
  if (arguments.json)
    print(curve_rows_json(rows, arguments, reading, stopped) + "\n");
  else if (!arguments.quiet)
    print(curve_table(rows) + columns_to_text(reading) + notes_to_text(reading));
  return stopped ? kStopped : kReached;
}

}  // namespace

int run_fit_curve(const Arguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  const std::vector<OutputFile> files = plan_outputs(arguments.output, arguments.input);
  for (const OutputFile& file : files) check_curve_output(file);
  refuse_idle_output_options(arguments.choices.input.given, files);
  if (!arguments.methods.empty() && !files.empty())
    throw InvalidInput("--compare prints a table; outputs (-o) are of one curve");
  StopOnSignal stop;
  set_thread_count(arguments.threads);
  TerminalProgress terminal(!arguments.quiet, arguments.choices.time_limit.value_or(0));
  terminal.report({.stage = "read"});
  Control control = terminal.control(stop.token());
  control.time_limit = arguments.choices.time_limit.value_or(0);
  Reading reading;
  const CurvePoints points = read_points(arguments, reading);
  CurveFitOptions options = curve_options(arguments);
  if (arguments.choices.feature_file)
    options.user_features = read_curve_feature_file(*arguments.choices.feature_file, points);
  if (!arguments.methods.empty()) return compare(arguments, points, options, reading, control, terminal);

  CurveFitResult result;
  try {
    result = fit_curve(points, options, control);
    put_in_tool_words(result);
  } catch (const InvalidInput& e) {
    throw InvalidInput(input_name(arguments.input) + ": " + e.what());
  }
  terminal.clear();
  int status = result.status == Status::stopped       ? kStopped
               : result.status == Status::failed      ? kOther
               : result.status == Status::time_limit  ? kNotReached
               : options.tolerance && !result.reached ? kNotReached
                                                      : kReached;
  CurveReport report{.result = result, .points = points, .arguments = arguments, .reading = reading};
  if (result.curve.control_points().empty()) {
    std::fprintf(stderr, "knotfit: %s\n", result.message.c_str());
    return status;
  }
  const int written = write_each(
      files, [&](const OutputFile& file) { write_curve_output(file, report); }, report.outputs);
  if (written != kReached && status != kOther) status = written;
  report.seconds = seconds_since(start);
  if (arguments.json)
    print(curve_to_json(report) + "\n");
  else if (!arguments.quiet)
    print_summary(curve_to_text(report), files);
  return status;
}

}  // namespace knotfit::tool
