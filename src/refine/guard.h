// The search kept honest between the data: fill points held to a local reference, and a finer reserve
// that a surface is checked against once it holds [METHOD 4, "Between the points"].
#pragma once
#include <array>
#include <functional>
#include <vector>

#include "knotfit/interior_knots.h"
#include "knotfit/points.h"
#include "refine/minimax.h"
#include "verify/local_reference.h"
namespace knotfit {

class Guard {
 public:
  /// \param metric  knots of the error model's fine stage
  /// \param stop    asked between batches; may be empty
  Guard(const ParameterizedPoints& points, double tolerance, const InteriorKnots& metric,
        const std::function<bool()>& stop);

  /// The data, then the fill points, then the reserve. Only the first data_count() are data.
  const ParameterizedPoints& points() const { return points_; }
  Index data_count() const { return data_count_; }
  Index fill_count() const { return fill_count_; }  ///< in force, reserve points that joined included

  /// Shares of the points in the problem's stored order; the reserve that has not joined has weight 0.
  PointShares shares(FitProblem& problem) const;
  /// Reserve points where the problem's present surface is above 1.02 slack tolerance join the fill for
  /// good. \return their number
  Index exchange(FitProblem& problem);

 private:
  void add(const std::vector<std::array<double, 2>>& places,
           const std::vector<verify::ReferenceValue>& references, bool joined);
  double tolerance_;
  ParameterizedPoints points_;
  Index data_count_, fill_count_ = 0;
  std::vector<double> base_, inverse_slack_;  ///< a point, input order
  std::vector<char> joined_;
};

}  // namespace knotfit
