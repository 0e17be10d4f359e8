#include "formats/number.h"

#include <algorithm>
#include <cmath>
namespace knotfit {
namespace {

ParsedNumber parse_plain(std::string_view token) {
  double value = 0;
  const char* end = token.data() + token.size();
  const auto [next, error] = std::from_chars(token.data(), end, value);
  if (next != end || error == std::errc::invalid_argument) return {};
  if (error == std::errc()) return {NumberStatus::ok, value};
  // from_chars does not say on which side of the range a number lies: a negative exponent or a
  // leading "0." tells.
  const std::size_t e = token.find_first_of("eE");
  const std::string_view magnitude = token.substr(token.front() == '-' ? 1 : 0);
  const bool tiny = e != std::string_view::npos ? e + 1 < token.size() && token[e + 1] == '-'
                                                : magnitude.starts_with("0.") || magnitude.starts_with(".");
  if (!tiny) return {NumberStatus::too_large, 0};
  return {NumberStatus::ok, token.front() == '-' ? -0.0 : 0.0};
}

}  // namespace

ParsedNumber parse_number(std::string_view token) {
  if (token.starts_with('+') && !token.starts_with("+-")) token.remove_prefix(1);
  if (token.empty()) return {};
  const ParsedNumber plain = parse_plain(token);
  if (plain.status != NumberStatus::not_a_number) return plain;
  const std::size_t d = token.find_first_of("dD");
  if (d == std::string_view::npos || d == 0 || token.size() > 64) return {};
  std::string text(token);
  text[d] = 'e';
  return parse_plain(text);
}

Index parse_count(std::string_view token) {
  if (token.starts_with('+')) token.remove_prefix(1);
  Index value = 0;
  const char* end = token.data() + token.size();
  const auto [next, error] = std::from_chars(token.data(), end, value);
  if (next == end && error == std::errc() && value >= 0) return value;
  // "14.0", "1.4e1": programs that know floating-point numbers only.
  constexpr double kExact = 9007199254740992;  // 2^53: whole numbers are exact up to it
  const ParsedNumber number = parse_number(token);
  const bool whole = number.status == NumberStatus::ok && number.value >= 0 && number.value <= kExact &&
                     number.value == std::floor(number.value);
  return whole ? static_cast<Index>(number.value) : -1;
}

void append_number(std::string& out, double value) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
  out.append(buffer, end);
}

std::string in_quotes(std::string_view token) {
  constexpr std::size_t kLongest = 40;
  std::string out = "\"";
  for (const char c : token.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(c);
    out += byte < 0x20 || byte >= 0x7f ? '?' : c;
  }
  return out + (token.size() > kLongest ? "...\"" : "\"");
}

}  // namespace knotfit
