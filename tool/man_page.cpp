// The man page: hand-written prose, and the options of each command.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "help_text.h"
#include "knotfit/exceptions.h"
#include "knotfit/version.h"
#include "pages.h"
namespace knotfit::tool {
namespace {

constexpr std::string_view kMark = ".\\\" @options ";
constexpr std::size_t kWidth = 110;

bool is_name(char c) {
  return (c >= 'a' && c <= 'z') || c == '-';
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text)
    out += c == '-' ? std::string("\\-") : c == '\\' ? std::string("\\e") : std::string(1, c);
  return out;
}

/// A sentence or more, options in bold.
std::string prose(std::string_view text) {
  std::string out, line;
  for (const char* const end = text.data() + text.size(); text.data() != end;) {
    const std::size_t option = text.find("--");
    if (option == std::string_view::npos) break;
    std::size_t stop = option + 2;
    while (stop < text.size() && is_name(text[stop])) ++stop;
    out += escaped(text.substr(0, option)) + "\\fB" + escaped(text.substr(option, stop - option)) + "\\fR";
    text.remove_prefix(stop);
  }
  out = wrap(out + escaped(text), kWidth) + "\n";
  // A line that begins with a dot or an apostrophe would be a request.
  std::string lines;
  for (std::size_t begin = 0; begin < out.size();) {
    const std::size_t end = out.find('\n', begin) + 1;
    if (out[begin] == '.' || out[begin] == '\'') lines += "\\&";
    lines += out.substr(begin, end - begin);
    begin = end;
  }
  return lines;
}

/// "X|X%": capitals are italic, words bold.
std::string value_text(const std::string& value) {
  std::string out;
  for (std::size_t begin = 0; begin < value.size();) {
    std::size_t end = begin;
    const auto is_capital = [](char c) { return c >= 'A' && c <= 'Z'; };
    while (end < value.size() && is_capital(value[end])) ++end;
    if (end > begin) {
      out += "\\fI" + value.substr(begin, end - begin) + "\\fR";
    } else {
      while (end < value.size() &&
             (is_name(value[end]) || std::isdigit(static_cast<unsigned char>(value[end])) != 0))
        ++end;
      if (end > begin + 1)
        out += "\\fB" + escaped(value.substr(begin, end - begin)) + "\\fR";
      else
        out += escaped(value.substr(begin, 1)), end = begin + 1;
    }
    begin = end;
  }
  return out;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t k = 0; k < names.size(); ++k)
    text += (k == 0 ? "" : k + 1 == names.size() ? " and " : ", ") + names[k];
  return text;
}

/// The option as the command has it, and which others have it too.
std::string entry(const OptionRow& row, Command command) {
  const Use& use = *row.use_of(command);
  std::string text = ".TP\n";
  for (const std::string& name : row.all_names())
    text += (text.size() > 4 ? ", " : "") + ("\\fB" + escaped(name)) + "\\fR";
  if (!row.value.empty()) text += " " + value_text(row.value_in(use));
  std::string said = use.help + (use.help.ends_with('.') ? "" : ".");
  if (!row.more.empty()) said += " " + row.more;
  std::vector<std::string> others;
  for (const CommandRow& other : command_rows())
    if (other.command != command && (row.commands() & only(other.command)) != 0) others.push_back(other.name);
  if (!others.empty()) said += " Also of " + listed(others) + ".";
  return text + "\n" + prose(said);
}

}  // namespace

std::string man_page(const std::string& text) {
  std::string page;
  std::set<const OptionRow*> written;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    const std::string line = text.substr(begin, end - begin);
    begin = end;
    if (!line.starts_with(kMark)) {
      page += line;
      continue;
    }
    std::string what = line.substr(kMark.size());
    what.erase(what.find_last_not_of(" \n") + 1);
    const std::string name = what.substr(0, what.find(' '));
    const std::string group = name.size() < what.size() ? what.substr(name.size() + 1) : "";
    const std::size_t before = written.size();
    for (const CommandRow& command : command_rows()) {
      if (command.name != name) continue;
      for (const OptionRow* row : rows_of(command.command))
        if ((group.empty() || row->use_of(command.command)->group == group) && written.insert(row).second)
          page += entry(*row, command.command);
    }
    if (written.size() == before) throw InvalidInput("there is no option for the line " + line);
  }
  for (const OptionRow& row : option_rows())
    if (!written.contains(&row)) throw InvalidInput("no line of the man page has " + row.name());
  constexpr std::string_view kVersion = "@VERSION@";
  if (const std::size_t at = page.find(kVersion); at != std::string::npos)
    page.replace(at, kVersion.size(), version());
  return page;
}

}  // namespace knotfit::tool
