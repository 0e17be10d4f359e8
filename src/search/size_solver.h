// One size at a time: what a search asks of a way to fit it.
#pragma once
#include <limits>
#include <map>
#include <utility>

#include "knotfit/interior_knots.h"
namespace knotfit {

using Spans = std::pair<int, int>;  ///< p, q; of a curve q is 1

struct SizeOutcome {
  double error = std::numeric_limits<double>::infinity();  ///< the error that counts, least found
  double least_squares_error = std::numeric_limits<double>::infinity();  ///< before any minimax
  double rms = std::numeric_limits<double>::infinity();
  bool holds = false;  ///< the tolerance, and judged between the points too
  int tries = 0;
};

/// What the walk to smaller sizes may do, by the solver's way.
struct WalkPolicy {
  double hopeless = 1.5;        ///< a containing net that failed by this factor rules a size out
  double hopeless_twice = 1.5;  ///< the same after its second try
  double growth = 0;            ///< the error is taken to grow with this power of the spans left out
  double retry_within = 0;      ///< second tries of sizes that failed by at most this factor; 0: none
  double minimax_gain = 1;      ///< what minimax takes off the least squares' maximum
  int reach = 4;                ///< |p' - p|, |q' - q|
  double least_share = 0.8;     ///< of the control points
  double operations = 0;        ///< of the walk; 0: fits alone limit it
};

/// Solvers are told apart by how they fit one size: on placed knots, on optimised ones, with a mesh's parameters moving,
/// along a curve. What goes from size to size is the same for all of a kind: size_search.h, mesh_search.h, curve_search.h.
class SizeSolver {
 public:
  virtual ~SizeSolver() = default;
  /// Tries a size and keeps what it finds where that is the best so far. \param from  the size entered from, or null
  virtual const SizeOutcome& solve(const Spans& spans, const Spans* from) = 0;

  /// Null where a size was not tried.
  const SizeOutcome* seen(const Spans& spans) const;
  /// Some size that contains this one failed by the policy's margin.
  bool hopeless(const Spans& spans, double tolerance) const;
  const WalkPolicy& policy() const { return policy_; }

 protected:
  WalkPolicy policy_;
  std::map<Spans, SizeOutcome> outcomes_;
};

}  // namespace knotfit
