#include "command_line_help.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "nearest_name.h"
#include "option_rows.h"
namespace knotfit::tool {
namespace {

constexpr std::size_t kColumn = 34;  // where descriptions begin

const CommandRow* find_command(const CLI::App& app) {
  for (const CommandRow& command : command_rows())
    if (command.name == app.get_name()) return &command;
  return nullptr;
}

bool in_short_help(const CLI::App& app, const CLI::Option& option) {
  const CommandRow* command = find_command(app);
  if (command == nullptr || (only(command->command) & kShortHelp) == 0) return true;
  for (const OptionRow* row : rows_of(command->command))
    if (row->name().substr(2) == option.get_lnames().front())
      return (row->first & only(command->command)) != 0;
  return true;  // the help itself
}

class HelpFormatter : public CLI::Formatter {
 public:
  // CLI11's own lists what each option excludes; the parser's messages say so where it matters.
  std::string make_option_opts(const CLI::Option* option) const override {
    if (option->get_type_size() == 0 || option->get_type_name().empty()) return "";
    return " " + option->get_type_name() + (option->get_expected_max() > 1 ? " ..." : "");
  }

  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override {
    return make_description(app) + make_usage(app, name) + make_positionals(app) + options(app, mode) +
           make_subcommands(app, CLI::AppFormatMode::Normal) + "\n" + make_footer(app);
  }

 private:
  std::string options(const CLI::App* app, CLI::AppFormatMode mode) const {
    const bool everything = mode == CLI::AppFormatMode::All;
    std::string text;
    std::size_t left_out = 0;
    for (const std::string& group : app->get_groups()) {
      std::vector<const CLI::Option*> shown;
      for (const CLI::Option* option : app->get_options()) {
        if (option->get_group() != group || option->get_group().empty() || !option->nonpositional()) continue;
        if (everything || in_short_help(*app, *option))
          shown.push_back(option);
        else
          ++left_out;
      }
      if (!shown.empty()) text += make_group(group, false, shown);
    }
    if (left_out > 0)
      text += fmt::format("\n{} more options: knotfit {} --help-all\n", left_out, app->get_name());
    return text;
  }
};

// Every name of an option, with its dashes.
std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  return names;
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> all;
  for (const CLI::Option* option : app.get_options())
    for (std::string& name : names_of(*option)) all.push_back(std::move(name));
  return all;
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App*) { return true; });
}

// "fit, compare": the commands that have an option.
std::string commands_with(const CLI::App& app, const std::string& option) {
  std::string list;
  for (const CLI::App* command : commands_of(app))
    if (has(option_names(*command), option)) list += (list.empty() ? "" : ", ") + command->get_name();
  return list;
}

// "--tolrance=5%" without its value.
std::string without_value(const std::string& word) {
  return word.substr(0, word.find('='));
}

bool is_option(const std::string& word) {
  return word.size() > 1 && word.front() == '-' && (std::isdigit(static_cast<unsigned char>(word[1])) == 0) &&
         word[1] != '.';
}

// "; did you mean NAME?", or what else there is to say, and where the help is.
std::string with_hint(const std::string& text, const std::string& near, const std::string& otherwise,
                      const std::string& help) {
  if (!near.empty()) return fmt::format("{}; did you mean {}? See {}", text, near, help);
  return fmt::format("{}{}; see {}", text, otherwise, help);
}

std::string unknown_option(const CLI::App& app, const CLI::App& command, const std::string& word) {
  const std::string option = without_value(word);
  const std::string others = commands_with(app, option);
  const std::string near = others.empty() ? nearest_name(option, option_names(command)) : "";
  return with_hint(fmt::format("{} has no option {}", command.get_name(), option), near,
                   others.empty() ? "" : fmt::format(" (it is one of {})", others),
                   fmt::format("knotfit {} --help-all", command.get_name()));
}

std::string unknown_command(const CLI::App& app, const std::string& word) {
  if (is_option(word)) {
    const std::string option = without_value(word);
    const std::string others = commands_with(app, option);
    if (!others.empty())
      return fmt::format("{} comes after a command that has it ({}); see knotfit --help", option, others);
    return with_hint(fmt::format("knotfit has no option {}", option), nearest_name(option, option_names(app)),
                     "", "knotfit --help");
  }
  std::vector<std::string> names;
  for (const CLI::App* command : commands_of(app)) names.push_back(command->get_name());
  for (const std::string& option : option_names(app)) names.push_back(option);  // "help", "version"
  const bool file = word.find_first_of("./") != std::string::npos;
  return with_hint(fmt::format("there is no command '{}'", word), file ? "" : nearest_name(word, names),
                   file ? fmt::format("; a file comes after a command: knotfit fit {}", word) : "",
                   "knotfit --help");
}

}  // namespace

std::shared_ptr<CLI::FormatterBase> help_formatter() {
  auto formatter = std::make_shared<HelpFormatter>();
  formatter->column_width(kColumn);
  return formatter;
}

std::string help_of(const CLI::App& app, bool everything) {
  if (!everything) return app.help();
  if (!app.get_subcommands().empty()) return app.help("", CLI::AppFormatMode::All);
  std::string text = app.help();
  for (const CLI::App* command : commands_of(app))
    text += "\n" + command->help(app.get_name(), CLI::AppFormatMode::All);
  return text;
}

std::string usage_message(const CLI::App& app, int argc, const char* const* argv, const std::string& what) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const std::string first = argc > 1 ? argv[1] : "";
  // A command comes first.
  if (!first.empty() && (chosen.empty() || chosen.front()->get_name() != first) &&
      !has(option_names(app), without_value(first)))
    return unknown_command(app, first);
  if (chosen.empty()) return what + "; see knotfit --help";
  const CLI::App& command = *chosen.front();
  for (const std::string& word : app.remaining(true))
    if (is_option(word)) return unknown_option(app, command, word);
  return fmt::format("{}; see knotfit {} --help", what, command.get_name());
}

}  // namespace knotfit::tool
