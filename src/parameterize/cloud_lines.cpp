#include "parameterize/cloud_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "parameterize/cloud_neighbours.h"
namespace knotfit::cloud {
namespace {

// Of the distance along: neighbours are off the line by less, at the median. Those spread over a sheet have 0.5.
constexpr double kLineLike = 0.2;
constexpr std::size_t kFew = 6;  // nearest: on one line even where the next line is only 4 points away
constexpr double kOffLine = 4;   // of the medians: points farther off are of another line
constexpr double kPool = 1.5;  // of the neighbours, times the ratio: so many nearest hold those of the metric
constexpr std::size_t kMostPool = 1024;

double median_of(std::vector<double> x) {
  const auto half = x.begin() + static_cast<std::ptrdiff_t>(x.size() / 2);
  std::nth_element(x.begin(), half, x.end());
  return *half;
}

/// The line that the nearest neighbours of a point lie on, if they do.
class LineAround {
 public:
  LineAround(std::span<const double> points, Index k, std::span<const std::uint32_t> near)
      : points_(points), centre_(static_cast<std::size_t>(k)) {
    lay_along(near.first(std::min(kFew, near.size())));
    if (!find_middle(near)) return;
    const std::vector<std::uint32_t> on = on_line(near);
    lay_along(on);
    if (!find_middle(near)) return;
    double low = 0, high = 0;
    for (const std::uint32_t j : on) low = std::min(low, place(j)[0]), high = std::max(high, place(j)[0]);
    step_ = on.empty() ? 0 : (high - low) / static_cast<double>(on.size());
  }
  bool is_line() const { return step_ > 0; }
  /// How many times as far the next line is as the next point on this one; 0 where none of these points is off it.
  double ratio(std::span<const std::uint32_t> points) const {
    double least = INFINITY;
    for (const std::uint32_t j : points)
      if (const auto [t, d] = place(j); d > std::max(off_, std::abs(t))) least = std::min(least, d);
    return std::isfinite(least) ? least / step_ : 0;
  }
  /// Squared distance where lines are as close as the points on them.
  double squared(std::uint32_t j, double ratio) const {
    const auto [t, d] = place(j);
    return t * t + d * d / (ratio * ratio);
  }

 private:
  void lay_along(std::span<const std::uint32_t> some) {
    std::vector<std::uint32_t> all(some.begin(), some.end());
    all.push_back(static_cast<std::uint32_t>(centre_));
    direction_ = principal_axes(points_, all).axis[2];
  }
  /// Along the line, signed, and off it.
  std::array<double, 2> place(std::uint32_t j) const {
    Vector d{};
    for (std::size_t c = 0; c < 3; ++c) d[c] = points_[3 * std::size_t{j} + c] - points_[3 * centre_ + c];
    const double t = dot(d, direction_);
    return {t, std::sqrt(std::max(0.0, dot(d, d) - t * t))};
  }
  /// How far most are off the line. \return whether that is little
  bool find_middle(std::span<const std::uint32_t> near) {
    std::vector<double> along, off;
    for (const std::uint32_t j : near) {
      const auto [t, d] = place(j);
      along.push_back(std::abs(t)), off.push_back(d);
    }
    const double middle = median_of(off);
    off_ = kOffLine * middle;
    return middle < kLineLike * median_of(along);
  }
  std::vector<std::uint32_t> on_line(std::span<const std::uint32_t> near) const {
    std::vector<std::uint32_t> on;
    for (const std::uint32_t j : near)
      if (const auto [t, d] = place(j); d <= std::max(off_, kLineLike * std::abs(t))) on.push_back(j);
    return on;
  }
  std::span<const double> points_;
  std::size_t centre_;
  Vector direction_{};
  double off_ = 0, step_ = 0;
};

}  // namespace

void reach_across(std::span<const double> points, Index k, Nearest& nearest, const FindNearest& find) {
  const LineAround line(points, k, nearest.index);
  if (!line.is_line()) return;
  const std::size_t count = nearest.index.size(), most = std::min(kMostPool, points.size() / 3 - 1);
  Nearest pool;
  for (std::size_t wanted = std::min(4 * count, most);; wanted = std::min(2 * wanted, most)) {
    find(wanted, pool);
    const double ratio = line.ratio(pool.index);
    const bool enough =
        ratio > 0 && static_cast<double>(wanted) >= kPool * ratio * static_cast<double>(count);
    if (!enough && wanted < most) continue;
    if (!(ratio > 1)) return;  // a line alone, or the next one is as near as its points
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < pool.index.size(); ++i)
      order.emplace_back(line.squared(pool.index[i], ratio), i);
    const auto end = order.begin() + static_cast<std::ptrdiff_t>(count);
    std::partial_sort(order.begin(), end, order.end());
    std::sort(order.begin(), end, [](const auto& a, const auto& b) { return a.second < b.second; });
    for (std::size_t i = 0; i < count; ++i) {
      nearest.index[i] = pool.index[order[i].second];
      nearest.squared[i] = pool.squared[order[i].second];
    }
    return;
  }
}

}  // namespace knotfit::cloud
