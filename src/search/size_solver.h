// One size at a time: what the size search asks of a way to place knots.
#pragma once
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "knotfit/features.h"
#include "place/context.h"
#include "search/attempts.h"
namespace knotfit {

using Spans = std::pair<int, int>;  ///< p, q

struct SizeOutcome {
  double error = std::numeric_limits<double>::infinity();  ///< the error that counts, least found
  double least_squares_error = std::numeric_limits<double>::infinity();  ///< before any minimax
  double rms = std::numeric_limits<double>::infinity();
  bool holds = false;
  int tries = 0;
};

/// What the walk may do, by the solver's way.
struct WalkPolicy {
  double hopeless = 1.5;        ///< a containing net that failed by this factor rules a size out
  double hopeless_twice = 1.5;  ///< the same after its second try
  double growth = 0;            ///< the error is taken to grow with this power of the spans left out
  double retry_within = 0;      ///< second tries of sizes that failed by at most this factor; 0: none
  double minimax_gain = 1;      ///< what minimax takes off the least squares' maximum
  int reach = 4;                ///< |p' - p|, |q' - q|
  double least_share = 0.8;     ///< of the control points
  double work = 0;              ///< operations of the walk; 0: fits alone limit it
};

class SizeSolver {
 public:
  virtual ~SizeSolver() = default;
  /// Tries a size and offers what it finds to the attempts. \param from  the size entered from, or null
  virtual const SizeOutcome& solve(const Spans& spans, const Spans* from) = 0;
  virtual const SizeOutcome* seen(const Spans& spans) const = 0;
  /// Some size that contains this one failed by the policy's margin.
  virtual bool hopeless(const Spans& spans) const = 0;
  virtual const WalkPolicy& policy() const = 0;
};

PlacementOptions placement_options(const RefineOptions& options);

/// Knots by a method of the table, least squares.
std::unique_ptr<SizeSolver> placed_sizes(FitProblem& problem, PlacementContext& context, Attempts& attempts,
                                         const RefineOptions& options);

/// The fits of a search whose knots move: on scattered points, without refinement steps, with the data energy.
LeastSquaresOptions search_fits(const RefineOptions& options);

/// Runs a solver from small sizes up, and down again. \return the status where the tolerance is not reached
/// \param first  a size that may hold, tried before all others; sizes do not grow from small ones if it does
Status search_sizes(FitProblem& data, const FineModel& fine, SizeSolver& solver, Attempts& attempts,
                    NoisePlateau& plateau, std::optional<Spans> first = {});

/// The routes.
RefineResult search_placed(FitProblem& data, const RefineOptions& options, const Control& control);
RefineResult search_optimal(FitProblem& data, const RefineOptions& options, const Control& control);
/// Whether insertion with moving knots stays within seconds on so many points.
bool can_optimise_insertion(const ParameterizedPoints& points);
RefineResult insert_isolines(FitProblem& data, const RefineOptions& options, const Control& control);

}  // namespace knotfit
