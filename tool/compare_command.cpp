#include <fmt/format.h>

#include <cstdio>
#include <optional>

#include "commands.h"
#include "compare_options.h"
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
int run_compare(const Arguments& arguments) {
  CompareOptions options = compare_options(arguments);
  comparison_rows(options);  // what cannot be asked is said before anything is read
  StopOnSignal stop;
  set_thread_count(arguments.threads);
  TerminalProgress terminal(!arguments.quiet);
  terminal.report({.stage = "read"});
  const Control control = terminal.control(stop.token());
  FitInput input = read_fit_input(arguments.input, arguments.choices, control);
  if (input.mesh && input.mesh->sampled) {
    const CloudMap& map = input.mesh->sampled->map;
    input.summary.reading.notes.push_back(
        fmt::format("a sample of {} of {} points is mapped and compared", map.sample, map.points));
  }
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
