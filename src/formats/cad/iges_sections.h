// IGES as text: lines of 80 columns in sections [IGES 5.3, 2.2].
#pragma once
#include <string>
#include <string_view>
#include <vector>
namespace knotfit::cad {

/// Column 73 of the first line names a section.
bool looks_like_iges(std::string_view bytes);

/// Sections complete, and splines with as many numbers as their counts ask for: OpenCASCADE believes them.
/// \throws FileError  cut off or damaged; names the line
void check_iges(std::string_view bytes, const std::string& path);

/// The parameters of the global section. Strings (4HINCH) come without their count.
std::vector<std::string> iges_global_parameters(std::string_view bytes);

}  // namespace knotfit::cad
