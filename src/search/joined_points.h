// What a search fits: its data, and the points that joined it on the way.
#pragma once
#include <vector>

#include "fit/moving_fit.h"
#include "search/minimax.h"
namespace knotfit {

class JoinedPoints {
 public:
  explicit JoinedPoints(ParameterizedPoints data);

  /// The data, then the points that joined it. Only the first data_count() are data.
  const ParameterizedPoints& points() const { return points_; }
  Index data_count() const { return data_count_; }

  /// Takes a point in, for good. The problem has to take it in then (MovingFit::take_new_points).
  /// \param value   d
  /// \param weight  in the least squares, times the mean weight of the data
  /// \param slack   the maximum counts its error by this; infinity: not at all
  void join(double u, double v, const double* value, double weight, double slack);

  /// Shares of the points in the problem's stored order.
  PointShares shares(const MovingFit& problem) const;

 private:
  ParameterizedPoints points_;
  Index data_count_;
  double mean_weight_ = 1;
  std::vector<double> base_, inverse_slack_;  ///< of points_
};

}  // namespace knotfit
