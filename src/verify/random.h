// Uniform doubles in [0,1), the same on every machine.
#pragma once
#include <cstdint>
#include <random>
namespace knotfit::verify {

/// Streams of one seed differ from each other, and from a plain mt19937_64 of that seed: data made by one must
/// not meet places drawn by the same.
class Random {
 public:
  enum class Stream : std::uint64_t { places = 1, gaps, noise };
  Random(std::uint64_t seed, Stream stream)
      : engine_((seed ^ 0xd1b54a32d192ed03) * 0x9e3779b97f4a7c15 + static_cast<std::uint64_t>(stream)) {}
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace knotfit::verify
