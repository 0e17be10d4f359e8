// Random knot vectors, curves and surfaces. The seed is printed where a test fails;
// KNOTFIT_TEST_SEED=n runs with another one. KNOTFIT_TEST_EXPORT=dir keeps surfaces to look at.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <random>
#include <string>
#include <vector>

#include "knotfit/curve.h"
#include "knotfit/surface.h"
namespace knotfit::test {

inline constexpr double kEps = 0x1p-52;

/// The seed of this run, printed once a program.
inline std::uint64_t seed() {
  static const std::uint64_t value = [] {
    const char* given = std::getenv("KNOTFIT_TEST_SEED");
    const std::uint64_t chosen = given ? std::strtoull(given, nullptr, 10) : 20250611;
    std::cout << "seed " << chosen << " (KNOTFIT_TEST_SEED)\n";
    return chosen;
  }();
  return value;
}

/// Uniform numbers, the same on every standard library (its distributions are not).
class Random {
 public:
  explicit Random(std::uint64_t start = seed()) : generator_(start) {}
  double unit() { return static_cast<double>(generator_() >> 11) * 0x1p-53; }  ///< [0,1)
  double uniform(double a, double b) { return a + unit() * (b - a); }
  double log_uniform(double a, double b) { return std::exp(uniform(std::log(a), std::log(b))); }
  int integer(int a, int b) {  ///< a..b, both included
    return a + static_cast<int>(generator_() % static_cast<std::uint64_t>(b - a + 1));
  }

 private:
  std::mt19937_64 generator_;
};

enum class Ends { clamped, any };

/// Up to `max_breaks` distinct interior knots, gaps over three decades, multiplicities up to
/// `max_multiplicity` (degree + 1 where 0). Ends::any: clamped or not, half and half.
inline KnotVector random_knots(Random& random, int degree, Ends ends = Ends::any, int max_breaks = 8,
                               int max_multiplicity = 0) {
  const bool clamped = ends == Ends::clamped || random.integer(0, 1) == 0;
  const int most = max_multiplicity > 0 ? std::min(max_multiplicity, degree + 1) : degree + 1;
  const auto multiplicity = [&] { return random.integer(0, 2) > 0 ? 1 : random.integer(1, most); };
  std::vector<double> knots;
  double at = random.integer(0, 1) == 0 ? 0 : random.uniform(-10, 10);
  const auto add = [&](int copies) { knots.insert(knots.end(), static_cast<std::size_t>(copies), at); };
  const auto step = [&] { at += random.log_uniform(1e-3, 1); };
  const auto ending = [&](bool first) {
    if (clamped) return add(degree + 1);
    for (int left = degree + 1; left > 0;) {
      const int copies = std::min(left, multiplicity());
      add(copies);
      left -= copies;
      if (left > 0 || first) step();
    }
  };
  ending(true);
  if (clamped) step();
  for (int breaks = random.integer(0, max_breaks); breaks > 0; --breaks) {
    add(multiplicity());
    step();
  }
  ending(false);
  return KnotVector(degree, knots);
}

inline std::vector<double> random_numbers(Random& random, Index count, double scale = 1) {
  std::vector<double> numbers(static_cast<std::size_t>(count));
  for (double& x : numbers) x = random.uniform(-scale, scale);
  return numbers;
}

inline Curve random_curve(Random& random, int dimension, Ends ends = Ends::any) {
  KnotVector knots = random_knots(random, random.integer(1, kMaxDegree), ends);
  std::vector<double> points =
      random_numbers(random, knots.size() * dimension, random.log_uniform(1e-6, 1e6));
  return Curve(std::move(knots), dimension, std::move(points));
}

/// Degrees 1 to 9, apart in u and v, multiple knots, clamped or not, scales over twelve decades.
inline Surface random_surface(Random& random, int dimension, Ends ends = Ends::any, int max_breaks = 8) {
  KnotVector u = random_knots(random, random.integer(1, kMaxDegree), ends, max_breaks);
  KnotVector v = random_knots(random, random.integer(1, kMaxDegree), ends, max_breaks);
  std::vector<double> net =
      random_numbers(random, u.size() * v.size() * dimension, random.log_uniform(1e-6, 1e6));
  return Surface(std::move(u), std::move(v), dimension, std::move(net));
}

inline std::vector<Surface> random_surfaces(std::uint64_t start, int count, Ends ends = Ends::any) {
  Random random(start);
  std::vector<Surface> surfaces;
  for (int k = 0; k < count; ++k) surfaces.push_back(random_surface(random, random.integer(1, 4), ends));
  return surfaces;
}

inline double random_parameter(Random& random, const KnotVector& knots) {
  return random.uniform(knots.first(), knots.last());
}

/// Writes the surface as dir/name.json where KNOTFIT_TEST_EXPORT=dir is set.
inline void export_surface(const std::string& name, const Surface& s) {
  const char* folder = std::getenv("KNOTFIT_TEST_EXPORT");
  if (!folder) return;
  std::ofstream out(std::string(folder) + "/" + name + ".json");
  out << std::setprecision(17);
  const auto list = [&](const auto& numbers) {
    out << "[";
    for (std::size_t i = 0; i < numbers.size(); ++i) out << (i > 0 ? "," : "") << numbers[i];
    out << "]";
  };
  out << "{\"degree\":[" << s.degree_u() << "," << s.degree_v() << "],\"knots_u\":";
  list(s.knots_u().knots());
  out << ",\"knots_v\":";
  list(s.knots_v().knots());
  out << ",\"control_points\":[";
  for (Index i = 0; i < s.size_u(); ++i) {
    out << (i > 0 ? ",[" : "[");
    for (Index j = 0; j < s.size_v(); ++j) {
      if (j > 0) out << ",";
      list(s.control_point(i, j));
    }
    out << "]";
  }
  out << "]}\n";
}

}  // namespace knotfit::test
