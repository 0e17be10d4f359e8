// The search kept honest between the data: fill points held to a local reference, and a finer reserve
// that a surface is checked against once it holds [METHOD 4.4].
#pragma once
#include <array>
#include <functional>
#include <vector>

#include "knotfit/interior_knots.h"
#include "knotfit/points.h"
#include "search/minimax.h"
#include "verify/reference_field.h"
namespace knotfit {

/// References are expensive, so a place gets its own only where a net could go astray there: where the gap in
/// the data is wide for the cell, or the cell holds few points. (Of all that a full cover found astray on
/// the synthetic sets, none had a gap below 0.44 of the cell or more than 26 points in it.)
class Guard {
 public:
  /// \param metric  knots of the error model's fine stage
  /// \param stop    asked between batches; may be empty
  /// \param loose  places join where the surface is beyond this many slack tolerances: 1 for a maximum
  Guard(const ParameterizedPoints& points, double tolerance, double loose, const InteriorKnots& metric,
        std::function<bool()> stop);

  /// The data, then the points that joined it. Only the first data_count() are data.
  const ParameterizedPoints& points() const { return points_; }
  Index data_count() const { return data_count_; }
  Index fill_count() const { return points_.size() - data_count_; }

  /// Shares of the points in the problem's stored order.
  PointShares shares(MovingFit& problem) const;
  /// Adds the fill points that matter to the problem's present knots, for good. The problem has to take them in.
  /// \return their number
  Index fill(MovingFit& problem);
  /// Adds the places of fill, reserve and the middles of empty cells where the problem's surface is off by more than 1.02
  /// slack tolerances. \return their number
  Index exchange(MovingFit& problem);

 private:
  struct Site {
    std::array<double, 2> place;
    double gap;  ///< distance to the nearest point
    bool fill;
    enum { open, known, joined } state = open;
    verify::ReferenceValue reference;  ///< where known
  };
  void watch(const std::array<double, 2>& place, bool fill);
  /// Makes the middles of empty cells sites of the reserve: the cover misses cells that are narrower than its steps.
  void watch_empty_cells(MovingFit& problem);
  /// Computes the references of the sites that matter to the knots and have not joined. \return those that have one
  std::vector<Index> sites_that_matter(MovingFit& problem, bool fill_only);
  double slack(const Site& site) const;  ///< infinity: not held to the maximum
  void join(Site& site);

  double tolerance_, loose_;
  std::function<bool()> stop_;
  verify::ReferenceField field_;
  ParameterizedPoints points_;
  Index data_count_;
  double mean_weight_ = 1;
  std::vector<Site> sites_;
  std::vector<double> base_, inverse_slack_;  ///< of points_
};

}  // namespace knotfit
