// "-" as a file: standard input and standard output.
#pragma once
#include <string>

#include "formats/file_bytes.h"
namespace knotfit::tool {

/// The path stands for standard input, or as an output for standard output.
bool is_dash(const std::string& path);

/// What standard input holds, to its end, under the path "standard input". Read once, however often it is asked for.
/// \throws FileError  it is empty or cannot be read
FileBytes standard_input();

/// The path, or "standard input": for messages.
std::string input_name(const std::string& path);

}  // namespace knotfit::tool
