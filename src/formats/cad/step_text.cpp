// OpenCASCADE's STEP text, made shorter and standard [ISO 10303-21].
#include <fmt/format.h>

#include <charconv>

#include "formats/cad/occt.h"
#include "formats/number.h"
namespace knotfit::cad {
namespace {

/// One character of UTF-8 at `p`, passed over; what is none stands for itself (Latin 1).
unsigned next_character(const char*& p, const char* end) {
  const auto byte = [](char c) { return static_cast<unsigned>(static_cast<unsigned char>(c)); };
  const unsigned first = byte(*p++);
  const int more = first < 0xC2 ? 0 : first < 0xE0 ? 1 : first < 0xF0 ? 2 : first < 0xF5 ? 3 : 0;
  if (more == 0 || end - p < more) return first;
  unsigned code = first & (0x3Fu >> more);
  for (int k = 0; k < more; ++k) {
    if ((byte(p[k]) & 0xC0) != 0x80) return first;
    code = code << 6 | (byte(p[k]) & 0x3F);
  }
  p += more;
  return code;
}

/// A quoted string from its first quote on: lines joined, what is beyond ASCII as \X2\ or \X4\.
void append_string(std::string& out, const char*& p, const char* end) {
  std::string raw;
  out += *p++;
  while (p < end && *p != '\'') {
    if (*p != '\n') raw += *p;
    ++p;
  }
  const char* from = raw.data();
  const char* const to = from + raw.size();
  while (from < to) {
    const unsigned code = next_character(from, to);
    if (code >= 0x20 && code < 0x7F)
      out += static_cast<char>(code);
    else if (code <= 0xFFFF)
      out += fmt::format("\\X2\\{:04X}\\X0\\", code);
    else
      out += fmt::format("\\X4\\{:08X}\\X0\\", code);
  }
  if (p < end) out += *p++;
}

/// A real with 17 digits, as short as it reads back exactly; a real keeps its point.
void append_real(std::string& out, const char* begin, const char* end) {
  double value = 0;
  std::from_chars(begin, end, value);
  std::string number;
  append_number(number, value);
  const std::size_t exponent = number.find('e');
  if (exponent != std::string::npos) number[exponent] = 'E';
  if (number.find('.') == std::string::npos) number.insert(std::min(exponent, number.size()), ".");
  out += number;
}

}  // namespace

std::string tidy_step(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  const char* p = text.data();
  const char* const end = p + text.size();
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  while (p < end) {
    const char before = out.empty() ? '\n' : out.back();
    if (*p == '\'') {
      append_string(out, p, end);
    } else if ((digit(*p) || *p == '-') &&
               (before == '(' || before == ',' || before == ' ' || before == '\n')) {
      const char* q = p + 1;
      while (q < end && (digit(*q) || *q == '.' || *q == 'E' || *q == '+' || *q == '-')) ++q;
      if (std::string_view(p, q).find('.') == std::string_view::npos)
        out.append(p, q);
      else
        append_real(out, p, q);
      p = q;
    } else {
      out += *p++;
    }
  }
  return out;
}

}  // namespace knotfit::cad
