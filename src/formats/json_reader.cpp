#include "formats/json_reader.h"

#include <fmt/format.h>

#include <algorithm>

#include "formats/number.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

constexpr int kDeepest = 100;

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Bytes of the UTF-8 character at p [RFC 3629, table 3-7 of Unicode]; 0: none.
int utf8_length(const char* p, const char* end) {
  const auto byte = [&](int i) { return p + i < end ? static_cast<unsigned char>(p[i]) : 0U; };
  const auto tail = [&](int i) { return byte(i) >= 0x80 && byte(i) <= 0xBF; };
  const unsigned lead = byte(0);
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return tail(1) ? 2 : 0;
  if (lead >= 0xE0 && lead <= 0xEF) {
    const unsigned low = lead == 0xE0 ? 0xA0 : 0x80, high = lead == 0xED ? 0x9F : 0xBF;
    return byte(1) >= low && byte(1) <= high && tail(2) ? 3 : 0;
  }
  if (lead >= 0xF0 && lead <= 0xF4) {
    const unsigned low = lead == 0xF0 ? 0x90 : 0x80, high = lead == 0xF4 ? 0x8F : 0xBF;
    return byte(1) >= low && byte(1) <= high && tail(2) && tail(3) ? 4 : 0;
  }
  return 0;
}

void append_utf8(std::string& out, unsigned code) {
  const auto put = [&](unsigned byte) { out += static_cast<char>(byte); };
  if (code < 0x80) {
    put(code);
  } else if (code < 0x800) {
    put(0xC0 | code >> 6);
    put(0x80 | (code & 0x3F));
  } else if (code < 0x10000) {
    put(0xE0 | code >> 12);
    put(0x80 | (code >> 6 & 0x3F));
    put(0x80 | (code & 0x3F));
  } else {
    put(0xF0 | code >> 18);
    put(0x80 | (code >> 12 & 0x3F));
    put(0x80 | (code >> 6 & 0x3F));
    put(0x80 | (code & 0x3F));
  }
}

}  // namespace

void JsonReader::fail(const std::string& what) const {
  const auto line = 1 + std::count(text_.data(), std::min(p_, text_.data() + text_.size()), '\n');
  throw FileError(path_, line, member_.empty() ? what : member_ + ": " + what);
}

void JsonReader::skip_space() {
  while (p_ < end_ && (*p_ == ' ' || *p_ == '\n' || *p_ == '\t' || *p_ == '\r')) ++p_;
}

bool JsonReader::accept(char c) {
  skip_space();
  if (p_ == end_ || *p_ != c) return false;
  ++p_;
  return true;
}

void JsonReader::expect(char c, const char* otherwise) {
  if (!accept(c)) fail(p_ == end_ ? "the file ends too early" : otherwise);
}

JsonReader::Kind JsonReader::peek() {
  skip_space();
  if (p_ == end_) return Kind::none;
  switch (*p_) {
    case '{':
      return Kind::object;
    case '[':
      return Kind::array;
    case '"':
      return Kind::string;
    case 't':
    case 'f':
      return Kind::boolean;
    case 'n':
      return Kind::null;
    default:
      return *p_ == '-' || is_digit(*p_) ? Kind::number : Kind::none;
  }
}

std::string_view JsonReader::scan_number() {
  const char* begin = p_;
  if (p_ < end_ && *p_ == '-') ++p_;
  const auto digits = [&] {
    const char* first = p_;
    while (p_ < end_ && is_digit(*p_)) ++p_;
    if (p_ == first) fail("a number is malformed");
  };
  if (p_ < end_ && *p_ == '0')
    ++p_;
  else
    digits();
  if (p_ < end_ && *p_ == '.') {
    ++p_;
    digits();
  }
  if (p_ < end_ && (*p_ == 'e' || *p_ == 'E')) {
    ++p_;
    if (p_ < end_ && (*p_ == '+' || *p_ == '-')) ++p_;
    digits();
  }
  return {begin, static_cast<std::size_t>(p_ - begin)};
}

double JsonReader::number() {
  if (peek() != Kind::number) fail("a number is missing");
  const std::string_view token = scan_number();
  const ParsedNumber parsed = parse_number(token);
  if (parsed.status != NumberStatus::ok) fail(in_quotes(token) + " is beyond the range of a double");
  return parsed.value;
}

unsigned JsonReader::scan_hex4() {
  unsigned code = 0;
  for (int i = 0; i < 4; ++i) {
    const char c = p_ < end_ ? *p_++ : ' ';
    if (is_digit(c))
      code = code * 16 + static_cast<unsigned>(c - '0');
    else if ((c | 32) >= 'a' && (c | 32) <= 'f')
      code = code * 16 + static_cast<unsigned>((c | 32) - 'a' + 10);
    else
      fail("a \\u escape lacks its four digits");
  }
  return code;
}

void JsonReader::scan_escape(std::string* out) {
  constexpr std::string_view kLetters = "\"\\/bfnrt", kMeanings = "\"\\/\b\f\n\r\t";
  const char c = p_ < end_ ? *p_++ : ' ';
  if (const std::size_t at = kLetters.find(c); at != std::string_view::npos) {
    if (out != nullptr) *out += kMeanings[at];
    return;
  }
  if (c != 'u') fail("a string has an unknown escape");
  unsigned code = scan_hex4();
  if (code >= 0xDC00 && code <= 0xDFFF) fail("a string has half a surrogate pair");
  if (code >= 0xD800 && code <= 0xDBFF) {
    if (end_ - p_ < 2 || p_[0] != '\\' || p_[1] != 'u') fail("a string has half a surrogate pair");
    p_ += 2;
    const unsigned low = scan_hex4();
    if (low < 0xDC00 || low > 0xDFFF) fail("a string has half a surrogate pair");
    code = 0x10000 + ((code - 0xD800) << 10) + (low - 0xDC00);
  }
  if (out != nullptr) append_utf8(*out, code);
}

void JsonReader::scan_utf8(std::string* out) {
  if (static_cast<unsigned char>(*p_) < 0x20) fail("a string has a control character");
  const int length = utf8_length(p_, end_);
  if (length == 0) fail("a string is not UTF-8");
  if (out != nullptr) out->append(p_, static_cast<std::size_t>(length));
  p_ += length;
}

void JsonReader::scan_string(std::string* out) {
  expect('"', "a string is missing");
  for (;;) {
    if (p_ == end_) fail("a string does not end");
    if (*p_ == '"') {
      ++p_;
      return;
    }
    if (*p_ == '\\') {
      ++p_;
      scan_escape(out);
    } else {
      scan_utf8(out);
    }
  }
}

std::string JsonReader::string() {
  std::string out;
  scan_string(&out);
  return out;
}

void JsonReader::scan_word(std::string_view word) {
  if (!std::string_view(p_, static_cast<std::size_t>(end_ - p_)).starts_with(word))
    fail("a value is malformed");
  p_ += word.size();
}

bool JsonReader::boolean() {
  if (peek() != Kind::boolean) fail("true or false is missing");
  const bool value = *p_ == 't';
  scan_word(value ? "true" : "false");
  return value;
}

void JsonReader::skip_value(int depth) {
  if (depth > kDeepest) fail(fmt::format("nested deeper than {}", kDeepest));
  switch (peek()) {
    case Kind::object:
      ++p_;
      if (accept('}')) return;
      do {
        scan_string(nullptr);
        expect(':', "':' is missing after a name");
        skip_value(depth + 1);
      } while (accept(','));
      expect('}', "',' or '}' is missing in an object");
      return;
    case Kind::array:
      array([&](Index) { skip_value(depth + 1); });
      return;
    case Kind::string:
      scan_string(nullptr);
      return;
    case Kind::number:
      scan_number();
      return;
    case Kind::boolean:
      boolean();
      return;
    case Kind::null:
      scan_word("null");
      return;
    case Kind::none:
      break;
  }
  fail(p_ == end_ ? "the file ends too early" : "a value is missing");
}

std::string_view JsonReader::skip() {
  skip_space();
  const char* begin = p_;
  skip_value(0);
  return {begin, static_cast<std::size_t>(p_ - begin)};
}

std::vector<std::pair<std::string, std::string_view>> JsonReader::members() {
  std::vector<std::pair<std::string, std::string_view>> out;
  expect('{', "an object is missing");
  if (accept('}')) return out;
  do {
    std::string name = string();
    expect(':', "':' is missing after a name");
    const std::string_view value = skip();
    out.emplace_back(std::move(name), value);
  } while (accept(','));
  expect('}', "',' or '}' is missing in an object");
  return out;
}

void JsonReader::finish() {
  skip_space();
  if (p_ != end_) fail("something follows the end of the JSON value");
}

std::string json_quoted(std::string_view text) {
  std::string out = "\"";
  const char* p = text.data();
  const char* const end = p + text.size();
  while (p < end) {
    const auto byte = static_cast<unsigned char>(*p);
    if (byte == '"' || byte == '\\') {
      out += '\\';
      out += *p++;
    } else if (byte < 0x20) {
      out += fmt::format("\\u{:04x}", byte);
      ++p;
    } else if (const int length = utf8_length(p, end); length > 0) {
      out.append(p, static_cast<std::size_t>(length));
      p += length;
    } else {
      out += "\xEF\xBF\xBD";
      ++p;
    }
  }
  return out + '"';
}

}  // namespace knotfit
