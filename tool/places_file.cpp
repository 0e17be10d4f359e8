#include "places_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formats/columns.h"
#include "formats/file_bytes.h"
#include "formats/number.h"
#include "formats/text_lines.h"
#include "knotfit/exceptions.h"
#include "standard_streams.h"
#include "text_values.h"
namespace knotfit::tool {
namespace {

bool is_text(const std::string& path) {
  for (const char* extension : {".csv", ".tsv", ".txt", ".xyz", ".pts", ".dat"})
    if (extension_of(path) == extension) return true;
  return false;
}

bool is_number(std::string_view field) {
  return knotfit::parse_number(field).status != NumberStatus::not_a_number;
}

bool has(const std::vector<Role>& roles, Role role) {
  return std::find(roles.begin(), roles.end(), role) != roles.end();
}

std::size_t column(const std::vector<Role>& roles, Role role) {
  return static_cast<std::size_t>(std::find(roles.begin(), roles.end(), role) - roles.begin());
}

double number_at(const std::string& path, const TextLine& line, const std::vector<std::string_view>& fields,
                 std::size_t at) {
  const ParsedNumber number = knotfit::parse_number(fields[at]);
  if (number.status != NumberStatus::ok || !std::isfinite(number.value))
    throw FileError(path, line.number,
                    fmt::format("column {}: {} is not a finite number", at + 1, in_quotes(fields[at])));
  return number.value;
}

}  // namespace

std::optional<Places> read_places_alone(const std::string& path, const InputOptions& options,
                                        bool height_field) {
  const bool text = is_dash(path) ? options.format.has_value() : is_text(path);
  if (!text || (options.format && *options.format != "csv")) return std::nullopt;
  const FileBytes file = is_dash(path) ? standard_input() : load_file(path);
  LineReader lines(text_of(file));
  std::vector<Role> roles;
  if (options.columns)
    for (const std::string& name : *options.columns) roles.push_back(role_of(name));
  std::optional<Separator> separator;
  Places places;
  places.source = path;
  std::size_t first = 0, second = 0;
  TextLine line;
  while (lines.next(line)) {
    if (line.number <= options.skip_lines.value_or(0) || line.text.empty() || is_comment(line.text)) continue;
    const bool opening = !separator;
    if (opening) separator = find_separator(line.text);
    const std::vector<std::string_view> fields = split_fields(line.text, *separator);
    if (opening) {
      const bool header = std::none_of(fields.begin(), fields.end(), is_number);
      if (roles.empty() && header)
        for (const std::string_view field : fields) roles.push_back(role_of(field));
      if (roles.empty() && fields.size() == 2)
        roles = height_field ? std::vector{Role::x, Role::y} : std::vector{Role::u, Role::v};
      if (roles.empty() || has(roles, Role::z)) return std::nullopt;
      const Role wanted[] = {height_field ? Role::x : Role::u, height_field ? Role::y : Role::v};
      if (!has(roles, wanted[0]) || !has(roles, wanted[1]))
        throw FileError(path, line.number,
                        fmt::format("places need the columns {}, {}; name the columns with --columns",
                                    role_name(wanted[0]), role_name(wanted[1])));
      first = column(roles, wanted[0]);
      second = column(roles, wanted[1]);
      if (header) continue;
    }
    if (fields.size() != roles.size())
      throw FileError(path, line.number,
                      fmt::format("{} columns, but {} before", fields.size(), roles.size()));
    places.a.push_back(number_at(path, line, fields, first));
    places.b.push_back(number_at(path, line, fields, second));
    places.line.push_back(line.number);
  }
  if (places.size() == 0) throw FileError(path, "holds no places");
  return places;
}

}  // namespace knotfit::tool
