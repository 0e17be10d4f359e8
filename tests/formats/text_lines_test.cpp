#include "formats/text_lines.h"

#include "support.h"
namespace knotfit {
namespace {

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> out;
  LineReader reader(text);
  TextLine line;
  while (reader.next(line)) {
    out.emplace_back(line.text);
    EXPECT_EQ(line.number, static_cast<Index>(out.size()));
  }
  return out;
}

using Strings = std::vector<std::string>;

TEST(TextLines, EndsOfEverySystemGiveTheSameLines) {
  const Strings expected = {"a", "", "b c"};
  EXPECT_EQ(lines_of("a\n\nb c\n"), expected);
  EXPECT_EQ(lines_of("a\n\n  b c  "), expected);
  EXPECT_EQ(lines_of("a\r\n\r\nb c\r\n"), expected);
  EXPECT_EQ(lines_of("a\r\rb c\r"), expected);
  EXPECT_TRUE(lines_of("").empty());
}

Strings split(std::string_view line) {
  Strings out;
  for (const auto field : split_fields(line, find_separator(line))) out.emplace_back(field);
  return out;
}

TEST(TextLines, FieldsArePartedByAnySeparator) {
  const Strings expected = {"1", "2", "3"};
  for (const char* line :
       {"1 2 3", "  1   2  3 ", "1,2,3", "1 , 2 , 3", "1;2;3;", "1\t2\t3", "\"1\",\"2\",\"3\"", "1, 2, 3,"})
    EXPECT_EQ(split(line), expected) << line;
  EXPECT_EQ(split("1,,3"), (Strings{"1", "", "3"}));
  EXPECT_EQ(split("1\t\t3"), (Strings{"1", "", "3"}));
  EXPECT_EQ(split("\"a, b\",2"), (Strings{"a, b", "2"}));
  EXPECT_EQ(split("\"a b\" 2"), (Strings{"a b", "2"}));
  EXPECT_EQ(split("1,5;2,5"), (Strings{"1,5", "2,5"}));
  EXPECT_EQ(
      [] {
        const auto fields = split_fields("\"open,2", Separator::comma);
        return Strings(fields.begin(), fields.end());
      }(),
      (Strings{"\"open", "2"}));
}

TEST(TextLines, WhatIsNoTextIsRefused) {
  test::expect_throw<FileError>([] { text_of(FileBytes("a", std::string("1\0002", 3))); },
                                "not a text file (byte 1");
  test::expect_throw<FileError>([] { text_of(FileBytes("a", "\xFF\xFEx")); }, "UTF-16");
  EXPECT_EQ(text_of(FileBytes("a", "\xEF\xBB\xBFx")), "x");
}

TEST(TextLines, ACtrlZEndsADosText) {
  using namespace std::string_literals;
  for (const std::string& end :
       {"\x1A"s, "\x1A\r\n"s, "\x1A\x1A\x1A"s, "\x1A\0\0\0"s, "\x1A \n"s, "\0\0\0"s, "\0\x1A\n"s})
    EXPECT_EQ(text_of(FileBytes("a", "1 2\r\n" + end)), "1 2\r\n");
  // Anything else behind it is no padding.
  EXPECT_EQ(text_of(FileBytes("a", "1 \x1A 2\n")), "1 \x1A 2\n");
  EXPECT_EQ(text_of(FileBytes("a", "\x1A")), "");
}

}  // namespace
}  // namespace knotfit
