#include "refine/guard.h"

#include <cmath>
#include <numeric>

#include "fit/scattered.h"
#include "refine/cover.h"
#include "verify/reference_field.h"
namespace knotfit {
namespace {

// Measured constants of METHOD 4.
constexpr double kRadius = 1, kBorder = 0.5;  // of the fill
constexpr double kReserveRadius = 0.7, kReserveBorder = 0.4;
constexpr double kWeight = 0.3, kSlack = 1.25, kJoin = 1.02, kDrop = 3;

}  // namespace

Guard::Guard(const ParameterizedPoints& points, double tolerance, const InteriorKnots& metric,
             const std::function<bool()>& stop)
    : tolerance_(tolerance), points_(points), data_count_(points.size()) {
  points_.source.clear();
  base_ = points.weights.empty() ? std::vector<double>(points.size(), 1.0) : points.weights;
  inverse_slack_.assign(points.size(), 1.0);
  joined_.assign(points.size(), 1);
  const verify::ReferenceField field(points, tolerance, metric.u, metric.v, 1);
  const auto go_on = [&](Index) { return !stop || !stop(); };
  for (bool fill : {true, false}) {
    const auto places = fill ? cover_gaps(field.neighbours(), kRadius, kBorder)
                             : cover_gaps(field.neighbours(), kReserveRadius, kReserveBorder);
    const std::vector<verify::ReferenceValue> references = field.at(places, go_on);
    if (references.size() == places.size()) add(places, references, fill);  // else it was stopped
  }
  if (!points_.weights.empty()) points_.weights.resize(points_.size(), 1.0);
}

void Guard::add(const std::vector<std::array<double, 2>>& places,
                const std::vector<verify::ReferenceValue>& references, bool joined) {
  const double mean_weight =
      std::accumulate(base_.begin(), base_.begin() + data_count_, 0.0) / static_cast<double>(data_count_);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const verify::ReferenceValue& r = references[i];
    const double e = r.error_bar / tolerance_;
    if (!(e <= kDrop)) continue;  // nothing to hold to
    points_.uv.insert(points_.uv.end(), places[i].begin(), places[i].end());
    points_.values.insert(points_.values.end(), r.value.begin(), r.value.end());
    base_.push_back(mean_weight * kWeight / (1 + 4 * e * e));
    inverse_slack_.push_back(e > 1 || r.gap > verify::kHole ? 0 : 1 / (kSlack + e));
    joined_.push_back(joined);
    fill_count_ += joined;
  }
}

PointShares Guard::shares(FitProblem& problem) const {
  const CellOrder& order = problem.scattered().points();
  PointShares shares{std::vector<double>(order.size()), std::vector<double>(order.size())};
  for (Index i = 0; i < order.size(); ++i) {
    const Index k = order.input(i);
    shares.base[i] = joined_[k] ? base_[k] : 0;
    shares.inverse_slack[i] = joined_[k] ? inverse_slack_[k] : 0;
  }
  return shares;
}

Index Guard::exchange(FitProblem& problem) {
  const CellOrder& order = problem.scattered().points();
  const std::vector<double>& residual = problem.scattered().residual();
  const int d = points_.dimension;
  Index count = 0;
  for (Index i = 0; i < order.size(); ++i) {
    const Index k = order.input(i);
    if (joined_[k]) continue;
    double square = 0;
    for (int e = 0; e < d; ++e) square += residual[i * d + e] * residual[i * d + e];
    if (std::sqrt(square) * inverse_slack_[k] <= kJoin * tolerance_) continue;
    joined_[k] = 1;
    ++count;
  }
  fill_count_ += count;
  return count;
}

}  // namespace knotfit
