// What the knotfit JSON documents share: the head, lists of numbers, and objects kept as text.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "formats/json_members.h"
namespace knotfit {

/// Without a byte order mark, and without a Ctrl-Z at the end.
std::string_view without_mark(std::string_view text);
/// \throws FileError  the member "format" is not `format`
void check_format(const JsonMembers& in, std::string_view format);
/// \throws FileError  the member "version" is not `version`
void check_version(const JsonMembers& in, int version);
/// The text of an object member; empty where it is absent or null. \throws FileError  it is something else
std::string object_of(const JsonMembers& in, std::string_view name);

/// "[1, 2, 3]"
void append_numbers(std::string& out, std::span<const double> values);
/// A member with an object as its text; nothing where `text` is empty.
/// \param what  of the document, for messages: "surface"
/// \throws InvalidInput  `text` is not one JSON object
void append_object(std::string& out, std::string_view name, std::string_view text, const char* what);

}  // namespace knotfit
