// Keywords as the rows of the tool's options: one table of names, defaults and words.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "tool/option_rows.h"
#include "tool/options.h"
namespace knotfit::python {

/// (keyword, value as the command line writes it).
using Texts = std::vector<std::pair<std::string, std::string>>;

/// "max_control_points" of --max-control-points.
std::string keyword_of(const tool::OptionRow& row);

/// Each text as its row of the command takes it, beside what `start` has.
/// \throws InvalidInput  begins with the keyword
tool::Arguments take_texts(tool::Command command, const Texts& texts, tool::Arguments start = {});

/// As take_texts, then what a stored options file has (none: empty), then the defaults.
/// \param[out] default_tolerance  as tool::complete_choices()
tool::Arguments complete_texts(const Texts& texts, const std::string& stored, bool& default_tolerance);

}  // namespace knotfit::python
