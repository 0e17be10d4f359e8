// Members of a JSON object by name.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "formats/json_reader.h"
namespace knotfit {

class JsonMembers {
 public:
  /// \param what  of the document, for messages: "knotfit curve"
  /// \throws FileError  not one JSON object
  JsonMembers(std::string_view text, std::string_view object, const std::string& path, const char* what);
  /// The text of a member, or nothing. \throws FileError  it is there twice
  std::optional<std::string_view> find(std::string_view name) const;
  /// \throws FileError  it is missing
  std::string_view get(std::string_view name) const;
  /// A reader on a member's text that names the member in its errors. \throws FileError  it is missing
  JsonReader at(std::string_view name) const;
  JsonReader at(std::string_view name, std::string_view value) const;

 private:
  std::string_view text_, place_;
  const std::string& path_;
  const char* what_;
  std::vector<std::pair<std::string, std::string_view>> members_;
};

}  // namespace knotfit
