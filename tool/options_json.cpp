#include "options_json.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "knotfit/exceptions.h"
#include "knotfit/io.h"
#include "option_rows.h"
#include "standard_streams.h"
#include "text_values.h"
namespace knotfit::tool {
namespace {

using Json = nlohmann::ordered_json;

// A number that is all of the text, or the text.
template <class T>
Json number_or_text(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool finite =
      error == std::errc{} && end == text.data() + text.size() && std::isfinite(static_cast<double>(value));
  return finite ? Json(value) : Json(text);
}

template <class T>
Json list_of(std::string_view text, char mark) {
  Json list = Json::array();
  for (const std::string_view part : split(text, mark)) list.push_back(number_or_text<T>(part));
  return list;
}

template <class T>
Json pair_or_text(const std::string& text) {
  const Json pair = list_of<T>(text, 'x');
  return pair.size() == 2 && pair[0].is_number() && pair[1].is_number() ? pair : Json(text);
}

Json knots_json(const std::string& text) {
  const std::vector<std::string_view> lists = split(text, ';');
  if (lists.size() != 2) return text;
  const auto list = [](std::string_view t) { return t == "none" ? Json::array() : list_of<double>(t, ','); };
  return {{"u", list(lists[0])}, {"v", list(lists[1])}};
}

/// The printed text of a value as it is stored.
Json to_json(Form form, const std::string& text) {
  switch (form) {
    case Form::boolean:
    case Form::on_off:
      return text == "on";
    case Form::whole:
      return number_or_text<long long>(text);
    case Form::real:
      return number_or_text<double>(text);
    case Form::whole_pair:
      return pair_or_text<int>(text);
    case Form::real_pair:
      return pair_or_text<double>(text);
    case Form::names:
      return split(text, ',');
    case Form::wholes:
      return list_of<int>(text, ',');
    case Form::returns: {
      Json list = list_of<int>(text, ',');
      for (Json& one : list)
        if (one == "last") one = kLastReturn;
      return list;
    }
    case Form::knots:
      return knots_json(text);
    case Form::none:
    case Form::text:
    case Form::words:
    case Form::measure:
      break;
  }
  return text;
}

/// A stored value as the text that its option takes. \throws Json::exception  a value of another kind
std::string to_text(Form form, const Json& j) {
  if (j.is_boolean()) return j.get<bool>() ? "on" : "off";
  if (form == Form::returns && j == kLastReturn) return "last";
  if (j.is_number_float()) return fmt::format("{}", j.get<double>());
  if (j.is_number()) return j.dump();
  if (form == Form::knots && j.is_object()) {
    const auto list = [&](const char* name) {
      const auto knots = j.at(name).get<std::vector<double>>();
      return knots.empty() ? std::string("none") : fmt::format("{}", fmt::join(knots, ","));
    };
    return list("u") + ";" + list("v");
  }
  if (!j.is_array()) return j.get<std::string>();
  std::vector<std::string> parts;
  for (const Json& one : j) parts.push_back(to_text(form, one));
  return fmt::format("{}", fmt::join(parts, form == Form::whole_pair || form == Form::real_pair ? "x" : ","));
}

/// Both are texts, or numbers, or lists of one length, ...: a number in quotes is none.
bool same_kind(const Json& a, const Json& b) {
  if (a.is_number() || b.is_number()) return a.is_number() && b.is_number();
  return a.type() == b.type() && a.size() == b.size();
}

void take(const OptionRow& row, Arguments& arguments, const std::string& text) {
  (row.stored.take ? row.stored.take : row.holds.take)(arguments, text);
}

bool is_stored(const OptionRow& row) {
  return row.stored.form != Form::none;
}

// The "options" member of a file.
Json stored_options(const std::string& path) {
  const FileBytes file = is_dash(path) ? standard_input() : load_file(path);
  const std::string_view text = file.view();
  const Json document = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (document.is_discarded()) throw FileError(path, "is not JSON: no options to repeat");
  if (!document.is_object() || !document.contains("options") || !document["options"].is_object())
    throw FileError(path,
                    "has no \"options\": give a surface.json that knotfit fit wrote, or its --json output");
  return document["options"];
}

const OptionRow* find_row(const std::string& key) {
  for (const OptionRow& row : option_rows())
    if (is_stored(row) && key == row.key()) return &row;
  return nullptr;
}

// As a command line gives it.
std::string with_option(const OptionRow& row, const std::string& text) {
  switch (row.stored.form) {
    case Form::boolean:
      return text == "on" ? row.name() : "";
    case Form::words:
      return fmt::format("{} '{}'", row.name(), text);
    case Form::measure:
      return text == "rms" ? "--rms" : row.name() + " " + text;
    case Form::knots:
      if (const std::size_t split = text.find(';'); split != std::string::npos)
        return fmt::format("--knots-u {} --knots-v {}", text.substr(0, split), text.substr(split + 1));
      break;
    default:
      break;
  }
  return row.name() + " " + text;
}

}  // namespace

std::string options_to_json(const FitChoices& choices) {
  Json options = Json::object();
  for (const OptionRow& row : option_rows()) {
    if (!is_stored(row)) continue;
    const std::optional<std::string> text = row.holds.print(choices);
    options[row.key()] = text ? to_json(row.stored.form, *text) : Json(nullptr);
  }
  return options.dump();
}

void add_stored_options(Arguments& arguments, const std::string& path) {
  const FitChoices& choices = arguments.choices;
  const bool size_given = choices.control_points.has_value();
  const bool knots_given = choices.knots && choices.knots->given;
  const Json stored = stored_options(path);
  for (const auto& [name, value] : stored.items()) {
    const OptionRow* row = find_row(name);
    if (row == nullptr) throw FileError(path, "options: \"" + name + "\" is not an option of this version");
    if (value.is_null() || row->holds.print(choices)) continue;
    if (name == "knots" && size_given && value.is_object()) continue;  // a size in place of given knots
    if (name == "control_points" && knots_given) continue;             // and the reverse
    bool same = true;
    try {
      take(*row, arguments, to_text(row->stored.form, value));
      same = same_kind(value, to_json(row->stored.form, row->holds.print(choices).value_or("")));
    } catch (const InvalidInput& e) {
      throw FileError(path, "options: \"" + name + "\": " + e.what());
    } catch (const Json::exception&) {
      same = false;
    }
    if (!same)
      throw FileError(path, "options: \"" + name + "\" has a value of another kind: " + value.dump());
  }
}

void add_usual_options(Arguments& arguments) {
  for (const OptionRow& row : option_rows())
    if (row.stored.filled && !row.holds.print(arguments.choices)) take(row, arguments, row.stored.usual);
}

std::string options_to_text(const FitChoices& choices) {
  std::string text;
  for (const OptionRow& row : option_rows()) {
    const std::optional<std::string> value = is_stored(row) ? row.holds.print(choices) : std::nullopt;
    const std::string one = !value || *value == row.stored.usual ? "" : with_option(row, *value);
    text += (text.empty() || one.empty() ? "" : " ") + one;
  }
  return text;
}

}  // namespace knotfit::tool
