#include "formats/text_lines.h"

#include <algorithm>
#include <cstring>

#include "knotfit/exceptions.h"
namespace knotfit {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return out;
}

LineReader::LineReader(std::string_view text) : rest_(text) {
  if (text.find('\n') == std::string_view::npos && text.find('\r') != std::string_view::npos) end_ = '\r';
}

bool LineReader::next(TextLine& line) {
  if (rest_.empty()) return false;
  const std::size_t end = rest_.find(end_);
  line.whole = rest_.substr(0, end);
  while (line.whole.ends_with('\r')) line.whole.remove_suffix(1);
  line.text = trimmed(line.whole);
  line.number = ++number_;
  rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
  return true;
}

Index count_numbers(std::string_view text) {
  Index count = 0;
  bool before = false;
  for (const char c : text) {
    const bool in_word = c != ' ' && c != '\t' && c != '\n' && c != '\r';
    count += in_word && !before;
    before = in_word;
  }
  return count;
}

std::string_view without_end_mark(std::string_view text) {
  const std::size_t last = text.find_last_not_of(std::string_view("\0\x1A\n\r \t\f\v", 8));
  return text.substr(
      0, text.find_first_of(std::string_view("\0\x1A", 2), last == std::string_view::npos ? 0 : last + 1));
}

std::string_view text_of(const FileBytes& file) {
  std::string_view text = without_end_mark(file.view());
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
    throw FileError(file.path(), "is UTF-16 text; save it as UTF-8");
  const std::size_t zero = text.find('\0');
  if (zero != std::string_view::npos)
    throw FileError(file.path(), "is not a text file (byte " + std::to_string(zero) + " is zero)");
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

Separator find_separator(std::string_view line) {
  Separator found = Separator::blanks;
  char quote = 0;
  for (const char c : line) {
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"') {
      quote = c;
    } else if (c == ';') {
      return Separator::semicolon;
    } else if (c == ',') {
      found = Separator::comma;
    } else if (c == '\t' && found == Separator::blanks) {
      found = Separator::tab;
    }
  }
  return found;
}

const char* field_end(const char* begin, const char* end, Separator separator) {
  const char* p = begin;
  if (p < end && *p == '"') {
    const char* close =
        static_cast<const char*>(std::memchr(p + 1, '"', static_cast<std::size_t>(end - p - 1)));
    if (close != nullptr) p = close + 1;
  }
  if (separator == Separator::blanks) {
    while (p < end && !is_blank(*p)) ++p;
    return p;
  }
  return std::find(p, end, static_cast<char>(separator));
}

std::vector<std::string_view> split_fields(std::string_view line, Separator separator) {
  std::vector<std::string_view> fields;
  const char* p = line.data();
  const char* const end = p + line.size();
  while (p < end) {
    if (separator == Separator::blanks) {
      p = skip_blanks(p, end);
      if (p == end) break;
    } else {
      while (p < end && is_blank(*p) && *p != static_cast<char>(separator)) ++p;
    }
    const char* const stop = field_end(p, end, separator);
    std::string_view field = trimmed({p, static_cast<std::size_t>(stop - p)});
    if (field.size() >= 2 && field.front() == '"' && field.back() == '"')
      field = trimmed(field.substr(1, field.size() - 2));
    fields.push_back(field);
    p = stop < end ? stop + 1 : end;
    // Only a separator right at the end of the line leaves an empty field behind, and that one
    // is dropped: the loop ends here.
  }
  return fields;
}

}  // namespace knotfit
