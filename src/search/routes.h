// The routes to a tolerance for points, and what they share.
#pragma once
#include "knotfit/place.h"
#include "knotfit/refine.h"
namespace knotfit {

class FitProblem;

PlacementOptions placement_options(const RefineOptions& options);

/// The fits of a search whose knots move: on scattered points, without refinement steps, with the data energy.
LeastSquaresOptions search_fits(const RefineOptions& options);

/// Knots that a method places at every size.
RefineResult search_placed(FitProblem& data, const RefineOptions& options, const Control& control);
/// Knots that minimise the error, where that can pay.
RefineResult search_optimal(FitProblem& data, const RefineOptions& options, const Control& control);
/// Knot lines inserted where features or errors are large.
RefineResult insert_isolines(FitProblem& data, const RefineOptions& options, const Control& control);
/// Whether insertion with moving knots stays within seconds on so many points.
bool can_optimise_insertion(const ParameterizedPoints& points);

/// Where nothing holds: knots whose surfaces came nearest, held to the data by an energy for errors of their own size, may
/// be nearer than the best that does not swing by itself.
void hold(RefineResult& result, const ParameterizedPoints& points, const RefineOptions& options,
          const Control& control);

}  // namespace knotfit
