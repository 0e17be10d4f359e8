// Sizes p x q from small to the first that holds, then the walk down [METHOD 4.1].
#pragma once
#include <optional>

#include "place/context.h"
#include "search/attempts.h"
#include "search/noise_plateau.h"
#include "search/size_solver.h"
namespace knotfit {

/// \param data   the points themselves: what their number and lines allow
/// \param first  a size that may hold, tried before all others; sizes do not grow from small ones if it does
/// \return the status where the tolerance is not reached
Status search_sizes(FitProblem& data, const FineModel& fine, SizeSolver& solver, Attempts& attempts,
                    NoisePlateau& plateau, std::optional<Spans> first = {});

}  // namespace knotfit
