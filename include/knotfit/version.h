// The library's version.
#pragma once
#include <string_view>
namespace [[gnu::visibility("default")]] knotfit {
/// "major.minor.patch"
std::string_view version();
}  // namespace knotfit
