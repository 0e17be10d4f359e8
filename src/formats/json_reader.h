// JSON [RFC 8259] read in place, value by value: no tree, so that a file costs no more memory than
// its numbers; every number correctly rounded in every locale; every error with its line.
#pragma once
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "knotfit/index.h"
namespace knotfit {

class JsonReader {
 public:
  /// Reads `value`, a part of `text` (the whole text itself at first).
  JsonReader(std::string_view text, std::string_view value, const std::string& path)
      : text_(text), p_(value.data()), end_(value.data() + value.size()), path_(path) {}

  enum class Kind { object, array, string, number, boolean, null, none };
  /// What comes next, by its first character.
  Kind peek();

  /// Names and texts of an object's members. \throws FileError  malformed, or nested too deep
  std::vector<std::pair<std::string, std::string_view>> members();
  /// Calls element(k) for each element of an array; it must read that element.
  template <class Element>
  void array(const Element& element) {
    expect('[', "an array is missing");
    if (accept(']')) return;
    for (Index k = 0;; ++k) {
      element(k);
      if (accept(']')) return;
      expect(',', "',' or ']' is missing in an array");
    }
  }
  double number();
  std::string string();
  bool boolean();
  /// Passes over one value of any kind, checking it. \return its text
  std::string_view skip();
  /// \throws FileError  something follows
  void finish();

  /// \throws FileError  always, with the line of the place reached
  [[noreturn]] void fail(const std::string& what) const;
  /// Prefix of all messages: the member being read.
  void set_member(std::string member) { member_ = std::move(member); }

 private:
  void skip_space();
  bool accept(char c);
  void expect(char c, const char* otherwise);
  void skip_value(int depth);
  std::string_view scan_number();
  void scan_word(std::string_view word);
  unsigned scan_hex4();
  void scan_escape(std::string* out);
  void scan_utf8(std::string* out);
  void scan_string(std::string* out);

  std::string_view text_;
  const char* p_;
  const char* end_;
  const std::string& path_;
  std::string member_;
};

/// A string as a JSON string with its quotes. Bytes that are not UTF-8 become U+FFFD.
std::string json_quoted(std::string_view text);

}  // namespace knotfit
