#include "formats/text_numbers.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "formats/number.h"
#include "knotfit/exceptions.h"
namespace knotfit {

LineNumbers::LineNumbers(const FileBytes& file, const TextLine& line, std::string_view text, const char* what)
    : file_(file), line_(line.number), at_(text.data()), end_(text.data() + text.size()), what_(what) {}

bool LineNumbers::at_end() {
  at_ = skip_blanks(at_, end_);
  return at_ == end_;
}

std::string_view LineNumbers::token() {
  if (at_end())
    throw FileError(file_.path(), static_cast<long long>(line_),
                    fmt::format("the {} has too few numbers", what_));
  const char* const begin = at_;
  while (at_ < end_ && !is_blank(*at_)) ++at_;
  return {begin, static_cast<std::size_t>(at_ - begin)};
}

double LineNumbers::number_or_nan() {
  const ParsedNumber parsed = parse_number(token());
  return parsed.status == NumberStatus::ok && std::isfinite(parsed.value)
             ? parsed.value
             : std::numeric_limits<double>::quiet_NaN();
}

double LineNumbers::number() {
  at_ = skip_blanks(at_, end_);
  double value = 0;
  const char* const stop = parse_prefix(at_, end_, value);
  if (stop > at_ && (stop == end_ || is_blank(*stop)) && std::isfinite(value)) {
    at_ = stop;
    return value;
  }
  const std::string_view word = token();
  const ParsedNumber parsed = parse_number(word);
  if (parsed.status == NumberStatus::ok && std::isfinite(parsed.value)) return parsed.value;
  const char* why = parsed.status == NumberStatus::ok          ? "is not a finite number"
                    : parsed.status == NumberStatus::too_large ? "is beyond the range of a double"
                                                               : "is not a number";
  throw FileError(file_.path(), static_cast<long long>(line_),
                  fmt::format("{}: {} {}", what_, in_quotes(word), why));
}

}  // namespace knotfit
