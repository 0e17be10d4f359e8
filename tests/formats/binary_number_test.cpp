#include "formats/binary_number.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

namespace knotfit {
namespace {

template <class T>
void expect_loaded(char kind, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  const bool big = std::endian::native == std::endian::big;
  EXPECT_EQ(number_loader({kind, sizeof(T)}, big)(bytes), static_cast<double>(value));
  std::reverse(bytes, bytes + sizeof(T));
  EXPECT_EQ(number_loader({kind, sizeof(T)}, !big)(bytes), static_cast<double>(value));
}

TEST(BinaryNumber, IsItsValueInEitherOrder) {
  expect_loaded<std::int8_t>('i', -100);
  expect_loaded<std::int16_t>('i', -12345);
  expect_loaded<std::int32_t>('i', -123456789);
  expect_loaded<std::int64_t>('i', -(std::int64_t{1} << 52));
  expect_loaded<std::uint8_t>('u', 200);
  expect_loaded<std::uint16_t>('u', 54321);
  expect_loaded<std::uint32_t>('u', 4000000000U);
  expect_loaded<std::uint64_t>('u', std::uint64_t{1} << 53);
  expect_loaded<float>('f', -1.25e-30F);
  expect_loaded<double>('f', 4.6e6 + 0.001);
}

double half(unsigned bits) {
  const char bytes[] = {static_cast<char>(bits >> 8), static_cast<char>(bits & 255)};
  return number_loader({'f', 2}, true)(bytes);
}

TEST(BinaryNumber, HalfPrecisionIsThatOfIeee) {
  EXPECT_EQ(half(0x3C00), 1);
  EXPECT_EQ(half(0xC000), -2);
  EXPECT_EQ(half(0x7BFF), 65504) << "the largest";
  EXPECT_EQ(half(0x0001), std::ldexp(1, -24)) << "the smallest";
  EXPECT_EQ(half(0x03FF), std::ldexp(1023, -24)) << "subnormal";
  EXPECT_EQ(half(0x3555), 1365 / 4096.0) << "nearest to 1/3";
  EXPECT_EQ(half(0x7C00), INFINITY);
  EXPECT_EQ(half(0xFC00), -INFINITY);
  EXPECT_TRUE(std::isnan(half(0x7E00)));
}

}  // namespace
}  // namespace knotfit
