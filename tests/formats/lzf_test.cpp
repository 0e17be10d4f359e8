#include "formats/lzf.h"

#include <gtest/gtest.h>

#include <string>

namespace knotfit {
namespace {

using namespace std::string_literals;

TEST(Lzf, TakesLiteralsAndCopies) {
  EXPECT_EQ(decompress_lzf("\x02"
                           "abc"s,
                           3),
            "abc");
  EXPECT_EQ(decompress_lzf("\x02"
                           "abc\x20\x02"s,
                           6),
            "abcabc")
      << "three bytes from three back";
  EXPECT_EQ(decompress_lzf("\x00"
                           "a\x80\x00"s,
                           7),
            "aaaaaaa")
      << "a copy that reaches into itself";
  EXPECT_EQ(decompress_lzf("\x00"
                           "x\xE0\x0A\x00"s,
                           20),
            std::string(20, 'x'))
      << "a long run: 7 + 10 + 2";
  EXPECT_EQ(decompress_lzf("", 0), "");
}

TEST(Lzf, IsNothingWhereTheInputIsDamaged) {
  const auto bad = [](const std::string& input, std::size_t size) {
    EXPECT_FALSE(decompress_lzf(input, size).has_value()) << size;
  };
  bad("\x02"
      "ab"s,
      3);  // literals cut off
  bad("\x02"
      "abc"s,
      4);  // too short
  bad("\x02"
      "abc"s,
      2);  // too long
  bad("\x00"
      "a\x20"s,
      4);  // no offset
  bad("\x00"
      "a\xE0"s,
      10);  // no length
  bad("\x00"
      "a\x20\x01"s,
      4);  // from before the begin
  bad("\x00"
      "a\x80\x00"s,
      6);  // the copy runs over
}

TEST(Lzf, ClaimsBeyondWhatBytesCanHoldTakeNoMemory) {
  EXPECT_FALSE(decompress_lzf("\x00"
                              "a"s,
                              std::size_t{1} << 60)
                   .has_value());
  // The best a reference can do: 3 bytes for 7 + 255 + 2.
  EXPECT_EQ(decompress_lzf("\x00"
                           "x\xE0\xFF\x00"s,
                           265),
            std::string(265, 'x'));
  EXPECT_GE(most_lzf_bytes(3), 264u);
}

}  // namespace
}  // namespace knotfit
