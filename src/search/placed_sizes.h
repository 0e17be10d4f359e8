// Sizes on knots that a method of the table places: least squares.
#pragma once
#include "place/context.h"
#include "search/attempts.h"
#include "search/searched.h"
#include "search/size_solver.h"
namespace knotfit {

class PlacedSizes final : public SizeSolver {
 public:
  /// \param problem    of all points
  /// \param on_sample  of a sample of them, which places knots at the sizes it is enough for; or null
  /// \param method     of the table; everything outlives the solver
  PlacedSizes(FitProblem& problem, PlacementContext& context, PlacementContext* on_sample,
              const Searched& searched, Attempts& attempts, std::string_view method);
  const SizeOutcome& solve(const Spans& spans, const Spans* from) override;

 private:
  FitProblem& problem_;
  PlacementContext& context_;
  PlacementContext* on_sample_;
  const Searched& searched_;
  Attempts& attempts_;
  PlaceFunction place_;
};

}  // namespace knotfit
