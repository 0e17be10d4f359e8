// The name that somebody meant.
#pragma once
#include <string>
#include <string_view>
#include <vector>
namespace knotfit::tool {

/// The one of `names` that `word` was most likely meant to be: few letters changed, left out, added or swapped, or one
/// that begins or ends with the other at a dash ("--format" for "--input-format", "--tolerance" for "--tol").
/// \return empty where none is near
std::string nearest_name(std::string_view word, const std::vector<std::string>& names);

}  // namespace knotfit::tool
