// The knots that a placement chooses.
#pragma once
#include <vector>
namespace [[gnu::visibility("default")]] knotfit {

/// Interior knots of both directions of a surface over [0,1]^2, non-decreasing in (0,1).
struct InteriorKnots {
  std::vector<double> u, v;
  bool operator==(const InteriorKnots&) const = default;
};

}  // namespace knotfit
