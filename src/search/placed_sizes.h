// Sizes on knots that a method of the table places: least squares.
#pragma once
#include "place/context.h"
#include "search/attempts.h"
#include "search/size_solver.h"
namespace knotfit {

class PlacedSizes final : public SizeSolver {
 public:
  /// \param method  of the table; everything outlives the solver
  PlacedSizes(FitProblem& problem, PlacementContext& context, Attempts& attempts, std::string_view method);
  const SizeOutcome& solve(const Spans& spans, const Spans* from) override;

 private:
  FitProblem& problem_;
  PlacementContext& context_;
  Attempts& attempts_;
  PlaceFunction place_;
};

}  // namespace knotfit
