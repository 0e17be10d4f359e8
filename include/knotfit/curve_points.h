// Ordered points of a curve, with parameters.
#pragma once
#include <vector>

#include "knotfit/index.h"
#include "knotfit/points.h"
namespace [[gnu::visibility("default")]] knotfit {

/// Points P_k in R^d, in the order the curve runs through them, with parameters t_k.
struct CurvePoints {
  int dimension = 2;            ///< d: 1 a function of t, 2 planar, 3 in space, more for attributes
  std::vector<double> t;        ///< n, in [0,1]; closed: in [0,1), where 1 is 0 again
  std::vector<double> values;   ///< n x dimension, row-major
  std::vector<double> weights;  ///< n, > 0; empty: all 1
  /// Line (files) or index (arrays) of each point in its source, from 1; empty: index + 1.
  std::vector<Index> source;
  bool closed = false;
  /// y over x: dimension 1, t = (x - x0) / (x1 - x0).
  bool function = false;
  double x0 = 0, x1 = 1;

  Index size() const { return static_cast<Index>(t.size()); }
  const double* value(Index k) const { return values.data() + k * dimension; }
  double weight(Index k) const { return weights.empty() ? 1.0 : weights[k]; }
};

/// Shapes, ranges and finiteness. \throws InvalidInput naming the first offending point
void validate(const CurvePoints& points);

/// The points on the border v = 0 of the unit square: u = t.
ParameterizedPoints on_border(const CurvePoints& points);

}  // namespace knotfit
