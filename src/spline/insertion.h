// Knot refinement of control points that lie in an array of any layout.
#pragma once
#include <span>
#include <vector>

#include "knotfit/index.h"
#include "knotfit/knot_vector.h"
namespace knotfit {

struct RefinedPoints {
  KnotVector knots;
  std::vector<double> points;  ///< outer x knots.size() x inner
};

/// \param added   sorted, repeats allowed
/// \param points  outer x knots.size() x inner, row-major: outer splines whose control points
///   have `inner` numbers
/// \throws InvalidInput  a knot outside the domain's inside, out of order, or too often there
RefinedPoints refine_points(const KnotVector& knots, std::span<const double> added,
                            std::span<const double> points, Index outer, Index inner);

}  // namespace knotfit
