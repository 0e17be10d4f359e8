// STEP as text [ISO 10303-21].
#pragma once
#include <string>
#include <string_view>
namespace knotfit::cad {

/// The first letters are those of a STEP file.
bool looks_like_step(std::string_view bytes);

/// Entities well formed, each reference defined once, each number of a size that a length may have. OpenCASCADE
/// warns of the first two and crashes later, and hangs on the third.
/// \throws FileError  cut off or damaged; names the line
void check_step(std::string_view bytes, const std::string& path);

}  // namespace knotfit::cad
