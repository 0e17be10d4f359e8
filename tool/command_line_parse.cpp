#include <CLI/CLI.hpp>
#include <algorithm>

#include "command_line.h"
#include "command_line_help.h"
#include "command_line_options.h"
#include "help_text.h"
#include "knotfit/version.h"
namespace knotfit::tool {
namespace {

// "--output" of every option that stands on the command line, by the first of its long names.
std::vector<std::string> options_given(const CLI::App& command) {
  std::vector<std::string> given;
  for (const CLI::Option* option : command.get_options())
    if (option->count() > 0 && option->nonpositional()) given.push_back("--" + option->get_lnames().front());
  return given;
}

// Of commands whose files are no JSON: `-o -` is their --json.
void json_for_dash(OutputOptions& output, bool& json) {
  if (std::erase(output.paths, "-") > 0) json = true;
}

void refuse_two_results(const OutputOptions& output, bool json, const std::string& command) {
  const auto count = std::count(output.paths.begin(), output.paths.end(), "-");
  if (count > 1) throw UsageError("-o -: given twice");
  if (count > 0 && json)
    throw UsageError("--json and -o - both write to standard output; give -o a file's name; see knotfit " +
                     command + " --help");
}

// Standard input is one file.
void refuse_two_inputs(std::initializer_list<std::string> paths) {
  if (std::count(paths.begin(), paths.end(), "-") > 1)
    throw UsageError("- is standard input, and can be one file only");
}

void settle_standard_input(const CommandLine& line) {
  const auto feature = [](const FitChoices& c) { return c.feature_file.value_or(""); };
  refuse_two_inputs({line.fit.input, line.fit.knots_from, line.fit.options_from, feature(line.fit.choices)});
  refuse_two_inputs({line.compare.input, feature(line.compare.choices)});
  refuse_two_inputs({line.fit_curve.input, feature(line.fit_curve.choices)});
  refuse_two_inputs({line.eval.surface, line.eval.points});
  refuse_two_inputs({line.distance.surface, line.distance.data});
}

void settle_standard_output(CommandLine& line) {
  json_for_dash(line.eval.output, line.eval.json);
  json_for_dash(line.distance.output, line.distance.json);
  json_for_dash(line.parameterize.output, line.parameterize.json);
  if (line.compare.folder == "-") {
    line.compare.folder.clear();
    line.compare.json = true;
  }
  refuse_two_results(line.fit.output, line.fit.json, "fit");
  refuse_two_results(line.fit_curve.output, line.fit_curve.json, "fit-curve");
  refuse_two_results(line.convert.output, false, "convert");
}

}  // namespace

ParsedCommandLine parse_command_line(int argc, const char* const* argv) {
  CommandLine line;
  CLI::App app{"B-spline surfaces with the fewest control points that hold a tolerance.", "knotfit"};
  app.formatter(help_formatter());  // before the commands, which inherit it
  app.set_version_flag("--version", "knotfit " + std::string(version()), "Print the version");
  app.set_help_flag("-h,--help", "Print this help");
  app.set_help_all_flag("--help-all", "Print the help with every option");
  app.require_subcommand(1);
  app.footer(examples("") + "\nknotfit COMMAND --help says more, --help-all says all.\n\n" + exit_statuses());

  const auto command = [&](const std::string& name, const std::string& summary, Command value) {
    CLI::App* sub = app.add_subcommand(name, summary);
    sub->callback([&line, value] { line.command = value; });
    return sub;
  };
  CLI::App* fit = command("fit", "Fit one B-spline surface to points, a mesh or terrain", Command::fit);
  CLI::App* compare =
      command("compare", "Every placement method on the same data: a table and pictures", Command::compare);
  CLI::App* fit_curve = command("fit-curve", "Fit one B-spline curve to ordered points", Command::fit_curve);
  CLI::App* parameterize =
      command("parameterize", "Give the vertices of a mesh parameters u, v", Command::parameterize);
  CLI::App* eval = command("eval", "Values, derivatives and differences of a surface", Command::eval);
  CLI::App* distance =
      command("distance", "Distances between a surface and points or a mesh", Command::distance);
  CLI::App* info = command("info", "What a surface or a data file holds", Command::info);
  CLI::App* convert = command("convert", "Write a surface or data in another format", Command::convert);
  CLI::App* methods = command("methods", "List the knot placement methods", Command::methods);
  CLI::App* formats = command("formats", "List the file formats", Command::formats);
  add_fit(*fit, line.fit);
  add_compare(*compare, line.compare);
  add_fit_curve(*fit_curve, line.fit_curve);
  add_parameterize(*parameterize, line.parameterize);
  add_eval(*eval, line.eval);
  add_distance(*distance, line.distance);
  add_info(*info, line.info);
  add_convert(*convert, line.convert);
  add_list(*methods, line.list);
  add_list(*formats, line.list);
  fit->footer(examples("fit") + "\n" + exit_statuses());
  for (CLI::App* sub : {compare, fit_curve, parameterize, eval, distance, info, convert})
    sub->footer(examples(sub->get_name()));

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
  settle_standard_input(line);
  settle_standard_output(line);
  const std::vector<std::string> given = options_given(*app.get_subcommands().front());
  for (InputOptions* input : {&line.fit.choices.input, &line.compare.choices.input,
                              &line.fit_curve.choices.input, &line.parameterize.choices.input,
                              &line.eval.input, &line.distance.input, &line.info.input, &line.convert.read})
    input->given = given;
  return {.run = std::move(line), .text = ""};
}

}  // namespace knotfit::tool
