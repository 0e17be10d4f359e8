// Completions of bash, zsh and fish.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "pages.h"
#include "text_values.h"
namespace knotfit::tool {
namespace {

std::string joined(const std::vector<std::string>& words, std::string_view mark = " ") {
  return fmt::format("{}", fmt::join(words, mark));
}

bool is_word(std::string_view text) {
  return !text.empty() &&
         text.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string_view::npos &&
         text[0] >= 'a';
}

/// "auto off": what a value may be by name.
std::string words_of(const OptionRow& row) {
  if (!row.words.empty()) return row.words;
  std::vector<std::string> words;
  for (const std::string_view word : split(row.value, '|'))
    if (is_word(word)) words.emplace_back(word);
  return joined(words);
}

bool takes_files(const OptionRow& row) {
  return row.offer == Offer::files || row.offer == Offer::surfaces;
}

std::vector<std::string> names_of_commands() {
  std::vector<std::string> names;
  for (const CommandRow& command : command_rows()) names.push_back(command.name);
  return names;
}

std::vector<std::string> names_of(Commands commands) {
  std::vector<std::string> names;
  for (const CommandRow& command : command_rows())
    if ((commands & only(command.command)) != 0) names.push_back(command.name);
  return names;
}

/// In single quotes, for any of the shells.
std::string single_quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

/// With a backslash before each of `marks`.
std::string escaped(const std::string& text, std::string_view marks) {
  std::string out;
  for (const char c : text) {
    if (marks.find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

std::string bash_offer(const OptionRow& row) {
  std::string words = words_of(row);
  const std::string list = R"($("$tool" {} --names 2>/dev/null))";
  if (row.offer == Offer::methods) words = fmt::format(fmt::runtime(list), "methods");
  if (row.offer == Offer::all_methods) words = "all " + fmt::format(fmt::runtime(list), "methods");
  if (row.offer == Offer::formats) words = fmt::format(fmt::runtime(list), "formats");
  std::vector<std::string> parts;
  if (!words.empty()) parts.push_back("$(compgen -W \"" + words + "\" -- \"$current\")");
  if (takes_files(row)) parts.push_back("$(compgen -f -- \"$current\")");
  return parts.empty() ? "return" : "COMPREPLY=(" + joined(parts) + "); return";
}

}  // namespace

std::string brief_of(const OptionRow& row, const Use& use) {
  if (!row.brief.empty()) return row.brief;
  std::size_t end = use.help.size();
  for (const std::string_view stop : {"; ", ": ", ". ", " ("}) end = std::min(end, use.help.find(stop));
  return use.help.substr(0, end);
}

std::string bash_completion() {
  const std::string commands = joined(names_of_commands());
  std::string text = R"(# bash completion for knotfit

_knotfit() {
  local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command="" word options=""
  local tool=${COMP_WORDS[0]}
  COMPREPLY=()
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    case $word in )" +
                     joined(names_of_commands(), " | ") + R"() command=$word; break ;; esac
  done

  case $previous in
)";
  std::map<std::string, std::vector<std::string>> by_offer;
  std::set<std::string> seen;
  for (const OptionRow& row : option_rows())
    for (const std::string& name : row.all_names())
      if (!row.value.empty() && seen.insert(name).second) by_offer[bash_offer(row)].push_back(name);
  for (const auto& [offer, names] : by_offer)
    text += fmt::format("    {}) {} ;;\n", joined(names, " | "), offer);
  text += "  esac\n\n  if [[ -z $command ]]; then\n    COMPREPLY=($(compgen -W \"" + commands +
          " --help --help-all --version\" -- \"$current\"))\n    return\n  fi\n  case $command in\n";
  for (const CommandRow& command : command_rows()) {
    std::vector<std::string> names;
    for (const OptionRow* row : rows_of(command.command))
      for (const std::string& name : row->all_names()) names.push_back(name);
    text += fmt::format("    {}) options=\"{}\" ;;\n", command.name, joined(names));
  }
  text += R"(  esac
  if [[ $current == -* ]]; then
    COMPREPLY=($(compgen -W "$options --help --help-all" -- "$current"))
)";
  std::vector<std::string> without_files;
  for (const CommandRow& command : command_rows())
    if (command.inputs.empty()) without_files.push_back("$command != " + command.name);
  text += "  elif [[ " + joined(without_files, " && ") + R"( ]]; then
    COMPREPLY=($(compgen -f -- "$current"))
  fi
}
complete -o filenames -F _knotfit knotfit
)";
  return text;
}

namespace {

constexpr std::string_view kSurfaceFiles = R"sh(_files -g "*.(json|step|stp|igs|iges)")sh";

std::string zsh_action(const OptionRow& row) {
  if (const std::string words = words_of(row); !words.empty()) return "(" + words + ")";
  switch (row.offer) {
    case Offer::files:
      return "_files";
    case Offer::surfaces:
      return std::string(kSurfaceFiles);
    case Offer::methods:
      return "_knotfit_methods";
    case Offer::all_methods:
      return "_knotfit_all_methods";
    case Offer::formats:
      return "_knotfit_formats";
    case Offer::words:
      break;
  }
  return "";
}

/// The options of the command that do not go with this one.
std::string zsh_excluded(const OptionRow& row, const std::vector<const OptionRow*>& rows) {
  std::vector<std::string> names;
  const auto has = [](const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
  };
  for (const OptionRow* other : rows)
    if (has(row.excludes, other->name()) || has(other->excludes, row.name())) names.push_back(other->name());
  return names.empty() ? "" : "(" + joined(names) + ")";
}

std::string zsh_spec(const OptionRow& row, const Use& use, const std::vector<const OptionRow*>& rows) {
  std::string what = "[" + escaped(brief_of(row, use), "[]\\") + "]";
  if (!row.value.empty()) {
    what += ":" + escaped(row.value_in(use), ":\\");
    if (const std::string action = zsh_action(row); !action.empty()) what += ":" + action;
  }
  const std::string before = row.repeats ? "*" : zsh_excluded(row, rows);
  const std::vector<std::string> names = row.all_names();
  if (names.size() == 1) return single_quoted(before + names[0] + what);
  return (before.empty() ? "" : single_quoted(before)) + "{" + joined(names, ",") + "}" + single_quoted(what);
}

}  // namespace

std::string zsh_completion() {
  std::string text = R"sh(#compdef knotfit
# zsh completion for knotfit

_knotfit_methods() { compadd -- ${(f)"$(_call_program methods knotfit methods --names 2>/dev/null)"} }
_knotfit_all_methods() { compadd -- all; _knotfit_methods }
_knotfit_formats() { compadd -- ${(f)"$(_call_program formats knotfit formats --names 2>/dev/null)"} }

_knotfit() {
  local context state state_descr line
  typeset -A opt_args
  local -a commands
  commands=(
)sh";
  for (const CommandRow& command : command_rows())
    text += "    " + single_quoted(command.name + ":" + escaped(command.summary, ":\\")) + "\n";
  text += R"sh(  )
  _arguments -C '(- *)'{-h,--help}'[Print help]' '(- *)--help-all[Print the help with every option]' \
    '(- *)--version[Print the version]' '1:command:->command' '*::argument:->argument'
  case $state in
    command) _describe command commands ;;
    argument)
      case $line[1] in
)sh";
  for (const CommandRow& command : command_rows()) {
    text += "        " + command.name + ")\n          _arguments";
    const std::vector<const OptionRow*> rows = rows_of(command.command);
    for (const OptionRow* row : rows)
      text += " \\\n            " + zsh_spec(*row, *row->use_of(command.command), rows);
    for (std::size_t k = 0; k < command.inputs.size(); ++k) {
      const std::string_view files = command.inputs[k].surface ? kSurfaceFiles : "_files";
      text +=
          " \\\n            " + single_quoted(fmt::format("{}:{}:{}", k + 1, command.inputs[k].name, files));
    }
    text += " ;;\n";
  }
  return text + R"sh(      esac ;;
  esac
}

_knotfit "$@"
)sh";
}

std::string fish_completion() {
  const std::string none =
      "complete -c knotfit -n \"not __fish_seen_subcommand_from " + joined(names_of_commands()) + "\"";
  std::string text = "# fish completion for knotfit\n\n" + none + " -f\n" + none +
                     " -l version -d 'Print the version'\n"
                     "complete -c knotfit -s h -l help -d 'Print help'\n"
                     "complete -c knotfit -l help-all -d 'Print the help with every option'\n";
  for (const CommandRow& command : command_rows())
    text += fmt::format("{} -a {} -d {}\n", none, command.name, single_quoted(command.summary));
  for (const OptionRow& row : option_rows())
    for (const Use& use : row.uses) {
      std::string words = words_of(row);
      if (row.offer == Offer::methods) words = "(knotfit methods --names)";
      if (row.offer == Offer::all_methods) words = "all (knotfit methods --names)";
      if (row.offer == Offer::formats) words = "(knotfit formats --names)";
      std::string value = row.value.empty() ? "" : takes_files(row) ? " -r" : " -x";
      if (!words.empty()) value += " -a " + single_quoted(words);
      std::string letter;  // goes with the long name after it
      for (const std::string& name : row.all_names()) {
        if (!name.starts_with("--")) {
          letter = " -s " + name.substr(1);
          continue;
        }
        text += fmt::format("complete -c knotfit -n \"__fish_seen_subcommand_from {}\"{} -l {}{} -d {}\n",
                            joined(names_of(use.commands)), letter, name.substr(2), value,
                            single_quoted(brief_of(row, use)));
        letter.clear();
      }
    }
  return text;
}

}  // namespace knotfit::tool
