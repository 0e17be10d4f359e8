#include "command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "command_line_help.h"
#include "help_text.h"
#include "knotfit/exceptions.h"
#include "knotfit/version.h"
#include "option_rows.h"
namespace knotfit::tool {
namespace {

constexpr std::size_t kDescription = 70;  // width of descriptions

// What an option refuses is named by it.
void take(const OptionRow& row, Arguments& arguments, const std::string& text) {
  try {
    row.holds.take(arguments, text);
  } catch (const InvalidInput& e) {
    throw UsageError(row.all_names().back() + ": " + e.what());
  }
}

CLI::Option* add_row(CLI::App& app, const OptionRow& row, const Use& use, Arguments& arguments) {
  const std::string help = wrap(use.help, kDescription);
  const auto take_all = [&row, &arguments](const std::vector<std::string>& texts) {
    for (const std::string& text : texts) take(row, arguments, text);
  };
  const auto take_one = [&row, &arguments](const std::string& text) { take(row, arguments, text); };
  const auto take_none = [&row, &arguments](std::int64_t) { take(row, arguments, ""); };
  CLI::Option* option = row.value.empty() ? app.add_flag_function(row.names, take_none, help)
                        : row.repeats
                            ? app.add_option_function<std::vector<std::string>>(row.names, take_all, help)
                                  ->allow_extra_args(false)
                            : app.add_option_function<std::string>(row.names, take_one, help);
  if (!row.value.empty()) option->type_name(row.value_in(use));
  return option->group(std::string(use.group));
}

void add_options(CLI::App& app, const CommandRow& command, Arguments& arguments) {
  std::string* paths[] = {&arguments.input, &arguments.data};
  for (std::size_t k = 0; k < command.inputs.size(); ++k)
    app.add_option(command.inputs[k].name, *paths[k], wrap(command.inputs[k].help, kDescription))
        ->required()
        ->type_name("");
  const std::vector<const OptionRow*> rows = rows_of(command.command);
  for (const OptionRow* row : rows) {
    CLI::Option* option = add_row(app, *row, *row->use_of(command.command), arguments);
    if ((row->required & only(command.command)) != 0) option->required();
  }
  for (const OptionRow* row : rows) {
    CLI::Option* option = app.get_option(row->name());
    for (const std::string& other : row->excludes)
      if (CLI::Option* excluded = app.get_option_no_throw(other)) option->excludes(excluded);
    for (const std::string& other : row->needs) option->needs(app.get_option(other));
  }
}

// "--output" of every option that stands on the command line, by the first of its long names.
std::vector<std::string> options_given(const CLI::App& command) {
  std::vector<std::string> given;
  for (const CLI::Option* option : command.get_options())
    if (option->count() > 0 && option->nonpositional()) given.push_back("--" + option->get_lnames().front());
  return given;
}

// Standard input is one file.
void settle_standard_input(const Arguments& a) {
  const std::string files[] = {a.input,        a.data,   a.knots_from,
                               a.options_from, a.points, a.choices.feature_file.value_or("")};
  if (std::count(std::begin(files), std::end(files), "-") > 1)
    throw UsageError("- is standard input, and can be one file only");
}

void settle_standard_output(Arguments& a, const std::string& command) {
  constexpr Commands kJson =
      kFit | kCurve | kConvert;  // their files may be JSON; of others `-o -` is their --json
  if ((only(a.command) & kJson) == 0) {
    if (std::erase(a.output.paths, "-") > 0) a.json = true;
    return;
  }
  const auto count = std::count(a.output.paths.begin(), a.output.paths.end(), "-");
  if (count > 1) throw UsageError("-o -: given twice");
  if (count > 0 && a.json)
    throw UsageError("--json and -o - both write to standard output; give -o a file's name; see knotfit " +
                     command + " --help");
}

}  // namespace

ParsedCommandLine parse_command_line(int argc, const char* const* argv) {
  Arguments arguments;
  CLI::App app{"B-spline surfaces with the fewest control points that hold a tolerance.", "knotfit"};
  app.formatter(help_formatter());  // before the commands, which inherit it
  app.set_version_flag("--version", "knotfit " + std::string(version()), "Print the version");
  app.set_help_flag("-h,--help", "Print this help");
  app.set_help_all_flag("--help-all", "Print the help with every option");
  app.require_subcommand(1);
  app.footer(examples("") + "\nknotfit COMMAND --help says more, --help-all says all.\n\n" + exit_statuses());
  for (const CommandRow& command : command_rows()) {
    CLI::App* sub = app.add_subcommand(command.name, command.summary);
    sub->callback([&arguments, value = command.command] { arguments.command = value; });
    add_options(*sub, command, arguments);
    if (!command.inputs.empty())
      sub->footer(examples(command.name) + (command.command == Command::fit ? "\n" + exit_statuses() : ""));
  }

  if (argc < 2) return {.run = std::nullopt, .text = app.help()};
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return {.run = std::nullopt, .text = help_of(app, false)};
  } catch (const CLI::CallForAllHelp&) {
    return {.run = std::nullopt, .text = help_of(app, true)};
  } catch (const CLI::CallForVersion& e) {
    return {.run = std::nullopt, .text = std::string(e.what()) + "\n"};
  } catch (const CLI::ParseError& e) {
    throw UsageError(usage_message(app, argc, argv, e.what()));
  }
  const CLI::App& chosen = *app.get_subcommands().front();
  const bool of_one = arguments.command == Command::fit_curve || arguments.command == Command::distance;
  if (of_one && !arguments.tolerances.empty())
    throw UsageError("--tol: " + chosen.get_name() + " takes one tolerance");
  settle_standard_input(arguments);
  settle_standard_output(arguments, chosen.get_name());
  arguments.choices.input.given = options_given(chosen);
  return {.run = std::move(arguments), .text = ""};
}

}  // namespace knotfit::tool
