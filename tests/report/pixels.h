// Pictures as pixels, for the tests that look at them.
#pragma once
#include <cstdint>
#include <string>
#include <vector>
namespace knotfit {

struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint32_t> rgb;
  std::uint32_t at(double x, double y) const {
    return rgb[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

/// Of a PNG file's bytes.
Pixels decode(const std::string& png);

}  // namespace knotfit
