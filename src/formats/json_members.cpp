#include "formats/json_members.h"

#include <fmt/format.h>
namespace knotfit {

JsonMembers::JsonMembers(std::string_view text, std::string_view object, const std::string& path,
                         const char* what)
    : text_(text), place_(object), path_(path), what_(what) {
  JsonReader reader(text, object, path);
  if (reader.peek() != JsonReader::Kind::object) reader.fail("a JSON object is missing");
  members_ = reader.members();
  reader.finish();
}

std::optional<std::string_view> JsonMembers::find(std::string_view name) const {
  std::optional<std::string_view> found;
  for (const auto& [key, value] : members_) {
    if (key != name) continue;
    if (found) at(name, value).fail("the member is there twice");
    found = value;
  }
  return found;
}

JsonReader JsonMembers::at(std::string_view name, std::string_view value) const {
  JsonReader reader(text_, value, path_);
  reader.set_member(std::string(name));
  return reader;
}

std::string_view JsonMembers::get(std::string_view name) const {
  const auto value = find(name);
  if (!value) at({}, place_).fail(fmt::format("not a {}: the member \"{}\" is missing", what_, name));
  return *value;
}

JsonReader JsonMembers::at(std::string_view name) const {
  return at(name, get(name));
}

}  // namespace knotfit
