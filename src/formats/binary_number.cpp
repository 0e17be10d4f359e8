#include "formats/binary_number.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
namespace knotfit {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

template <class Bits, bool kSwap>
Bits load_bits(const char* p) {
  unsigned char bytes[sizeof(Bits)];
  std::memcpy(bytes, p, sizeof bytes);
  if constexpr (kSwap) std::reverse(bytes, bytes + sizeof bytes);
  return std::bit_cast<Bits>(bytes);
}

template <class T, class Bits, bool kSwap>
double load(const char* p) {
  return static_cast<double>(std::bit_cast<T>(load_bits<Bits, kSwap>(p)));
}

/// IEEE 754 binary16.
template <bool kSwap>
double load_half(const char* p) {
  const auto bits = load_bits<std::uint16_t, kSwap>(p);
  const int exponent = (bits >> 10) & 31, fraction = bits & 1023;
  double value = 0;
  if (exponent == 31)
    value = fraction == 0 ? std::numeric_limits<double>::infinity() : kNan;
  else
    value = exponent == 0 ? std::ldexp(fraction, -24) : std::ldexp(1024 + fraction, exponent - 25);
  return (bits & 0x8000) != 0 ? -value : value;
}

template <bool kSwap>
LoadNumber choose_load(char kind, int size) {
  if (kind == 'f') {
    if (size == 2) return load_half<kSwap>;
    return size == 4 ? load<float, std::uint32_t, kSwap> : load<double, std::uint64_t, kSwap>;
  }
  if (kind == 'i') {
    if (size == 1) return load<std::int8_t, std::uint8_t, kSwap>;
    if (size == 2) return load<std::int16_t, std::uint16_t, kSwap>;
    return size == 4 ? load<std::int32_t, std::uint32_t, kSwap> : load<std::int64_t, std::uint64_t, kSwap>;
  }
  if (size == 1) return load<std::uint8_t, std::uint8_t, kSwap>;
  if (size == 2) return load<std::uint16_t, std::uint16_t, kSwap>;
  return size == 4 ? load<std::uint32_t, std::uint32_t, kSwap> : load<std::uint64_t, std::uint64_t, kSwap>;
}

}  // namespace

LoadNumber number_loader(NumberType type, bool big_endian) {
  const bool swap = big_endian != (std::endian::native == std::endian::big);
  return swap ? choose_load<true>(type.kind, type.size) : choose_load<false>(type.kind, type.size);
}

}  // namespace knotfit
