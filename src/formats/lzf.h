// LZF, the compression of PCD files [liblzf].
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
namespace knotfit {

/// The most bytes that `size` compressed ones can stand for: a reference of 3 stands for 264.
constexpr std::size_t most_lzf_bytes(std::size_t size) {
  return 88 * size;
}

/// \return exactly `size` bytes; nothing where the input is damaged or stands for another number
std::optional<std::string> decompress_lzf(std::string_view input, std::size_t size);

}  // namespace knotfit
