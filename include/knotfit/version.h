// The library's version.
#pragma once
#include <string_view>
namespace knotfit {
/// "major.minor.patch"
std::string_view version();
}  // namespace knotfit
