// What --help and --help-all print, and what is said of a command line that cannot be read.
#pragma once
#include <memory>
#include <string>
namespace CLI {
class App;
class FormatterBase;
}  // namespace CLI
namespace knotfit::tool {

/// The layout of all help texts. Of a command with many options --help prints those that most people need.
std::shared_ptr<CLI::FormatterBase> help_formatter();

/// The help of the chosen command, or the general one. With `everything` all options, of all commands where none is
/// chosen.
std::string help_of(const CLI::App& app, bool everything);

/// A command or an option that is not there, with the nearest that is; else `what`, with the place of the help.
/// \param app  after it refused to parse argv
std::string usage_message(const CLI::App& app, int argc, const char* const* argv, const std::string& what);

}  // namespace knotfit::tool
