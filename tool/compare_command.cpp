#include <fmt/format.h>

#include <tuple>

#include "commands.h"
#include "compare_report.h"
#include "exit_status.h"
#include "feature_file.h"
#include "knotfit/exceptions.h"
#include "knotfit/threads.h"
#include "options_json.h"
#include "outputs.h"
#include "reading.h"
#include "remedy_words.h"
#include "signals.h"
#include "terminal_progress.h"
#include "text_values.h"
namespace knotfit::tool {
namespace {

CompareOptions compare_options(const Arguments& arguments) {
  const FitChoices& c = arguments.choices;
  CompareOptions options;
  if (!arguments.methods.empty()) options.methods = arguments.methods;
  for (const IntegerPair& size : arguments.sizes) options.sizes.push_back({size.first, size.second});
  const MeasureValue measure = c.measure.value_or(MeasureValue{});
  for (const ToleranceValue& t : arguments.tolerances)
    options.tolerances.push_back(
        {.value = t.value, .relative = t.relative, .measure = measure.measure, .share = measure.share});
  FitOptions& fit = options.fit;
  if (c.degree) std::tie(fit.degree_u, fit.degree_v) = std::pair{c.degree->first, c.degree->second};
  fit.max_control_points = static_cast<Index>(c.max_control_points.value_or(0));
  fit.max_fits = c.max_fits.value_or(fit.max_fits);
  fit.smoothing = c.smoothing.value_or(fit.smoothing);
  fit.feature = c.feature.value_or(fit.feature);
  if (c.feature_file) fit.user_features = {.size_u = 1, .size_v = 1, .f = {1}};  // until the data is read
  fit.evaluations = c.evaluations.value_or(fit.evaluations);
  fit.between = c.between.value_or(fit.between);
  return options;
}

}  // namespace

int run_compare(const Arguments& arguments) {
  CompareOptions options = compare_options(arguments);
  comparison_rows(options);  // what cannot be asked is said before anything is read
  StopOnSignal stop;
  set_thread_count(arguments.threads);
  TerminalProgress terminal(!arguments.quiet);
  terminal.report({.stage = "read"});
  const Control control = terminal.control(stop.token());
  const FitInput input = read_fit_input(arguments.input, arguments.choices, control);
  if (arguments.choices.feature_file)
    options.fit.user_features = read_feature_file(*arguments.choices.feature_file, input.points.map);
  std::optional<CompareFolder> folder;
  if (!arguments.output.paths.empty()) folder.emplace(arguments.output.paths.front(), arguments.output.force);

  const std::string stored = options_to_json(arguments.choices);
  std::vector<CompareRow> rows;
  compare_methods(input.points, options, control, [&](const CompareRow& row) {
    rows.push_back(row);
    rows.back().failure = in_tool_words(row.failure);
    put_in_tool_words(rows.back().result);
    if (folder) folder->add(rows.back(), input, stored);
  });
  const bool stopped = stop.requested();
  if (folder) {
    terminal.report({.stage = "pictures"});
    folder->draw(input);
  }
  terminal.clear();
  const std::string json = compare_json(rows, input, stopped) + "\n";
  if (folder) write_text_file(folder->file("table.json"), true, json);
  if (arguments.json)
    print(json);
  else if (!arguments.quiet)
    print(compare_table(rows) + columns_to_text(input.summary.reading) +
          notes_to_text(input.summary.reading) +
          (folder ? "wrote " + arguments.output.paths.front() + "\n" : ""));
  if (stopped) {
    std::fprintf(stderr, "knotfit: stopped after %zu rows; they are kept\n", rows.size());
    return kStopped;
  }
  return kReached;
}

}  // namespace knotfit::tool
