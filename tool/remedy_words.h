// What the library calls a remedy, in the tool's own words: its texts name `fill_holes`, the tool's user says --fill-holes.
#pragma once
#include <string>
#include <string_view>

#include "knotfit/remedy.h"
namespace knotfit::tool {

/// "--nodata nan"; of what no option does, the command that does it.
std::string words_for(const NamedRemedy& remedy);

/// A text of the library, as the tool says it; what the tool wrote itself stays as it is.
std::string in_tool_words(std::string_view text);

/// Likewise the message and the notes of a result.
template <class Result>
void put_in_tool_words(Result& result) {
  result.message = in_tool_words(result.message);
  for (std::string& note : result.notes) note = in_tool_words(note);
}

}  // namespace knotfit::tool
