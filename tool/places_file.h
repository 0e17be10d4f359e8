// Text files of places alone: two columns u,v or x,y, which no reader of data takes.
#pragma once
#include <optional>
#include <string>

#include "options.h"
#include "places.h"
namespace knotfit::tool {

/// The places of a text file whose columns, by --columns, header or number, are a pair without
/// values; nothing where it is another kind of file.
/// \param height_field  the pair wanted is x,y, not u,v
/// \throws FileError  the other pair; a line that is not two numbers
std::optional<Places> read_places_alone(const std::string& path, const InputOptions& options,
                                        bool height_field);

}  // namespace knotfit::tool
