// The options of a fit as JSON: stored in every output, repeated by --options.
#pragma once
#include <string>

#include "options.h"
namespace knotfit::tool {

/// A JSON object as text: one member an option, null where it has no value.
std::string options_to_json(const FitChoices& choices);

/// The "options" of a surface.json, or of the output of --json, for every option that the command line left open; where it
/// gave a size or knots, stored sizes and knots that do not go with them are left out.
/// \throws FileError  missing, not JSON, without options; names the member that is not as written
///   by options_to_json
void add_stored_options(Arguments& arguments, const std::string& path);

/// The defaults of what is still open, where outputs store them.
void add_usual_options(Arguments& arguments);

/// The options in force as a command line would give them, defaults left out: "--tol 1% --rms".
std::string options_to_text(const FitChoices& choices);

}  // namespace knotfit::tool
