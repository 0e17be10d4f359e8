// Knots moved across the others: how an optimisation leaves its local minimum [METHOD 3.4].
#pragma once
#include "place/levenberg.h"
namespace knotfit {

struct RelocationOptions {
  int passes = 12;     ///< over both directions, at most
  int candidates = 3;  ///< knots of least loss tried in a direction
  int peaks = 1;       ///< of the gain at which the knot is tried again
  double gain = 1e-3;  ///< relative fall of phi that keeps a move
};

/// Drops the knot of least loss, inserts one where the gain peaks, optimises, keeps it if phi falls; until
/// a pass over both directions finds none. The problem holds the fit of the result. \return phi there
double relocate_knots(MovingFit& problem, InteriorKnots& knots, double phi, const LevenbergOptions& levenberg,
                      const RelocationOptions& options = {});

/// Ties the nearest knots into multiple ones, one unknown each, where that lowers phi: the data has a crease or
/// a jump there. \return phi
double tie_knots(MovingFit& problem, InteriorKnots& knots, double phi, const LevenbergOptions& levenberg);

/// Adds knots at the greatest gain or drops those of least loss, `steps` Levenberg-Marquardt steps after
/// each, until the counts are reached.
InteriorKnots adapt_knots(MovingFit& problem, InteriorKnots knots, std::size_t count_u, std::size_t count_v,
                          const LevenbergOptions& levenberg, int steps = 2);

}  // namespace knotfit
