// The least maximum: control points and knots together, by L_P with growing P [METHOD 4.3].
#pragma once
#include <functional>
#include <vector>

#include "fit/moving_fit.h"
namespace knotfit {

/// What each point weighs, in the problem's stored order: its weight in the least squares, and the inverse
/// of its slack in the maximum (0: not in it). Empty: all 1.
struct PointShares {
  std::vector<double> base, inverse_slack;
};

/// A net on its knots that need not minimise the squares.
struct NetState {
  InteriorKnots knots;
  std::vector<double> net, residual;
  double max = 0;  ///< largest |r| / slack
};

struct MinimaxOptions {
  double enough = 0;          ///< ends at a maximum of at most this
  double least_span = 0.005;  ///< of the mean span
  int outer_steps = 8;        ///< steps of the knots at each P
  int inner_rounds = 6;       ///< reweightings at each step, twice as many at the first of each P
  bool move_knots = true;
  /// Ends early at a maximum this many times farther from `enough` than later stages ever gained; 0: never.
  double patience = 0;
  std::vector<double> powers{4, 6, 9, 13, 20, 30, 45, 70, 110};
  std::function<bool()> stop;
};

/// Largest |r| / slack of the problem's present residual.
double largest_error(MovingFit& problem, const PointShares& shares);

/// The state the problem holds.
NetState state_of(MovingFit& problem, const PointShares& shares);

/// Minimises max |r| / slack from the state of the problem's last solve. The problem is left with the best
/// state and with the base weights. \return that state
NetState minimize_maximum(MovingFit& problem, const PointShares& shares, const MinimaxOptions& options);

/// The weights that the best state of minimize_maximum was the least-squares fit of, roughly:
/// (|r| / (slack max))^(P-2) / slack^2 + eps base.
std::vector<double> minimax_weights(MovingFit& problem, const PointShares& shares, double power);

}  // namespace knotfit
