#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "base/parallel.h"
#include "knotfit/errors.h"
#include "knotfit/verify.h"
#include "verify/de_boor.h"
#include "verify/gap_places.h"
#include "verify/random.h"
#include "verify/reference_field.h"
namespace knotfit {
namespace {

using verify::Place;
using verify::ReferenceValue;

constexpr double kPromise = 0.5;  // error bars up to this share of the tolerance are promised

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
  const Watch watch(control, options.random_places + options.gap_places);
  if (watch.over()) return {};
  const verify::ReferenceField field(points, tolerance, options.metric_u, options.metric_v, options.seed);

  verify::Random random(options.seed, verify::Random::Stream::places);
  std::vector<Place> places(static_cast<std::size_t>(options.random_places));
  for (Place& p : places) p[0] = random(), p[1] = random();
  if (watch.over()) return {};
  for (const Place& p : verify::gap_places(field.neighbours(), options.gap_places, options.seed))
    places.push_back(p);
  const std::vector<ReferenceValue> reference = field.at(places, [&](Index done) {
    watch.report(done, tolerance);
    return !watch.over();
  });
  if (reference.size() != places.size()) return {};
  BetweenReport report = summarize(surface, places, reference, options.random_places, tolerance);
  report.noise = field.noise();
  watch.report(report.places, tolerance);
  return report;
}

}  // namespace knotfit
