// Text as lines and fields.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "formats/file_bytes.h"
#include "knotfit/index.h"
namespace knotfit {

inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v';
}

inline const char* skip_blanks(const char* p, const char* end) {
  while (p < end && is_blank(*p)) ++p;
  return p;
}

std::string_view trimmed(std::string_view text);
std::string lower_case(std::string_view text);

/// One line without its end; blanks at both ends are left out.
struct TextLine {
  std::string_view text;
  Index number = 0;          ///< from 1
  std::string_view whole{};  ///< with the blanks at its ends
};

/// Lines of a text that end with LF, CR LF or (where the text has no LF at all) CR.
class LineReader {
 public:
  explicit LineReader(std::string_view text);
  bool next(TextLine& line);
  /// Bytes not yet read.
  std::size_t left() const { return rest_.size(); }
  std::string_view rest() const { return rest_; }

 private:
  std::string_view rest_;
  Index number_ = 0;
  char end_ = '\n';
};

/// Words of a text, parted by blanks and line ends.
Index count_numbers(std::string_view text);

/// The text before a Ctrl-Z (DOS and CP/M end a text with it) or zero bytes that have nothing but padding behind them.
std::string_view without_end_mark(std::string_view text);

/// The text of a file after its byte order mark, and before a Ctrl-Z or zero bytes at its end.
/// \throws FileError  not text (a zero byte), or UTF-16
std::string_view text_of(const FileBytes& file);

/// What parts the fields of a line. Blanks around a field never count.
enum class Separator : char { blanks = 0, tab = '\t', comma = ',', semicolon = ';' };

/// The separator of a line, outside quotes: semicolon, else comma, else tab, else blanks.
Separator find_separator(std::string_view line);

/// Fields of a line, trimmed, without their quotes. One empty field at the end (a trailing
/// separator) is dropped.
std::vector<std::string_view> split_fields(std::string_view line, Separator separator);

/// The end of the field that begins at `begin`, where its quotes or its text end.
const char* field_end(const char* begin, const char* end, Separator separator);

/// A comment begins here: #, % or //.
inline bool is_comment(std::string_view text) {
  return text.starts_with('#') || text.starts_with('%') || text.starts_with("//");
}

}  // namespace knotfit
