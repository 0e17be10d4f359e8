#include "formats/point_line.h"

#include <limits>

#include "formats/missing.h"
#include "formats/number.h"
namespace knotfit {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A number that the fast path refused: in quotes, of another spelling, or missing.
bool parse_token(std::string_view token, double& value) {
  token = trimmed(token);
  if (token.size() >= 2 && token.front() == '"' && token.back() == '"')
    token = trimmed(token.substr(1, token.size() - 2));
  const ParsedNumber parsed = parse_number(token);
  if (parsed.status == NumberStatus::ok)
    value = parsed.value;
  else if (parsed.status == NumberStatus::not_a_number && is_missing_word(token))
    value = kNan;
  else
    return false;
  return true;
}

bool parse_text(std::string_view text, std::span<double* const> into, Separator separator) {
  const char* p = text.data();
  const char* const end = p + text.size();
  const bool blanks = separator == Separator::blanks;
  const char mark = static_cast<char>(separator);
  const std::size_t columns = into.size();
  bool parted = false;  // a separator was the last thing read
  for (std::size_t column = 0;; ++column) {
    while (p < end && is_blank(*p) && (blanks || *p != mark)) ++p;
    if (column == columns) return p == end || is_comment({p, static_cast<std::size_t>(end - p)});
    if (p == end) {  // nothing is left: an empty cell after the last separator, or too few
      if (!parted || column + 1 != columns) return false;
      if (into[column] != nullptr) *into[column] = kNan;
      return true;
    }
    const char* next = nullptr;
    if (into[column] == nullptr) {
      next = field_end(p, end, separator);
    } else {
      double& value = *into[column];
      next = parse_prefix(p, end, value);
      if (next == p || (next < end && *next != mark && !is_blank(*next))) {
        next = field_end(p, end, separator);
        if (!parse_token({p, static_cast<std::size_t>(next - p)}, value)) return false;
      }
    }
    if (!blanks) {
      while (next < end && is_blank(*next) && *next != mark) ++next;
      parted = next < end && *next == mark;
      if (parted)
        ++next;
      else if (next < end &&
               (column + 1 < columns || !is_comment({next, static_cast<std::size_t>(end - next)})))
        return false;
    }
    p = next;
  }
}

}  // namespace

bool parse_line(const TextLine& line, std::span<double* const> into, Separator separator) {
  if (parse_text(line.text, into, separator)) return true;
  return separator == Separator::tab && parse_text(line.whole, into, separator);
}

}  // namespace knotfit
