#include "formats/json_document.h"

#include <fmt/format.h>

#include "formats/number.h"
#include "formats/text_lines.h"
#include "knotfit/exceptions.h"
namespace knotfit {

std::string_view without_mark(std::string_view text) {
  text = without_end_mark(text);
  return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

void check_format(const JsonMembers& in, std::string_view format) {
  JsonReader reader = in.at("format");
  if (reader.peek() != JsonReader::Kind::string) reader.fail("a name is missing");
  if (const std::string name = reader.string(); name != format)
    reader.fail(fmt::format("{} is a foreign schema, not \"{}\"", in_quotes(name), format));
}

void check_version(const JsonMembers& in, int version) {
  JsonReader reader = in.at("version");
  if (const double number = reader.number(); number != version)
    reader.fail(
        fmt::format("version {} of the schema is unknown; this program reads version {}", number, version));
}

std::string object_of(const JsonMembers& in, std::string_view name) {
  const auto value = in.find(name);
  if (!value) return {};
  JsonReader reader = in.at(name, *value);
  if (reader.peek() == JsonReader::Kind::null) return {};
  if (reader.peek() != JsonReader::Kind::object) reader.fail("an object is missing");
  return std::string(*value);
}

void append_numbers(std::string& out, std::span<const double> values) {
  out += '[';
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (k > 0) out += ", ";
    append_number(out, values[k]);
  }
  out += ']';
}

void append_object(std::string& out, std::string_view name, std::string_view text, const char* what) {
  if (text.empty()) return;
  const std::string place(name);
  try {
    JsonReader reader(text, text, place);
    if (reader.peek() != JsonReader::Kind::object) reader.fail("an object is missing");
    const std::string_view object = reader.skip();
    reader.finish();
    out += fmt::format(",\n  \"{}\": {}", name, object);
  } catch (const FileError& error) {
    throw InvalidInput(
        fmt::format("the {} of a {} document must be a JSON object: {}", name, what, error.what()));
  }
}

}  // namespace knotfit
