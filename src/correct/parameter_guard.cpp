#include "correct/parameter_guard.h"

#include <algorithm>
namespace knotfit::correction {
namespace {

constexpr unsigned char kHalfWays = 6;

}  // namespace

ParameterGuard::ParameterGuard(Faces faces, Index vertices)
    : faces_(faces),
      star_start_(static_cast<std::size_t>(vertices) + 1, 0),
      back_(static_cast<std::size_t>(vertices), 0) {
  for (const auto& t : faces)
    for (const std::int32_t k : t) ++star_start_[k + 1];
  for (std::size_t k = 1; k < star_start_.size(); ++k) star_start_[k] += star_start_[k - 1];
  star_.resize(3 * faces.size());
  std::vector<std::int32_t> next(star_start_.begin(), star_start_.end() - 1);
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (const std::int32_t k : faces[f]) star_[next[k]++] = static_cast<std::int32_t>(f);
}

double ParameterGuard::area(std::span<const double> uv, std::int32_t face) const {
  const auto& t = faces_[face];
  const double *a = &uv[2 * t[0]], *b = &uv[2 * t[1]], *c = &uv[2 * t[2]];
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

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
      if (area(to, f) >= keep * area(from, f)) continue;
      for (const std::int32_t k : t)
        if (!hit[k] && back_[k] <= kHalfWays) {
          hit[k] = 1;
          moved.push_back(k);
        }
    }
    for (const std::int32_t k : moved) {
      held += back_[k] == 0;
      const bool half = ++back_[k] <= kHalfWays;
      for (Index c = 2 * k; c < 2 * k + 2; ++c) to[c] = half ? (from[c] + to[c]) / 2 : from[c];
      hit[k] = 0;
    }
    look.clear();
    for (const std::int32_t k : moved)
      for (std::int32_t i = star_start_[k]; i < star_start_[k + 1]; ++i)
        if (!queued[star_[i]]) {
          queued[star_[i]] = 1;
          look.push_back(star_[i]);
        }
    for (const std::int32_t f : look) queued[f] = 0;
  }
  return held;
}

void ParameterGuard::relax(std::span<double> to, std::span<const Slide> slide, int passes) const {
  for (int pass = 0; pass < passes; ++pass)
    for (std::size_t k = 0; k < back_.size(); ++k) {
      if (!back_[k] || slide[k] != Slide::free || star_start_[k] == star_start_[k + 1]) continue;
      double middle[2] = {0, 0};
      const double count = 2.0 * (star_start_[k + 1] - star_start_[k]);
      const auto least = [&] {
        double a = area(to, star_[star_start_[k]]);
        for (std::int32_t i = star_start_[k] + 1; i < star_start_[k + 1]; ++i)
          a = std::min(a, area(to, star_[i]));
        return a;
      };
      for (std::int32_t i = star_start_[k]; i < star_start_[k + 1]; ++i)
        for (const std::int32_t j : faces_[star_[i]])
          if (j != static_cast<std::int32_t>(k))
            for (int c = 0; c < 2; ++c) middle[c] += to[2 * j + c] / count;
      const double before = least(), old[2] = {to[2 * k], to[2 * k + 1]};
      for (int c = 0; c < 2; ++c) to[2 * k + c] = (old[c] + middle[c]) / 2;
      if (least() > std::min(before, 1e-12)) continue;
      for (int c = 0; c < 2; ++c) to[2 * k + c] = old[c];
    }
}

}  // namespace knotfit::correction
