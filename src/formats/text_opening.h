// How a text of points begins: names, counts and titles before the data, a header, what the columns are.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "formats/columns.h"
#include "formats/file_bytes.h"
#include "formats/text_lines.h"
#include "knotfit/io.h"
namespace knotfit {

struct TextOpening {
  Columns columns;
  std::string columns_from;  ///< "option", "header", "guess"
  Separator separator = Separator::blanks;
  bool header = false;                  ///< a line (not a comment) names the columns
  TextLine first;                       ///< the first line with data
  LineReader rest{std::string_view()};  ///< what follows it
  std::vector<std::string> notes;       ///< what was left out, a sentence each
  /// Points of the upper and the lower surface of an airfoil in Lednicer's form; 0, 0: it is none.
  Index upper = 0, lower = 0;
  /// Where the number of columns comes from, for messages.
  std::string origin;
  /// What may help where the second line with data differs from the first: to skip it.
  std::string hint;
};

/// A line that holds nothing, or separators alone (a spreadsheet's empty row).
bool is_empty_line(std::string_view line);

/// \throws FileError  no line with data, a header that makes no points, columns that nothing tells; names the line
TextOpening open_point_text(const FileBytes& file, const ReadOptions& options);

}  // namespace knotfit
