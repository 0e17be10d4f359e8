#include "formats/lzf.h"

#include <algorithm>
namespace knotfit {

std::optional<std::string> decompress_lzf(std::string_view input, std::size_t size) {
  if (size > most_lzf_bytes(input.size())) return std::nullopt;
  std::string out;
  out.reserve(std::min(size, 4 * input.size()));  // no more is believed before it is there
  const auto byte = [&](std::size_t at) {
    return static_cast<std::size_t>(static_cast<unsigned char>(input[at]));
  };
  for (std::size_t at = 0; at < input.size();) {
    const std::size_t control = byte(at++);
    if (control < 32) {  // so many bytes, and one, as they are
      const std::size_t run = control + 1;
      if (run > input.size() - at || run > size - out.size()) return std::nullopt;
      out.append(input.substr(at, run));
      at += run;
      continue;
    }
    // A copy of what stands some bytes back; it may reach into itself.
    std::size_t run = control >> 5;
    if (run == 7) {
      if (at == input.size()) return std::nullopt;
      run += byte(at++);
    }
    run += 2;
    if (at == input.size()) return std::nullopt;
    const std::size_t back = ((control & 31) << 8 | byte(at++)) + 1;
    if (back > out.size() || run > size - out.size()) return std::nullopt;
    for (std::size_t k = 0; k < run; ++k) out += out[out.size() - back];
  }
  if (out.size() != size) return std::nullopt;
  return out;
}

}  // namespace knotfit
