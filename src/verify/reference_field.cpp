#include "verify/reference_field.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
namespace knotfit::verify {
namespace {

constexpr double kDoubt = 0.25;    // error bars above this share of the tolerance ask the mapped metric
constexpr double kNoise = 0.02;    // noise below this share is none
constexpr Index kBatch = 512;      // places between two looks at the clock
constexpr Index kChunkPlaces = 8;  // places a task

// Calls body(gatherer, i) for i = 0..n-1 in batches. False where go_on cut it short.
template <class Body>
bool for_places(Index n, const DistinctPoints& points, const Neighbours& neighbours, StencilShape shape,
                const std::function<bool(Index)>& go_on, const Body& body) {
  for (Index begin = 0; begin < n; begin += kBatch) {
    if (go_on && !go_on(begin)) return false;
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

}  // namespace

ReferenceField::ReferenceField(const ParameterizedPoints& points, double tolerance,
                               std::span<const double> metric_u, std::span<const double> metric_v,
                               unsigned long long seed, std::shared_ptr<const IndexedPoints> indexed)
    : tolerance_(tolerance),
      indexed_(indexed_or(std::move(indexed), points)),
      points_(indexed_->distinct),
      plain_(indexed_->neighbours),
      xi_(metric_u, net_scale(std::max(metric_u.size(), metric_v.size()))),
      eta_(metric_v, net_scale(std::max(metric_u.size(), metric_v.size()))),
      two_metrics_(!metric_u.empty() || !metric_v.empty()) {
  const double found = find_noise(*indexed_, seed);
  if (found > kNoise * tolerance) noise_ = found;
}

const Neighbours& ReferenceField::mapped() const {
  std::call_once(mapped_once_, [&] {
    // The coordinates grow with u and v, so the strips stay.
    std::vector<double> x(points_.u.size()), y(points_.v.size());
    parallel_chunks(points_.size(), [&](Index, Index begin, Index end) {
      for (Index k = begin; k < end; ++k) x[k] = xi_(points_.u[k]), y[k] = eta_(points_.v[k]);
    });
    mapped_ = std::make_unique<Neighbours>(std::move(x), std::move(y), points_.strip_start);
  });
  return *mapped_;
}

std::vector<ReferenceValue> ReferenceField::at(std::span<const Place> places,
                                               const std::function<bool(Index)>& go_on) const {
  const Index n = static_cast<Index>(places.size());
  std::vector<ReferenceValue> reference(places.size());
  if (!for_places(n, points_, plain_, kPlainShape, go_on, [&](StencilGatherer& gatherer, Index i) {
        reference[i] = reference_value(gatherer, places[i][0], places[i][1], noise_);
      }))
    return {};
  if (!two_metrics_) return reference;
  std::vector<Index> doubtful;
  for (Index i = 0; i < n; ++i)
    if (std::isfinite(reference[i].error_bar) && reference[i].error_bar > kDoubt * tolerance_)
      doubtful.push_back(i);
  if (doubtful.empty()) return reference;
  const auto second_go_on = [&](Index) { return !go_on || go_on(n); };
  if (!for_places(static_cast<Index>(doubtful.size()), points_, mapped(), kMappedShape, second_go_on,
                  [&](StencilGatherer& gatherer, Index j) {
                    const Place& p = places[doubtful[j]];
                    ReferenceValue& r = reference[doubtful[j]];
                    r = combine(std::move(r), reference_value(gatherer, xi_(p[0]), eta_(p[1]), noise_));
                  }))
    return {};
  return reference;
}

}  // namespace knotfit::verify
