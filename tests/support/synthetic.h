// The synthetic five: surfaces whose truth is known, and points on them.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "knotfit/exceptions.h"
#include "knotfit/points.h"
namespace knotfit::test {

/// Uniform doubles in [0,1), the same on every machine.
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  /// Standard normal [Box-Muller].
  double normal() {
    const double a = std::max((*this)(), 1e-300), b = (*this)();
    return std::sqrt(-2 * std::log(a)) * std::cos(2 * std::numbers::pi * b);
  }

 private:
  std::mt19937_64 engine_;
};

inline double square(double x) {
  return x * x;
}

inline double franke(double u, double v) {
  return 0.75 * std::exp(-(square(9 * u - 2) + square(9 * v - 2)) / 4) +
         0.75 * std::exp(-square(9 * u + 1) / 49 - (9 * v + 1) / 10) +
         0.5 * std::exp(-(square(9 * u - 7) + square(9 * v - 3)) / 4) -
         0.2 * std::exp(-square(9 * u - 4) - square(9 * v - 7));
}

inline double peaks(double u, double v) {
  const double x = 6 * u - 3, y = 6 * v - 3;
  return 3 * square(1 - x) * std::exp(-x * x - square(y + 1)) -
         10 * (x / 5 - x * x * x - y * y * y * y * y) * std::exp(-x * x - y * y) -
         std::exp(-square(x + 1) - y * y) / 3;
}

inline double step(double u, double v) {
  return 0.3 * std::sin(3 * u + v) + std::tanh(60 * (u - 0.3)) + std::tanh(80 * (v - 0.7));
}

inline double ridge(double u, double v) {
  return peaks(u, v) / 8 + 0.5 * std::tanh(40 * (u + 0.2 * v - 0.6));
}

inline std::array<double, 3> torus_patch(double u, double v) {
  const double a = 1.5 * std::numbers::pi * u, b = 1.5 * std::numbers::pi * v;
  const double r =
      1 + 0.15 * std::exp(-200 * (square(u - 0.4) + square(v - 0.5))) + 0.05 * std::tanh(30 * (v - 0.3));
  return {(3 + r * std::cos(b)) * std::cos(a), (3 + r * std::cos(b)) * std::sin(a), r * std::sin(b)};
}

inline const std::vector<std::string>& synthetic_names() {
  static const std::vector<std::string> names = {"franke", "peaks", "step", "ridge", "torus"};
  return names;
}

inline int synthetic_dimension(const std::string& name) {
  return name == "torus" ? 3 : 1;
}

/// The true surface: one value, or three on the torus.
inline std::vector<double> synthetic_value(const std::string& name, double u, double v) {
  if (name == "franke") return {franke(u, v)};
  if (name == "peaks") return {peaks(u, v)};
  if (name == "step") return {step(u, v)};
  if (name == "ridge") return {ridge(u, v)};
  if (name == "torus") {
    const auto p = torus_patch(u, v);
    return {p[0], p[1], p[2]};
  }
  throw InvalidInput("no synthetic surface is called " + name);
}

/// n uniform random points on the surface, u then v of each.
inline ParameterizedPoints synthetic_points(const std::string& name, Index n = 10000,
                                            std::uint64_t seed = 1) {
  ParameterizedPoints points;
  points.dimension = synthetic_dimension(name);
  points.height_field = points.dimension == 1;
  Uniform random(seed);
  for (Index k = 0; k < n; ++k) {
    const double u = random(), v = random();
    points.uv.insert(points.uv.end(), {u, v});
    for (double x : synthetic_value(name, u, v)) points.values.push_back(x);
  }
  return points;
}

/// Points on the ridge, denser towards u = 0.
inline ParameterizedPoints uneven_points(Index n, unsigned seed) {
  ParameterizedPoints points = synthetic_points("ridge", n, seed);
  for (std::size_t i = 0; i < points.uv.size(); i += 2) points.uv[i] = points.uv[i] * points.uv[i];
  return points;
}

/// Diagonal of the box of (u, v, z), or of (x, y, z): the unit of the tables' errors and tolerances.
inline double synthetic_diagonal(const ParameterizedPoints& points) {
  double sum = 0;
  auto add = [&](const std::vector<double>& data, int columns) {
    for (int c = 0; c < columns; ++c) {
      double low = INFINITY, high = -INFINITY;
      for (Index k = 0; k < points.size(); ++k) {
        low = std::min(low, data[k * columns + c]);
        high = std::max(high, data[k * columns + c]);
      }
      sum += square(high - low);
    }
  };
  if (points.dimension == 1) add(points.uv, 2);
  add(points.values, points.dimension);
  return std::sqrt(sum);
}

}  // namespace knotfit::test
