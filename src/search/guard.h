// The search kept honest between the data: fill points held to a local reference, and a finer reserve
// that a surface is checked against once it holds [METHOD 4.4].
#pragma once
#include <array>
#include <functional>
#include <vector>

#include "knotfit/interior_knots.h"
#include "search/joined_points.h"
#include "verify/reference_field.h"
namespace knotfit {

/// References are expensive, so a place gets its own only where a net could go astray there: where the gap in
/// the data is wide for the cell, or the cell holds few points. (Of all that a full cover found astray on
/// the synthetic sets, none had a gap below 0.44 of the cell or more than 26 points in it.)
class Guard {
 public:
  /// \param joined  the data alone so far; outlives the guard, which lets places join it
  /// \param metric  knots of the error model's fine stage
  /// \param stop    asked between batches; may be empty
  /// \param loose  places join where the surface is beyond this many slack tolerances: 1 for a maximum
  Guard(JoinedPoints& joined, double tolerance, double loose, const InteriorKnots& metric,
        std::function<bool()> stop);

  const JoinedPoints& joined() const { return joined_; }
  Index fill_count() const { return fill_count_; }  ///< places that joined
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
  JoinedPoints& joined_;
  std::vector<Site> sites_;
  Index fill_count_ = 0;
};

}  // namespace knotfit
