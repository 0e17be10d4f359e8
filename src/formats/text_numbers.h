// Numbers on a line of a mesh in text, with errors that name the line.
#pragma once
#include <string>

#include "formats/text_lines.h"
namespace knotfit {

/// Takes number after number off a line.
class LineNumbers {
 public:
  /// \param what  the line holds, for messages: "vertex"
  LineNumbers(const FileBytes& file, const TextLine& line, std::string_view text, const char* what);
  bool at_end();
  /// The next token. \throws FileError  none is left
  std::string_view token();
  /// The next number. \throws FileError  none is left, not a number, not finite
  double number();
  /// The next number, NaN where it is none or not finite: of what may be left aside. \throws FileError  none is left
  double number_or_nan();

 private:
  const FileBytes& file_;
  Index line_;
  const char* at_;
  const char* end_;
  const char* what_;
};

}  // namespace knotfit
