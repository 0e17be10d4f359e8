// Data to fit: values at parameters in [0,1]^2, and how those parameters came from the user's.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "knotfit/index.h"
namespace knotfit {

/// u = (a - a0) / (a1 - a0) for a user's parameter a, likewise v: the inverse is what
/// evaluation in the user's own coordinates needs.
struct ParameterMap {
  std::string name_u = "u", name_v = "v";  ///< "x", "y" for height fields
  double u0 = 0, u1 = 1;                   ///< user's value at u = 0 and u = 1, u0 < u1
  double v0 = 0, v1 = 1;
  double to_u(double a) const { return (a - u0) / (u1 - u0); }
  double to_v(double b) const { return (b - v0) / (v1 - v0); }
  double from_u(double u) const { return u0 + u * (u1 - u0); }
  double from_v(double v) const { return v0 + v * (v1 - v0); }
  bool identity() const { return u0 == 0 && u1 == 1 && v0 == 0 && v1 == 1; }
  bool operator==(const ParameterMap&) const = default;
};

/// Points P_k in R^d with parameters (u_k, v_k) in [0,1]^2 and weights w_k > 0.
struct ParameterizedPoints {
  int dimension = 1;            ///< d: 1 height fields, 3 geometry, more for attributes
  std::vector<double> uv;       ///< n x 2, row-major, in [0,1]
  std::vector<double> values;   ///< n x dimension, row-major
  std::vector<double> weights;  ///< n, > 0; empty: all 1
  /// Line (files) or index (arrays) of each point in its source, from 1; empty: index + 1.
  std::vector<Index> source;
  bool height_field = false;  ///< values are z over (x, y) = map of (u, v)
  ParameterMap map;

  Index size() const { return static_cast<Index>(uv.size()) / 2; }
  double u(Index k) const { return uv[2 * k]; }
  double v(Index k) const { return uv[2 * k + 1]; }
  const double* value(Index k) const { return values.data() + k * dimension; }
  double weight(Index k) const { return weights.empty() ? 1.0 : weights[k]; }
};

/// Shapes, ranges and finiteness. \throws InvalidInput naming the first offending point.
void validate(const ParameterizedPoints& points);

/// Diagonal of the bounding box of the values: the unit of a relative tolerance
/// (for dimension 1 the range of heights).
double bounding_diagonal(const ParameterizedPoints& points);

/// A tensor grid found in data: every (u_i, v_j) holds exactly one point.
struct GridLayout {
  std::vector<double> u, v;  ///< grid lines, increasing
  std::vector<Index> point;  ///< u.size() x v.size(): the point at (u_i, v_j)
  bool empty() const { return u.empty(); }
};

/// The grid the points lie on, or an empty layout where they do not fill one.
GridLayout find_grid(const ParameterizedPoints& points);

}  // namespace knotfit
