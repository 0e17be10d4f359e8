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
namespace knotfit {

class OptimizedSizes final : public SizeSolver {
 public:
  /// \param problem  scattered, over the guard's points where there is a guard, else over the data
  /// \param context  of that problem, with the fine model set
  OptimizedSizes(MovingFit& problem, PlacementContext& context, Guard* guard, Attempts& attempts,
                 const RefineOptions& options);

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
  double measured() const;
  void use_base_weights();

  MovingFit& problem_;
  PlacementContext& context_;
  Guard* guard_;
  Attempts& attempts_;
  const RefineOptions& options_;
  bool to_maximum_;
  PointShares shares_;
  LevenbergOptions levenberg_;
  std::map<Spans, Entry> entries_;
  std::optional<InteriorKnots> seed_;
};

}  // namespace knotfit
