#include "search/joined_points.h"

#include <numeric>
#include <utility>
namespace knotfit {

JoinedPoints::JoinedPoints(ParameterizedPoints data)
    : points_(std::move(data)),
      data_count_(points_.size()),
      base_(points_.weights.empty() ? std::vector<double>(points_.size(), 1.0) : points_.weights),
      inverse_slack_(points_.size(), 1.0) {
  points_.source.clear();
  mean_weight_ = std::accumulate(base_.begin(), base_.end(), 0.0) / static_cast<double>(data_count_);
}

void JoinedPoints::join(double u, double v, const double* value, double weight, double slack) {
  points_.uv.insert(points_.uv.end(), {u, v});
  points_.values.insert(points_.values.end(), value, value + points_.dimension);
  base_.push_back(mean_weight_ * weight);
  inverse_slack_.push_back(1 / slack);
  if (!points_.weights.empty()) points_.weights.push_back(base_.back());
}

PointShares JoinedPoints::shares(const MovingFit& problem) const {
  const CellOrder& order = problem.order();
  PointShares shares{std::vector<double>(order.size()), std::vector<double>(order.size())};
  for (Index i = 0; i < order.size(); ++i) {
    shares.base[i] = base_[order.input(i)];
    shares.inverse_slack[i] = inverse_slack_[order.input(i)];
  }
  return shares;
}

}  // namespace knotfit
