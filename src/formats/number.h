// Numbers in text: the same in every locale, correctly rounded.
#pragma once
#include <charconv>
#include <string>
#include <string_view>
#include <system_error>

#include "knotfit/index.h"
namespace knotfit {

enum class NumberStatus { ok, not_a_number, too_large };

struct ParsedNumber {
  NumberStatus status = NumberStatus::not_a_number;
  double value = 0;
};

/// A whole token as a double: decimal, with a leading + and Fortran's exponent letter D too;
/// nan and inf are numbers. What is below the smallest double is 0.
ParsedNumber parse_number(std::string_view token);

/// A whole token as a count >= 0, also written as "14.0" or "1.4e1". \return -1 where it is none
Index parse_count(std::string_view token);

/// The longest number at the start of [begin, end), or begin where there is none: the fast path.
inline const char* parse_prefix(const char* begin, const char* end, double& value) {
  const auto [next, error] = std::from_chars(begin, end, value);
  return error == std::errc() ? next : begin;
}

/// The shortest text that reads back as the same double.
void append_number(std::string& out, double value);

/// A token for a message: quoted, cut where it is long, control bytes as '?'.
std::string in_quotes(std::string_view token);

}  // namespace knotfit
