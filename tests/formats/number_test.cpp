#include "formats/number.h"

#include <gtest/gtest.h>

#include <bit>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "support/random_splines.h"
namespace knotfit {
namespace {

double value_of(std::string_view token) {
  const ParsedNumber parsed = parse_number(token);
  EXPECT_EQ(parsed.status, NumberStatus::ok) << token;
  return parsed.value;
}

TEST(Number, ReadsEveryDecimalForm) {
  EXPECT_EQ(value_of("12"), 12);
  EXPECT_EQ(value_of("-0.5"), -0.5);
  EXPECT_EQ(value_of("+3.25"), 3.25);
  EXPECT_EQ(value_of(".5"), 0.5);
  EXPECT_EQ(value_of("5."), 5);
  EXPECT_EQ(value_of("1e3"), 1000);
  EXPECT_EQ(value_of("1E+3"), 1000);
  EXPECT_EQ(value_of("25e-2"), 0.25);
  EXPECT_EQ(value_of("1.5D+03"), 1500);  // Fortran
  EXPECT_EQ(value_of("-1d-2"), -0.01);
  EXPECT_TRUE(std::signbit(value_of("-0")));
  EXPECT_TRUE(std::isnan(value_of("NaN")));
  EXPECT_EQ(value_of("-inf"), -INFINITY);
}

TEST(Number, RefusesWhatIsNone) {
  for (const char* token : {"", "+", "-", ".", "e5", "1.2.3", "1,5", "0x10", "1e", "abc", "1 2", "--1", "+-1",
                            "1D", "D5", "12abc", "1_000", "1dd5", "1d5e3"})
    EXPECT_EQ(parse_number(token).status, NumberStatus::not_a_number) << token;
}

TEST(Number, TellsTooLargeFromTooSmall) {
  EXPECT_EQ(parse_number("1e400").status, NumberStatus::too_large);
  EXPECT_EQ(parse_number("-1d400").status, NumberStatus::too_large);
  EXPECT_EQ(parse_number(std::string(400, '9')).status, NumberStatus::too_large);
  EXPECT_EQ(value_of("1e-400"), 0);
  EXPECT_TRUE(std::signbit(value_of("-1e-400")));
  EXPECT_EQ(value_of("0." + std::string(400, '0') + "1"), 0);
  EXPECT_EQ(value_of("4.9406564584124654e-324"), 4.9406564584124654e-324);
  EXPECT_EQ(value_of("1.7976931348623157e308"), 1.7976931348623157e308);
}

// strtod, correctly rounded in the C library, is the witness.
TEST(Number, IsCorrectlyRoundedAndReadsBackWhatItWrites) {
  test::Random random;
  for (int k = 0; k < 20000; ++k) {
    std::uint64_t bits = 0;
    for (int part = 0; part < 4; ++part)
      bits = bits << 16 | static_cast<std::uint64_t>(random.integer(0, 65535));
    const double value = std::bit_cast<double>(bits);
    if (!std::isfinite(value)) continue;
    std::string text;
    append_number(text, value);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(value_of(text)), bits) << text;
    char longer[64];
    std::snprintf(longer, sizeof longer, "%.25e", value);
    EXPECT_EQ(value_of(longer), std::strtod(longer, nullptr)) << longer;
  }
}

TEST(Number, IsTheSameInEveryLocale) {
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "C.UTF-8"}) {
    if (std::setlocale(LC_ALL, name) == nullptr) continue;
    EXPECT_EQ(value_of("1.5"), 1.5);
    std::string text;
    append_number(text, 1.5);
    EXPECT_EQ(text, "1.5");
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST(Number, CountsAreWholeAndNotNegative) {
  EXPECT_EQ(parse_count("0"), 0);
  EXPECT_EQ(parse_count("+403"), 403);
  for (const char* token : {"14.0", "14.", "+14.000", "1.4e1", "1.4E+01", "140e-1", "0.014d3"})
    EXPECT_EQ(parse_count(token), 14) << token;
  EXPECT_EQ(parse_count("0.0"), 0);
  EXPECT_EQ(parse_count("9007199254740992.0"), 9007199254740992);  // 2^53, the last that is exact
  EXPECT_EQ(parse_count("9007199254740994.0"), -1);
  for (const char* token : {"", "-1", "1.5", "8x", "99999999999999999999"})
    EXPECT_EQ(parse_count(token), -1) << token;
}

TEST(Number, QuotesForMessagesStayShortAndPrintable) {
  EXPECT_EQ(in_quotes("abc"), "\"abc\"");
  EXPECT_EQ(in_quotes("a\x01\xff"), "\"a??\"");
  EXPECT_EQ(in_quotes(std::string(1000, 'x')).size(), 45U);
}

}  // namespace
}  // namespace knotfit
