// The numbers of one line of points in text.
#pragma once
#include <span>
#include <string_view>

#include "formats/text_lines.h"
namespace knotfit {

/// Fills a line's numbers; a missing value is NaN. Of a line whose separator is a tab, empty cells at its ends count.
/// \param into  where each column's number goes; null: the column is left out
/// \return false where something is wrong with the line
bool parse_line(const TextLine& line, std::span<double* const> into, Separator separator);

}  // namespace knotfit
