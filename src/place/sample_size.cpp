#include "place/sample_size.h"

#include <algorithm>
namespace knotfit {
namespace {

constexpr double kLeast = 20000;
constexpr double kPerControlPoint = 25;
constexpr double kWorth = 2.5;  // so many times the sample, or fitting all points is not much dearer

}  // namespace

double points_needed(double control_points) {
  return std::max(kLeast, kPerControlPoint * control_points);
}

Index sample_size(Index points, double control_points, Engine engine) {
  const double size = points_needed(control_points);
  const double all = static_cast<double>(points);
  if (engine == Engine::points || size >= all) return 0;
  if (engine == Engine::automatic && all < kWorth * size) return 0;
  return static_cast<Index>(size);
}

}  // namespace knotfit
