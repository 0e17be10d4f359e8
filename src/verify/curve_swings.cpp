// Whether a curve keeps to its data between points: the measure of swings.cpp along one parameter.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "data/parameter_groups.h"
#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "knotfit/verify.h"
#include "verify/swing_limits.h"
namespace knotfit {
namespace {

using namespace verify;

constexpr Index kBox = 4;      // nearest points whose box the curve may not leave
constexpr Index kErrors = 2;   // of them, those whose errors it may make
constexpr Index kSpacing = 2;  // the neighbour whose distance is a point's spacing
constexpr double kSmall = 3;   // a gap between neighbours, over their spacing
constexpr Index kAbout = 4;    // points on each side of a gap that say how the data is about
constexpr double kRound =
    0.05;  // of the range about may any crest rise: a curve through a single peak goes on a little
constexpr double kCrest =
    0.5;  // of the range about may a crest rise that the neighbours' polynomials confirm
constexpr double kLongGap = 0.1;     // of the parameters: there the curve is free, and a note says so
constexpr double kClearSlope = 0.5;  // of the data at a gap: by 4 and by 8 points it may differ by this share
constexpr Index kPlaces = 40000;     // in all small gaps, about
constexpr std::array<double, 5> kInPiece = {0.1, 0.3, 0.5, 0.7, 0.9};

/// Distinct parameters in order, with the box of their values and their largest error; of a closed curve the
/// neighbouring periods too.
class Stations {
 public:
  Stations(const CurvePoints& points, const std::vector<double>& errors) : dimension_(points.dimension) {
    const ParameterGroups groups = group_by_parameter(points.t);
    low_.assign(groups.size() * dimension_, INFINITY), high_.assign(groups.size() * dimension_, -INFINITY);
    for (Index g = 0; g < groups.size(); ++g) {
      t_.push_back(points.t[groups.group(g).front()]);
      error_.push_back(0);
      for (const Index k : groups.group(g)) {
        error_.back() = std::max(error_.back(), errors[k]);
        for (int e = 0; e < dimension_; ++e) {
          low_[g * dimension_ + e] = std::min(low_[g * dimension_ + e], points.value(k)[e]);
          high_[g * dimension_ + e] = std::max(high_[g * dimension_ + e], points.value(k)[e]);
        }
      }
    }
    if (points.closed) repeat();
    const Index n = size();
    spacing_.resize(n, INFINITY);
    for (Index k = 0; k < n; ++k)
      for (Index left = std::max<Index>(0, k - kSpacing); left <= k && left + kSpacing < n; ++left)
        spacing_[k] = std::min(spacing_[k], std::max(t_[k] - t_[left], t_[left + kSpacing] - t_[k]));
  }

  Index size() const { return static_cast<Index>(t_.size()); }
  int dimension() const { return dimension_; }
  double t(Index k) const { return t_[k]; }
  double error(Index k) const { return error_[k]; }
  double low(Index k, int e) const { return low_[k * dimension_ + e]; }
  double high(Index k, int e) const { return high_[k * dimension_ + e]; }
  double middle(Index k, int e) const { return (low(k, e) + high(k, e)) / 2; }
  bool small_gap(Index k) const {
    return t_[k + 1] - t_[k] <= kSmall * std::min(spacing_[k], spacing_[k + 1]);
  }
  /// The last station at or before a place; -1: before the first.
  Index before(double at) const {
    return static_cast<Index>(std::upper_bound(t_.begin(), t_.end(), at) - t_.begin()) - 1;
  }
  /// The first of the `wanted` nearest, which are neighbours.
  Index nearest(double at, Index wanted) const {
    Index begin = std::clamp<Index>(before(at) + 1 - wanted, 0, size() - wanted);
    while (begin + wanted < size() && t_[begin + wanted] - at < at - t_[begin]) ++begin;
    return begin;
  }

 private:
  void repeat() {
    const Index n = size();
    auto thrice = [](std::vector<double>& x) {
      const std::vector<double> once = x;
      for (int turn = 0; turn < 2; ++turn) x.insert(x.end(), once.begin(), once.end());
    };
    for (auto* list : {&t_, &error_, &low_, &high_}) thrice(*list);
    for (Index k = 0; k < n; ++k) t_[k] -= 1, t_[2 * n + k] += 1;
  }
  int dimension_;
  std::vector<double> t_, error_, low_, high_, spacing_;
};

/// What the data about a place says of it.
class Site {
 public:
  Site(const Stations& stations, double at) : stations_(stations), at_(at) {
    const Index n = stations.size();
    left_ = stations.before(at);
    gap_ = left_ < 0 || left_ + 1 >= n || !stations.small_gap(left_);
    if (left_ >= 0 && stations.t(left_) == at) gap_ = false;  // on a point
    if (left_ >= 0 && left_ + 1 < n) width_ = stations.t(left_ + 1) - stations.t(left_);
    near_ = stations.nearest(at, std::min(kErrors, n));
    if (gap_) {
      begin_ = std::max<Index>(0, left_ + 1 - kAbout), end_ = std::min(n, left_ + 1 + kAbout);
      double nearest = INFINITY, reach = 0;
      for (Index k = begin_; k < end_; ++k) {
        nearest = std::min(nearest, std::abs(stations.t(k) - at));
        reach = std::max(reach, std::abs(stations.t(k) - at));
      }
      widening_ = kGapRange * std::max(1.0, reach > nearest ? 2 * nearest / (reach - nearest) : INFINITY);
    } else {
      const Index near = stations.nearest(at, std::min(kBox, n));
      begin_ = std::min(near, left_);
      end_ = std::max(near + std::min(kBox, n), std::min(n, left_ + 2));
    }
  }
  bool in_gap() const { return gap_; }

  /// \param x  the curve there \return its swing \param beyond  gets how far it leaves the box
  double swing(const double* x, double tolerance, double& beyond) const {
    const int d = stations_.dimension();
    for (Index k = near_; k < std::min(near_ + kErrors, stations_.size()); ++k)
      tolerance = std::max(tolerance, stations_.error(k));
    double most = 0;
    beyond = 0;
    for (int e = 0; e < d; ++e) {
      if (!std::isfinite(x[e])) return beyond = INFINITY;
      const auto [low, high] = range(e);
      const double excess = std::max(low - x[e], x[e] - high);
      const double unit =
          gap_ ? kGapRatio / kLargestSwing * (kCountedSwing * tolerance + widening_ * (high - low))
               : tolerance;
      if (excess > 0 && std::isfinite(unit))
        most = std::max(most, excess / unit), beyond = std::max(beyond, excess);
    }
    return most > kCountedSwing && !gap_ && is_crest(x, tolerance, most > kLargestSwing) ? 0 : most;
  }

  /// Whether the data about goes on beyond the box of all data, low to high, as the curve does, but for what is allowed.
  bool explains(const double* x, const std::vector<double>& low, const std::vector<double>& high,
                double allowed, double tolerance) const {
    if (!gap_) return is_crest(x, tolerance, true);
    for (int e = 0; e < stations_.dimension(); ++e) {
      const auto [a, b] = range(e);
      if (x[e] >= a && x[e] <= b) continue;
      const double excess = std::max(low[e] - x[e], x[e] - high[e]), free = widening_ * (b - a);
      if (!std::isfinite(x[e])) return false;
      if (excess > allowed && (width_ <= kLongGap || (std::isfinite(free) && excess - free > allowed)))
        return false;
    }
    return true;
  }

 private:
  std::pair<double, double> range(int e) const {
    double low = INFINITY, high = -INFINITY;
    for (Index k = begin_; k < end_; ++k)
      low = std::min(low, stations_.low(k, e)), high = std::max(high, stations_.high(k, e));
    if (gap_ && left_ >= 0 && left_ + 1 < stations_.size())
      if (const std::optional<double> across = bridge(e))
        low = std::min(low, *across), high = std::max(high, *across);
    return {low, high};
  }
  /// The line through `count` stations from k on, to the left or the right. \return its slope
  double slope(Index k, int step, Index count, int e) const {
    double t = 0, x = 0, tt = 0, tx = 0;
    for (Index i = 0; i < count; ++i) {
      const double dt = stations_.t(k + step * i) - stations_.t(k), dx = stations_.middle(k + step * i, e);
      t += dt, x += dx, tt += dt * dt, tx += dt * dx;
    }
    const auto n = static_cast<double>(count);
    return (n * tx - t * x) / (n * tt - t * t);
  }
  /// The cubic that goes on from both ends of a gap with the slopes of the data there; none where that has no clear slope.
  std::optional<double> bridge(int e) const {
    double slopes[2];
    for (int side = 0; side < 2; ++side) {
      const Index from = side == 0 ? left_ : left_ + 1;
      const int step = side == 0 ? -1 : 1;
      const Index there = side == 0 ? left_ + 1 : stations_.size() - left_ - 1;
      if (there < 2 * kAbout) return std::nullopt;
      const double near = slope(from, step, kAbout, e), far = slope(from, step, 2 * kAbout, e);
      if (!(std::abs(near - far) <= kClearSlope * std::max(std::abs(near), std::abs(far))))
        return std::nullopt;
      slopes[side] = near;
    }
    const double h = stations_.t(left_ + 1) - stations_.t(left_), x = (at_ - stations_.t(left_)) / h,
                 y = 1 - x;
    return y * y * (1 + 2 * x) * stations_.middle(left_, e) +
           x * x * (1 + 2 * y) * stations_.middle(left_ + 1, e) + h * x * y * (y * slopes[0] - x * slopes[1]);
  }
  /// The polynomial through so many stations on each side.
  double through(Index each, int e) const {
    const Index begin =
                    std::clamp<Index>(left_ + 1 - each, 0, std::max<Index>(0, stations_.size() - 2 * each)),
                end = std::min(stations_.size(), begin + 2 * each);
    double sum = 0;
    for (Index k = begin; k < end; ++k) {
      double product = stations_.middle(k, e);
      for (Index j = begin; j < end; ++j)
        if (j != k) product *= (at_ - stations_.t(j)) / (stations_.t(k) - stations_.t(j));
      sum += product;
    }
    return sum;
  }
  /// A crest between points leaves their box, and their polynomials say so: of degree 3, with what degree 5 differs.
  /// \param sure  only where both agree
  bool is_crest(const double* x, double tolerance, bool sure) const {
    for (int e = 0; e < stations_.dimension(); ++e) {
      const auto [low, high] = range(e);
      const double excess = std::max(low - x[e], x[e] - high);
      if (excess <= kRound * (high - low)) continue;
      if (excess > kCrest * (high - low)) return false;
      const double cubic = through(2, e);
      const double differ = std::abs(through(3, e) - cubic), free = kCountedSwing * tolerance;
      if (!(std::abs(x[e] - cubic) <= free + (sure ? 0 : differ)) || (sure && !(differ <= free)))
        return false;
    }
    return true;
  }

  const Stations& stations_;
  double at_, width_ = INFINITY, widening_ = 0;
  Index left_, near_, begin_, end_;
  bool gap_;
};

/// Places in small gaps, the same number in each; at most kPlaces gaps.
std::vector<double> places_between(const Stations& stations) {
  std::vector<Index> gaps;
  for (Index k = 0; k + 1 < stations.size(); ++k)
    if (stations.t(k) >= 0 && stations.t(k) < 1 && stations.small_gap(k)) gaps.push_back(k);
  const Index count = static_cast<Index>(gaps.size()), step = count / kPlaces + 1,
              each = std::clamp<Index>(kPlaces / std::max<Index>(1, count), 1, 20);
  std::vector<double> places;
  for (Index i = 0; i < count; i += step)
    for (Index p = 0; p < each; ++p) {
      const double a = stations.t(gaps[i]), b = stations.t(gaps[i] + 1);
      const double at = a + (static_cast<double>(p) + 0.5) / static_cast<double>(each) * (b - a);
      places.push_back(at > 1 ? at - 1 : at);
    }
  return places;
}

/// Places in every piece between knots and points: a narrow span next to a point hides a peak from any other places.
std::vector<double> places_in_pieces(const Curve& curve, const CurvePoints& points) {
  std::vector<double> ends = curve.knots().breaks();
  ends.insert(ends.end(), points.t.begin(), points.t.end());
  std::sort(ends.begin(), ends.end());
  ends.erase(std::unique(ends.begin(), ends.end()), ends.end());
  std::vector<double> places;
  for (std::size_t s = 0; s + 1 < ends.size(); ++s)
    for (double x : kInPiece) places.push_back(ends[s] + x * (ends[s + 1] - ends[s]));
  return places;
}

}  // namespace

SwingReport measure_swings(const Curve& curve, const CurvePoints& points, const std::vector<double>& errors,
                           double tolerance) {
  validate(points);
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    throw InvalidInput(fmt::format("a tolerance of {}: it must be positive and finite", tolerance));
  const int d = points.dimension;
  if (curve.control_points().empty() || curve.dimension() != d)
    throw InvalidInput("swings are measured of a curve of the dimension of its points");
  if (static_cast<Index>(errors.size()) != points.size())
    throw InvalidInput(fmt::format("{} errors of {} points", errors.size(), points.size()));
  const Stations stations(points, errors);
  SwingReport report;
  report.measured = true;
  auto ask = [&](const std::vector<double>& places, bool share) {
    const std::vector<double> at = evaluate(curve, places);
    for (std::size_t i = 0; i < places.size(); ++i) {
      const Site site(stations, places[i]);
      double beyond;
      const double swing = site.swing(at.data() + i * d, tolerance, beyond);
      if (share) ++report.places, report.above += swing > kCountedSwing ? 1 : 0;
      if (!(swing > report.largest)) continue;
      report.largest = swing, report.distance = beyond, report.in_gap = site.in_gap();
      report.worst_u = places[i];
    }
  };
  ask(places_between(stations), true);
  const std::vector<double> pieces = places_in_pieces(curve, points);
  ask(pieces, false);

  std::vector<double> low(d, INFINITY), high(d, -INFINITY);
  double diagonal = 0;
  for (int e = 0; e < d; ++e) {
    for (Index k = 0; k < points.size(); ++k)
      low[e] = std::min(low[e], points.value(k)[e]), high[e] = std::max(high[e], points.value(k)[e]);
    diagonal = std::hypot(diagonal, high[e] - low[e]);
  }
  const double allowed = std::max(kBoxShare * diagonal, kBoxTolerances * tolerance);
  bool beyond = false;
  const std::vector<double> at = evaluate(curve, pieces);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const double* x = at.data() + i * d;
    double most = 0;
    for (int e = 0; e < d; ++e)
      most = std::max(most, std::isfinite(x[e]) ? std::max(low[e] - x[e], x[e] - high[e]) : INFINITY);
    if (most > report.beyond_box) report.beyond_box = most, report.box_u = pieces[i];
    if (most > allowed && !Site(stations, pieces[i]).explains(x, low, high, allowed, tolerance))
      beyond = true;
  }
  report.swings = report.largest > kLargestSwing ||
                  static_cast<double>(report.above) > kSwingShare * static_cast<double>(report.places) ||
                  beyond;
  return report;
}

}  // namespace knotfit
