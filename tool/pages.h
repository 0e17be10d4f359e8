// The man page and the completions of shells, made of the rows of options when the tool is built.
#pragma once
#include <string>

#include "option_rows.h"
namespace knotfit::tool {

/// What an option is in a few words: its brief, or its help to the first stop.
std::string brief_of(const OptionRow& row, const Use& use);

std::string bash_completion();
std::string zsh_completion();
std::string fish_completion();

/// The template with each line `.\" @options COMMAND GROUP` replaced by that command's options of the group (of all groups
/// where none is named) that no line before has, and @VERSION@ by the version.
/// \throws InvalidInput  a line names no command or no option is left for it; an option that no line has
std::string man_page(const std::string& text);

}  // namespace knotfit::tool
