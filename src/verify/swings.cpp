#include "verify/swings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "verify/cell_places.h"
#include "verify/de_boor.h"
#include "verify/gap_places.h"
#include "verify/local_reference.h"
#include "verify/random.h"
#include "verify/swing_limits.h"
namespace knotfit::verify {
namespace {

constexpr Index kBox = 16;           // nearest points whose box the surface may not leave
constexpr Index kErrors = 8;         // of them, those whose errors it may make
constexpr Index kRing = 8;           // neighbours that make triangles with a point
constexpr double kSmall = 3;         // longest edge of a triangle, over the distance to the fourth neighbour
constexpr Index kMostExcused = 500;  // places
constexpr Index kMostStrays = 5000;  // beyond the box: more is no matter of single places
// The points about a gap: as many as it takes to see two in each quarter, at most so many times as far as the nearest.
constexpr double kAbout = 8;
constexpr Index kMostAbout = 2000, kASide = 2;
constexpr Index kGapPlaces = 500, kCellPlaces = 500;

double squared(double x) {
  return x * x;
}

}  // namespace

struct SwingSites::Sites {
  std::vector<double> uv;
  std::vector<double> low, high;    ///< sites x dimension, of the 16 nearest
  std::vector<std::uint32_t> near;  ///< sites x kErrors, distinct points
  std::vector<double> widening;     ///< 0 inside a triangle; else the share of the range that is free
  Index near_count = 0;             ///< entries of `near` a site
  Index size() const { return static_cast<Index>(widening.size()); }
  /// The larger of the tolerance and the largest error of the 8 nearest points.
  double local(Index i, const std::vector<double>& errors, double tolerance) const {
    for (Index q = 0; q < near_count; ++q) tolerance = std::max(tolerance, errors[near[i * near_count + q]]);
    return tolerance;
  }
};

SwingSites::SwingSites(const ParameterizedPoints& points, Index most_places,
                       std::shared_ptr<const IndexedPoints> indexed, unsigned long long seed)
    : points_(points),
      indexed_(indexed_or(std::move(indexed), points)),
      distinct_(indexed_->distinct),
      neighbours_(indexed_->neighbours),
      low_(points.dimension, INFINITY),
      high_(points.dimension, -INFINITY) {
  for (Index k = 0; k < points.size(); ++k)
    for (int e = 0; e < points.dimension; ++e) {
      low_[e] = std::min(low_[e], points.value(k)[e]);
      high_[e] = std::max(high_[e], points.value(k)[e]);
    }
  for (int e = 0; e < points.dimension; ++e) diagonal_ += squared(high_[e] - low_[e]);
  diagonal_ = std::sqrt(diagonal_);

  Random random(seed, Random::Stream::places);
  const Index n = distinct_.size(), triangles = 6 * n;
  const Index step = std::max<Index>(1, triangles / std::max<Index>(1, most_places));
  const Index each = std::clamp<Index>(most_places / std::max<Index>(1, triangles), 1, 4);
  std::vector<Place> places;
  for (Index k = 0; k < n; k += step) {
    const std::vector<Index> corners = ring(k);
    const double u = distinct_.u[k], v = distinct_.v[k];
    for (std::size_t i = 0; i + 1 < corners.size(); i += 2)
      for (Index t = 0; t < each; ++t) {
        double x = random(), y = random();
        if (x + y > 1) x = 1 - x, y = 1 - y;
        const Index a = corners[i], b = corners[i + 1];
        places.push_back({u + x * (distinct_.u[a] - u) + y * (distinct_.u[b] - u),
                          v + x * (distinct_.v[a] - v) + y * (distinct_.v[b] - v),
                          {k, a, b}});
      }
  }
  for (const auto& [u, v] : gap_places(neighbours_, kGapPlaces, seed))
    if (points.map.covers(u, v)) places.push_back(located(u, v));
  fixed_ = std::make_shared<const Sites>(sites(places));
}

std::vector<Index> SwingSites::ring(Index k) const {
  std::array<std::uint32_t, kRing + 1> index;
  std::array<double, kRing + 1> square;
  const double u = distinct_.u[k], v = distinct_.v[k];
  const Index found = neighbours_.nearest(u, v, index, square);
  if (found < 4) return {};
  const double most = squared(kSmall) * square[std::min<Index>(found - 1, 4)];
  std::vector<std::pair<double, Index>> around;
  for (Index i = 1; i < found; ++i)
    if (square[i] <= most)
      around.push_back({std::atan2(distinct_.v[index[i]] - v, distinct_.u[index[i]] - u), index[i]});
  std::sort(around.begin(), around.end());
  std::vector<Index> pairs;
  for (std::size_t i = 0; i < around.size() && around.size() > 1; ++i) {
    const auto& [angle, a] = around[i];
    const auto& [next_angle, b] = around[(i + 1) % around.size()];
    const double turn = next_angle - angle + (next_angle < angle ? 2 * std::numbers::pi : 0);
    if (turn >= std::numbers::pi) continue;  // the border runs here
    if (squared(distinct_.u[a] - distinct_.u[b]) + squared(distinct_.v[a] - distinct_.v[b]) > most) continue;
    pairs.insert(pairs.end(), {a, b});
  }
  return pairs;
}

SwingSites::Place SwingSites::located(double u, double v) const {
  std::array<std::uint32_t, 3> index;
  std::array<double, 3> square;
  const Index found = neighbours_.nearest(u, v, index, square);
  for (Index i = 0; i < found; ++i) {
    const double x = distinct_.u[index[i]], y = distinct_.v[index[i]];
    const std::vector<Index> corners = ring(index[i]);
    for (std::size_t c = 0; c + 1 < corners.size(); c += 2) {
      const double ax = distinct_.u[corners[c]] - x, ay = distinct_.v[corners[c]] - y,
                   bx = distinct_.u[corners[c + 1]] - x, by = distinct_.v[corners[c + 1]] - y,
                   det = ax * by - ay * bx;
      const double a = (u - x) * by - (v - y) * bx, b = ax * (v - y) - ay * (u - x);
      if (det > 0 && a >= 0 && b >= 0 && a + b <= det) return {u, v, {index[i], corners[c], corners[c + 1]}};
    }
  }
  return {u, v};
}

bool SwingSites::on_every_side(double u, double v, const std::vector<std::uint32_t>& index) const {
  std::array<Index, 4> count{};
  for (const Index k : index) ++count[(distinct_.u[k] > u ? 2 : 0) + (distinct_.v[k] > v ? 1 : 0)];
  return *std::min_element(count.begin(), count.end()) >= kASide;
}

SwingSites::Sites SwingSites::sites(const std::vector<Place>& places) const {
  const Index n = static_cast<Index>(places.size()), k = std::min(kBox, distinct_.size());
  const int d = distinct_.dimension;
  Sites s;
  s.near_count = std::min(kErrors, k);
  s.uv.resize(2 * n);
  s.low.assign(n * d, INFINITY), s.high.assign(n * d, -INFINITY);
  s.near.resize(n * s.near_count);
  s.widening.assign(n, 0.0);
  parallel_chunks(
      n,
      [&](Index, Index begin, Index end) {
        std::vector<std::uint32_t> index;
        std::vector<double> square;
        for (Index i = begin; i < end; ++i) {
          const Place& place = places[i];
          s.uv[2 * i] = place.u, s.uv[2 * i + 1] = place.v;
          // In a gap as many as it takes to see its other sides.
          for (Index wanted = k;; wanted = std::min(4 * wanted, distinct_.size())) {
            index.resize(wanted), square.resize(wanted);
            neighbours_.nearest(place.u, place.v, index, square);
            if (!place.in_gap() || wanted == distinct_.size() || wanted >= kMostAbout ||
                square.back() >= squared(kAbout) * square.front() || on_every_side(place.u, place.v, index))
              break;
          }
          auto take = [&](Index point) {
            for (int e = 0; e < d; ++e) {
              const double x = distinct_.value(point)[e];
              s.low[i * d + e] = std::min(s.low[i * d + e], x);
              s.high[i * d + e] = std::max(s.high[i * d + e], x);
            }
          };
          for (Index q : index) take(q);
          std::copy_n(index.begin(), s.near_count, s.near.begin() + i * s.near_count);
          if (!place.in_gap()) {
            for (Index corner : place.corners)
              take(corner);  // at the border of dense data they may be farther
            continue;
          }
          const double gap = std::sqrt(square.front()), reach = std::sqrt(square.back());
          s.widening[i] = kGapRange * std::max(1.0, reach > gap ? 2 * gap / (reach - gap) : INFINITY);
        }
      },
      256);
  return s;
}

void SwingSites::excuse(const Sites& sites, const std::vector<double>& at, const std::vector<double>& errors,
                        double tolerance, std::vector<double>& ratio) const {
  std::vector<Index> far;
  for (Index i = 0; i < sites.size(); ++i)
    if (ratio[i] > kCountedSwing && std::isfinite(ratio[i])) far.push_back(i);
  if (static_cast<Index>(far.size()) > kMostExcused)
    return;  // a wave that is right is not far off at so many places
  const int d = distinct_.dimension;
  parallel_chunks(
      static_cast<Index>(far.size()),
      [&](Index, Index begin, Index end) {
        StencilGatherer gatherer(distinct_, neighbours_, kPlainShape);
        for (Index k = begin; k < end; ++k) {
          const Index i = far[k];
          const ReferenceValue reference = reference_value(gatherer, sites.uv[2 * i], sites.uv[2 * i + 1], 0);
          const double local = sites.local(i, errors, tolerance);
          if (!(reference.error_bar <= kCountedSwing * local)) continue;  // at a cliff it overshoots, too
          if (distance({at.data() + i * d, static_cast<std::size_t>(d)}, reference.value) <=
              kCountedSwing * local)
            ratio[i] = 0;
        }
      },
      8);
}

void SwingSites::count(SwingReport& report, const Sites& sites, const Surface& surface,
                       const std::vector<double>& errors, double tolerance, Strays* strays) const {
  const int d = distinct_.dimension;
  const std::vector<double> at = evaluate(surface, sites.uv);
  std::vector<double> ratio(sites.size()), beyond(sites.size());
  parallel_chunks(sites.size(), [&](Index, Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      const double local = sites.local(i, errors, tolerance);
      const bool gap = sites.widening[i] > 0;
      for (int e = 0; e < d; ++e) {
        const double low = sites.low[i * d + e], high = sites.high[i * d + e], x = at[i * d + e];
        const double excess = std::max(low - x, x - high);
        // In a gap counted so that the ratio allowed there is the ratio allowed between near points.
        const double unit =
            gap ? kGapRatio / kLargestSwing * (kCountedSwing * local + sites.widening[i] * (high - low))
                : local;
        const double r = !std::isfinite(x)     ? INFINITY
                         : !(excess > 0)       ? 0
                         : std::isfinite(unit) ? excess / unit
                                               : 0;
        if (r > ratio[i]) ratio[i] = r, beyond[i] = excess;
      }
    }
  });
  excuse(sites, at, errors, tolerance, ratio);
  for (Index i = 0; i < sites.size(); ++i) {
    const bool gap = sites.widening[i] > 0;
    if (!gap) ++report.places;
    if (!gap && ratio[i] > kCountedSwing) ++report.above;
    if (strays && ratio[i] > (gap ? kLargestSwing / 2 : kCountedSwing)) {
      strays->uv.insert(strays->uv.end(), {sites.uv[2 * i], sites.uv[2 * i + 1]});
      for (int e = 0; e < d; ++e)
        strays->values.push_back(std::clamp(at[i * d + e], sites.low[i * d + e], sites.high[i * d + e]));
    }
    if (!(ratio[i] > report.largest)) continue;
    report.largest = ratio[i], report.distance = beyond[i], report.in_gap = gap;
    report.worst_u = sites.uv[2 * i], report.worst_v = sites.uv[2 * i + 1];
  }
}

bool SwingSites::measure_box(SwingReport& report, const Surface& surface, double allowed,
                             Strays* strays) const {
  auto places = [](const KnotVector& knots) {
    const std::vector<double> breaks = knots.breaks();
    std::vector<double> x;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
      for (double t : {0.0, 0.2, 0.5, 0.8}) x.push_back(breaks[i] + t * (breaks[i + 1] - breaks[i]));
    x.push_back(breaks.back());
    return x;
  };
  const std::vector<double> u = places(surface.knots_u()), v = places(surface.knots_v());
  const std::vector<double> at = evaluate_grid(surface, u, v);
  const int d = surface.dimension();
  std::vector<Place> beyond;
  for (std::size_t i = 0; i < u.size(); ++i)
    for (std::size_t j = 0; j < v.size(); ++j) {
      double most = 0;
      for (int e = 0; e < d; ++e) {
        const double x = at[(i * v.size() + j) * d + e];
        const double excess = std::isfinite(x) ? std::max(low_[e] - x, x - high_[e]) : INFINITY;
        most = std::max(most, excess);
      }
      if (!(most > std::min(report.beyond_box, allowed / 2)) || !points_.map.covers(u[i], v[j])) continue;
      if (most > allowed / 2) beyond.push_back({u[i], v[j]});
      if (most > report.beyond_box) report.beyond_box = most, report.box_u = u[i], report.box_v = v[j];
    }
  if (beyond.empty()) return false;
  if (const std::size_t step = beyond.size() / kMostStrays + 1; step > 1) {
    for (std::size_t i = 0; i * step < beyond.size(); ++i) beyond[i] = beyond[i * step];
    beyond.resize(beyond.size() / step);
  }
  // Beyond the outermost points a surface goes on as the data about does.
  const Sites about = sites(beyond);
  const std::vector<double> there = evaluate(surface, about.uv);
  bool swings = false;
  for (Index i = 0; i < about.size(); ++i) {
    double most = 0;
    for (int e = 0; e < d; ++e) {
      const double x = there[i * d + e], low = about.low[i * d + e], high = about.high[i * d + e],
                   free = std::min(about.widening[i] * (high - low), kMostOnward * diagonal_);
      const double excess = std::max(low_[e] - x, x - high_[e]);
      if (!std::isfinite(x) || (std::isfinite(free) && excess > free))
        most = std::max(most, std::isfinite(x) ? excess - free : INFINITY);
    }
    swings = swings || most > allowed;
    if (strays == nullptr || !(most > allowed / 2)) continue;
    strays->uv.insert(strays->uv.end(), {about.uv[2 * i], about.uv[2 * i + 1]});
    for (int e = 0; e < d; ++e) {
      const double x = there[i * d + e];
      strays->values.push_back(std::isfinite(x) ? std::clamp(x, about.low[i * d + e], about.high[i * d + e])
                                                : about.low[i * d + e]);
    }
  }
  return swings;
}

SwingReport SwingSites::measure(const Surface& surface, const std::vector<double>& errors, double tolerance,
                                Strays* strays) const {
  std::vector<double> of_distinct(distinct_.size(), 0.0);
  for (Index k = 0; k < static_cast<Index>(errors.size()); ++k)
    of_distinct[distinct_.of[k]] = std::max(of_distinct[distinct_.of[k]], errors[k]);
  SwingReport report;
  report.measured = true;
  count(report, *fixed_, surface, of_distinct, tolerance, strays);
  // Narrow knot cells, which no fixed place may have met.
  std::vector<Place> cells;
  for (const auto& [u, v] : cell_places(surface, points_, kCellPlaces))
    if (points_.map.covers(u, v)) cells.push_back(located(u, v));
  const Index places = report.places, above = report.above;
  count(report, sites(cells), surface, of_distinct, tolerance, strays);
  report.places = places, report.above = above;  // the share is one of places that no knots chose
  const double allowed = std::max(kBoxShare * diagonal_, kBoxTolerances * tolerance);
  const bool beyond = measure_box(report, surface, allowed, strays);
  report.swings = report.largest > kLargestSwing ||
                  static_cast<double>(report.above) > kSwingShare * static_cast<double>(report.places) ||
                  beyond;
  return report;
}

}  // namespace knotfit::verify

namespace knotfit {

SwingReport measure_swings(const Surface& surface, const ParameterizedPoints& points,
                           const std::vector<double>& errors, double tolerance) {
  validate(points);
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    throw InvalidInput(fmt::format("a tolerance of {}: it must be positive and finite", tolerance));
  if (surface.empty() || surface.dimension() != points.dimension)
    throw InvalidInput("swings are measured of a surface of the dimension of its points");
  if (static_cast<Index>(errors.size()) != points.size())
    throw InvalidInput(fmt::format("{} errors of {} points", errors.size(), points.size()));
  constexpr Index kPlaces = 40000;
  return verify::SwingSites(points, kPlaces).measure(surface, errors, tolerance);
}

}  // namespace knotfit
