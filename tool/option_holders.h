// How the rows of options keep a value: what a text becomes, and the text that it is printed as.
#pragma once
#include <string>
#include <type_traits>
#include <utility>

#include "option_rows.h"
#include "text_values.h"
namespace knotfit::tool {

/// The field of the choices, of the reading or of the CAD files.
template <class Choices, class Part, class T>
auto& field_of(Choices& c, T Part::*field) {
  if constexpr (std::is_same_v<Part, InputOptions>)
    return c.input.*field;
  else if constexpr (std::is_same_v<Part, CadChoices>)
    return c.cad.*field;
  else
    return c.*field;
}

/// Any field, by a function from text and one to it.
template <class Part, class T, class Parse, class Print>
Holder kept(std::optional<T> Part::*field, Parse parse, Print print) {
  return {[=](Arguments& a, const std::string& t) { field_of(a.choices, field) = parse(t); },
          [=](const FitChoices& c) -> std::optional<std::string> {
            const std::optional<T>& value = field_of(c, field);
            return value ? std::optional<std::string>(print(*value)) : std::nullopt;
          }};
}

/// A text, after `check` has read it.
template <class Part, class Check>
Holder text(std::optional<std::string> Part::*field, Check check) {
  return kept(
      field, [=](const std::string& t) { return check(t), t; }, [](const std::string& t) { return t; });
}
template <class Part>
Holder text(std::optional<std::string> Part::*field) {
  return text(field, [](const std::string&) {});
}

/// One of a table that lives as long as the program.
template <class Part, class E, class Table>
Holder named(std::optional<E> Part::*field, const Table& table) {
  return kept(
      field, [&table](const std::string& t) { return parse_named(table, t); },
      [&table](const E& e) { return std::string(name_of(table, e)); });
}

/// A switch: on unless it is told "off".
template <class Part>
Holder on(std::optional<bool> Part::*field) {
  return kept(
      field, [](const std::string& t) { return t != "off"; },
      [](bool b) { return std::string(b ? "on" : "off"); });
}

template <class Part>
Holder real(std::optional<double> Part::*field, double (*parse)(std::string_view)) {
  return kept(field, parse, [](double x) { return number_text(x); });
}

template <class Part, class T>
Holder count(std::optional<T> Part::*field, long long least = 1) {
  return kept(
      field, [=](const std::string& t) { return static_cast<T>(parse_count(t, least)); },
      [](const T& n) { return std::to_string(n); });
}

/// A switch of one run.
inline Holder flag(bool Arguments::*field) {
  return {[=](Arguments& a, const std::string&) { a.*field = true; }};
}

/// A number from `least` to `most`; `what` says which.
inline int count_up_to(const std::string& t, long long least, long long most, const char* what) {
  const long long n = parse_count(t, least);
  if (n > most) refuse(t, what);
  return static_cast<int>(n);
}

}  // namespace knotfit::tool
