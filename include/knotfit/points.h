// Data to fit: values at parameters in [0,1]^2, and how those parameters came from the user's.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "knotfit/index.h"
namespace [[gnu::visibility("default")]] knotfit {

/// u = (a - a0) / (a1 - a0) for a user's parameter a, likewise v: the inverse is what
/// evaluation in the user's own coordinates needs.
struct ParameterMap {
  std::string name_u = "u", name_v = "v";  ///< "x", "y" for height fields
  double u0 = 0, u1 = 1;                   ///< user's value at u = 0 and u = 1, u0 < u1
  double v0 = 0, v1 = 1;
  /// Oblique parameters of a height field, in [-1,1], one of them 0: with (s, t) the user's rectangle scaled to the
  /// unit square, u = (s + shear_u t - min(shear_u, 0)) / (1 + |shear_u|), v = (t + shear_v s - min(shear_v, 0)) /
  /// (1 + |shear_v|). The rectangle becomes a parallelogram in the square, which is all that holds data.
  double shear_u = 0, shear_v = 0;
  bool sheared() const { return shear_u != 0 || shear_v != 0; }
  // Along an axis, without the shear: s of a, t of b and back.
  double to_u(double a) const { return (a - u0) / (u1 - u0); }
  double to_v(double b) const { return (b - v0) / (v1 - v0); }
  double from_u(double s) const { return u0 + s * (u1 - u0); }
  double from_v(double t) const { return v0 + t * (v1 - v0); }
  /// The shear alone, of (s, t), and back.
  std::array<double, 2> shear(double s, double t) const;
  std::array<double, 2> unshear(double u, double v) const;
  /// (u, v) of the user's (a, b), and back.
  std::array<double, 2> to_uv(double a, double b) const { return shear(to_u(a), to_v(b)); }
  std::array<double, 2> from_uv(double u, double v) const {
    const auto [s, t] = unshear(u, v);
    return {from_u(s), from_v(t)};
  }
  /// Whether (u, v), up to rounding, lies over the user's rectangle.
  bool covers(double u, double v) const;
  bool identity() const { return u0 == 0 && u1 == 1 && v0 == 0 && v1 == 1 && !sheared(); }
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

/// The same points at oblique parameters (ParameterMap::shear_u, shear_v). \throws InvalidInput  beyond [-1,1], or both not 0
ParameterizedPoints sheared(const ParameterizedPoints& points, double shear_u, double shear_v);

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
