// Sizes whose knots minimise the error: Levenberg-Marquardt, relocation, joint minimax [METHOD 4.2].
#pragma once
#include <map>
#include <optional>
#include <vector>

#include "place/context.h"
#include "place/relocate.h"
#include "search/attempts.h"
#include "search/guard.h"
#include "search/size_solver.h"
#include "search/whole_data.h"
namespace knotfit {

class OptimizedSizes final : public SizeSolver {
 public:
  /// \param problem  scattered, over what a guard or the whole data let join, else over the data
  /// \param context  of that problem, with the fine model set
  /// \param joined   null without a guard and a sample
  /// \param guard    may be null
  /// \param whole    where the problem is over a sample; else null
  OptimizedSizes(MovingFit& problem, PlacementContext& context, JoinedPoints* joined, Guard* guard,
                 WholeData* whole, Attempts& attempts, const RefineOptions& options);

  /// Knots to start from at their own size. \return that size
  Spans seed(InteriorKnots knots);
  const SizeOutcome& solve(const Spans& spans, const Spans* from) override;

 private:
  struct Entry {
    SizeOutcome& outcome;
    InteriorKnots knots, minimax;  ///< the least-squares optimum, and the knots of the least maximum
  };
  struct Start {
    InteriorKnots knots;
    double phi = 0, error = 0;
  };

  std::vector<InteriorKnots> starts(const Spans& spans, const Entry* from, bool strong, const Entry& entry);
  /// For nets that are too large to optimise: least squares on the knots of the error model.
  const SizeOutcome& place_only(const Spans& spans, Entry& entry);
  /// From a least-squares optimum: lowers the maximum by minimax, adds places where the surface is off between the data, and
  /// offers what it finds.
  void finish(Entry& entry, Start& start);
  /// Adds the fill points that matter to these knots, and optimises the knots again.
  void fill(Start& start);
  void take_new_points();
  /// Lets places between the data and points of the whole data join where the problem's surface is off.
  /// \return whether any did
  bool exchange();
  double measured() const;
  void use_base_weights();

  MovingFit& problem_;
  PlacementContext& context_;
  JoinedPoints* joined_;
  Guard* guard_;
  WholeData* whole_;
  Attempts& attempts_;
  const RefineOptions& options_;
  bool to_maximum_;
  double whole_over_sample_ = 1;  ///< error over all points by that over the sample, where last measured
  PointShares shares_;
  LevenbergOptions levenberg_;
  std::map<Spans, Entry> entries_;
  std::optional<InteriorKnots> seed_;
};

}  // namespace knotfit
