// From argv to plain option structs.
#pragma once
#include <optional>
#include <stdexcept>
#include <string>

#include "options.h"
namespace knotfit::tool {

/// A command line that asks for something that does not exist or does not go together.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct ParsedCommandLine {
  std::optional<Arguments> run;  ///< absent where only `text` was asked for
  std::string text;              ///< help or version, for standard output
};

/// \throws UsageError  the message names the option and where help is
ParsedCommandLine parse_command_line(int argc, const char* const* argv);

}  // namespace knotfit::tool
