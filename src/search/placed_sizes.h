// Sizes on knots that a method of the table places: least squares.
#pragma once
#include "place/context.h"
#include "search/attempts.h"
#include "search/searched_points.h"
#include "search/size_solver.h"
namespace knotfit {

class PlacedSizes final : public SizeSolver {
 public:
  /// \param problem  of all points: what every size is fitted to and judged by
  /// \param context  of the points searched, which places knots at the sizes that they are enough for
  /// \param on_all   of all points, for the others
  /// \param method   of the table; everything outlives the solver
  PlacedSizes(FitProblem& problem, const SearchedPoints& searched, PlacementContext& context,
              PlacementContext& on_all, Attempts& attempts, std::string_view method);
  const SizeOutcome& solve(const Spans& spans, const Spans* from) override;

 private:
  FitProblem& problem_;
  const SearchedPoints& searched_;
  PlacementContext &context_, &on_all_;
  Attempts& attempts_;
  PlaceFunction place_;
};

}  // namespace knotfit
