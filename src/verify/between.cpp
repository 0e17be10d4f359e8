#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/parallel.h"
#include "knotfit/errors.h"
#include "knotfit/verify.h"
#include "verify/de_boor.h"
#include "verify/gap_places.h"
#include "verify/local_reference.h"
#include "verify/net_coordinates.h"
#include "verify/random.h"
namespace knotfit {
namespace {

using verify::DistinctPoints;
using verify::Neighbours;
using verify::NetCoordinate;
using verify::ReferenceValue;
using verify::StencilGatherer;
using Place = std::array<double, 2>;

constexpr double kDoubt = 0.25;    // error bars above this share of the tolerance ask the mapped metric
constexpr double kPromise = 0.5;   // error bars up to this share are promised
constexpr double kNoise = 0.02;    // noise below this share is none
constexpr Index kBatch = 512;      // places between two looks at the clock
constexpr Index kChunkPlaces = 8;  // places a task

// Stops where the caller does, or the time is over.
class Watch {
 public:
  Watch(const Control& control, Index places) : control_(control), places_(places) {}
  bool over() const {
    if (control_.stop.stop_requested()) return true;
    return control_.time_limit > 0 &&
           std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count() >
               control_.time_limit;
  }
  void report(Index done, double tolerance) const {
    if (!control_.progress) return;
    Progress progress;
    progress.stage = "between";
    progress.fraction = static_cast<double>(done) / static_cast<double>(std::max<Index>(1, places_));
    progress.tolerance = tolerance;
    control_.progress(progress);
  }

 private:
  const Control& control_;
  Index places_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void check(const Surface& surface, const ParameterizedPoints& points, double tolerance,
           const BetweenOptions& options) {
  if (!(tolerance > 0) || !std::isfinite(tolerance))
    throw InvalidInput(fmt::format("a tolerance of {}: it must be positive and finite", tolerance));
  if (options.random_places < 0 || options.gap_places < 0)
    throw InvalidInput(fmt::format("{} random and {} gap places: neither may be negative",
                                   options.random_places, options.gap_places));
  validate(points);
  if (surface.empty())
    throw InvalidInput("no surface to measure between the points: its control net is empty");
  if (surface.dimension() != points.dimension)
    throw InvalidInput(
        fmt::format("a surface of dimension {} cannot be measured against points of dimension {}",
                    surface.dimension(), points.dimension));
}

// Calls body(gatherer, i) for i = 0..n-1 in batches. False where the watch cut it short.
template <class Body>
bool for_places(Index n, const DistinctPoints& points, const Neighbours& neighbours,
                verify::StencilShape shape, const Watch& watch, double tolerance, const Body& body) {
  for (Index begin = 0; begin < n; begin += kBatch) {
    if (watch.over()) return false;
    watch.report(begin, tolerance);
    parallel_chunks(
        std::min(kBatch, n - begin),
        [&](Index, Index from, Index to) {
          StencilGatherer gatherer(points, neighbours, shape);
          for (Index i = begin + from; i < begin + to; ++i) body(gatherer, i);
        },
        kChunkPlaces);
  }
  return true;
}

// The same points in the coordinates of the error-model net. They grow with u and v, so the strips stay.
Neighbours mapped_neighbours(const DistinctPoints& points, const NetCoordinate& xi,
                             const NetCoordinate& eta) {
  std::vector<double> x(points.u.size()), y(points.v.size());
  parallel_chunks(points.size(), [&](Index, Index begin, Index end) {
    for (Index k = begin; k < end; ++k) x[k] = xi(points.u[k]), y[k] = eta(points.v[k]);
  });
  return {std::move(x), std::move(y), points.strip_start};
}

BetweenReport summarize(const Surface& surface, const std::vector<Place>& places,
                        const std::vector<ReferenceValue>& reference, Index random_places, double tolerance) {
  BetweenReport report;
  report.measured = true;
  report.places = static_cast<Index>(places.size());
  std::vector<double> error(places.size(), 0);
  parallel_chunks(report.places, [&](Index, Index begin, Index end) {
    std::vector<double> at(static_cast<std::size_t>(surface.dimension()));
    for (Index i = begin; i < end; ++i) {
      verify::de_boor(surface, places[i][0], places[i][1], at);
      error[i] = verify::distance(at, reference[i].value);
    }
  });
  Index thin = 0;
  for (Index i = 0; i < report.places; ++i) {
    const ReferenceValue& r = reference[i];
    if (!(r.error_bar <= kPromise * tolerance && r.gap <= verify::kHole)) {
      thin += i < random_places;
      report.thin_places.push_back({places[i][0], places[i][1], r.error_bar, r.gap});
      continue;
    }
    const double e = std::isnan(error[i]) ? INFINITY : error[i];
    report.bound = std::max(report.bound, e + 2 * r.error_bar);
    if (report.promised++ == 0 || e > report.between)
      report.between = e, report.worst_u = places[i][0], report.worst_v = places[i][1];
  }
  if (random_places > 0) report.thin = static_cast<double>(thin) / static_cast<double>(random_places);
  return report;
}

}  // namespace

BetweenReport measure_between(const Surface& surface, const ParameterizedPoints& points, double tolerance,
                              const BetweenOptions& options, const Control& control) {
  check(surface, points, tolerance, options);
  const double scale = verify::net_scale(std::max(options.metric_u.size(), options.metric_v.size()));
  const NetCoordinate xi(options.metric_u, scale), eta(options.metric_v, scale);
  const bool mapped = !options.metric_u.empty() || !options.metric_v.empty();
  const Watch watch(control, options.random_places + options.gap_places);
  if (watch.over()) return {};

  const DistinctPoints distinct = verify::distinct_points(points);
  const Neighbours plain = verify::plain_neighbours(distinct);
  if (watch.over()) return {};
  const double found = verify::find_noise(distinct, plain, options.seed);
  const double noise = found > kNoise * tolerance ? found : 0;

  verify::Random random(options.seed, verify::Random::Stream::places);
  std::vector<Place> places(static_cast<std::size_t>(options.random_places));
  for (Place& p : places) p[0] = random(), p[1] = random();
  if (watch.over()) return {};
  for (const Place& p : verify::gap_places(plain, options.gap_places, options.seed)) places.push_back(p);

  const Index n = static_cast<Index>(places.size());
  std::vector<ReferenceValue> reference(places.size());
  const bool done = for_places(
      n, distinct, plain, verify::kPlainShape, watch, tolerance, [&](StencilGatherer& gatherer, Index i) {
        reference[i] = verify::reference_value(gatherer, places[i][0], places[i][1], noise);
      });
  if (!done) return {};

  std::vector<Index> doubtful;
  for (Index i = 0; i < n && mapped; ++i)
    if (std::isfinite(reference[i].error_bar) && reference[i].error_bar > kDoubt * tolerance)
      doubtful.push_back(i);
  if (!doubtful.empty()) {
    const Neighbours second = mapped_neighbours(distinct, xi, eta);
    if (!for_places(static_cast<Index>(doubtful.size()), distinct, second, verify::kMappedShape, watch,
                    tolerance, [&](StencilGatherer& gatherer, Index j) {
                      const Place& p = places[doubtful[j]];
                      ReferenceValue& r = reference[doubtful[j]];
                      r = verify::combine(std::move(r),
                                          verify::reference_value(gatherer, xi(p[0]), eta(p[1]), noise));
                    }))
      return {};
  }
  BetweenReport report = summarize(surface, places, reference, options.random_places, tolerance);
  report.noise = noise;
  watch.report(report.places, tolerance);
  return report;
}

}  // namespace knotfit
