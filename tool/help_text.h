// The longer texts of --help.
#pragma once
#include <string>
#include <string_view>
namespace knotfit::tool {

/// `text` broken at spaces so that no line passes `width`; line breaks in it stay.
std::string wrap(std::string_view text, std::size_t width);

/// Commands that work as printed, run in order from the project's root; "" is the general help.
std::string examples(std::string_view command);

/// The exit statuses, for the end of a help text.
std::string exit_statuses();

/// Names of the placement methods, "uniform, quantile, ...".
std::string method_names();

}  // namespace knotfit::tool
