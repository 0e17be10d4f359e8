#include "correct/parameter_guard.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "data/orientation.h"
namespace knotfit::correction {
namespace {

constexpr unsigned char kHalfWays = 6;

}  // namespace

ParameterGuard::ParameterGuard(Faces faces, Index vertices)
    : faces_(faces), stars_(faces, vertices), back_(static_cast<std::size_t>(vertices), 0) {}

Index ParameterGuard::hold(std::span<const double> from, std::span<double> to, double keep) {
  std::fill(back_.begin(), back_.end(), 0);
  std::vector<char> hit(back_.size(), 0), queued(faces_.size(), 0);
  std::vector<std::int32_t> look(faces_.size()), moved;
  for (std::size_t f = 0; f < faces_.size(); ++f) look[f] = static_cast<std::int32_t>(f);
  Index held = 0;
  while (!look.empty()) {
    moved.clear();
    for (const std::int32_t f : look) {
      const auto& t = faces_[f];
      if (back_[t[0]] > kHalfWays && back_[t[1]] > kHalfWays && back_[t[2]] > kHalfWays) continue;
      if (twice_area(to, t) >= keep * twice_area(from, t)) continue;
      for (const std::int32_t k : t)
        if (back_[k] <= kHalfWays && !std::exchange(hit[k], 1)) moved.push_back(k);
    }
    for (const std::int32_t k : moved) {
      held += back_[k] == 0;
      const bool half = ++back_[k] <= kHalfWays;
      for (Index c = 2 * k; c < 2 * k + 2; ++c) to[c] = half ? (from[c] + to[c]) / 2 : from[c];
      hit[k] = 0;
    }
    look.clear();
    for (const std::int32_t k : moved)
      for (const std::int32_t f : stars_.of(k))
        if (!std::exchange(queued[f], 1)) look.push_back(f);
    for (const std::int32_t f : look) queued[f] = 0;
  }
  return held;
}

void ParameterGuard::relax(std::span<double> to, std::span<const Slide> slide, int passes) const {
  for (int pass = 0; pass < passes; ++pass)
    for (std::size_t k = 0; k < back_.size(); ++k) {
      const auto star = stars_.of(static_cast<Index>(k));
      if (!back_[k] || slide[k] != Slide::free || star.empty()) continue;
      const auto least = [&] {
        double area = INFINITY;
        for (const std::int32_t f : star) area = std::min(area, twice_area(to, faces_[f]));
        return area;
      };
      double middle[2] = {0, 0};
      for (const std::int32_t f : star)
        for (const std::int32_t j : faces_[f])
          if (j != static_cast<std::int32_t>(k))
            for (int c = 0; c < 2; ++c) middle[c] += to[2 * j + c] / (2.0 * static_cast<double>(star.size()));
      const double before = least(), old[2] = {to[2 * k], to[2 * k + 1]};
      for (int c = 0; c < 2; ++c) to[2 * k + c] = (old[c] + middle[c]) / 2;
      if (least() > std::min(before, 1e-12)) continue;
      for (int c = 0; c < 2; ++c) to[2 * k + c] = old[c];
    }
}

}  // namespace knotfit::correction
