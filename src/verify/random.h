// Uniform doubles in [0,1), the same on every machine.
#pragma once
#include <cstdint>
#include <random>
namespace knotfit::verify {

class Random {
 public:
  explicit Random(unsigned long long seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

}  // namespace knotfit::verify
