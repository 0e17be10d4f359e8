// Tensor-product B-spline surfaces in a space of any dimension.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "knotfit/knot_vector.h"
namespace [[gnu::visibility("default")]] knotfit {

/// S(u,v) = sum_ij B_i(u) B_j(v) c_ij, c_ij in R^dimension.
class Surface {
 public:
  Surface() = default;
  /// \param net  size_u x size_v x dimension: net[(i*size_v + j)*dimension + d]
  /// \throws InvalidInput  the net's length does not fit the knots, or an entry is not finite
  Surface(KnotVector knots_u, KnotVector knots_v, int dimension, std::vector<double> net);

  const KnotVector& knots_u() const { return knots_u_; }
  const KnotVector& knots_v() const { return knots_v_; }
  int degree_u() const { return knots_u_.degree(); }
  int degree_v() const { return knots_v_.degree(); }
  Index size_u() const { return knots_u_.size(); }
  Index size_v() const { return knots_v_.size(); }
  int dimension() const { return dimension_; }
  Index control_point_count() const { return size_u() * size_v(); }
  const std::vector<double>& net() const { return net_; }
  std::span<const double> control_point(Index i, Index j) const {
    return {net_.data() + (i * size_v() + j) * dimension_, static_cast<std::size_t>(dimension_)};
  }
  /// Largest absolute coordinate of the net: the scale of rounding errors.
  double scale() const;
  bool empty() const { return net_.empty(); }
  bool operator==(const Surface&) const = default;

 private:
  KnotVector knots_u_, knots_v_;
  int dimension_ = 0;
  std::vector<double> net_;
};

/// A height field z(u,v) over x = x0 + u (x1 - x0), y likewise, as a surface in space: x and y
/// get the Greville abscissae as control points, which reproduces them exactly.
/// \throws InvalidInput  dimension of `height` is not 1
Surface height_field_in_space(const Surface& height, double x0, double x1, double y0, double y1);
/// The same over the parallelogram with the corners (x, y) at (u, v) = (0,0), (1,0) and (0,1).
Surface height_field_in_space(const Surface& height, std::array<double, 2> corner_00,
                              std::array<double, 2> corner_10, std::array<double, 2> corner_01);

/// Surface with u and v exchanged.
Surface transposed(const Surface& s);

// Knot insertion, refinement and removal. All keep or approximate S over the same domain.

/// Inserts one knot [Piegl97 A5.3]; S unchanged. \throws InvalidInput  knot outside the domain's
/// inside, or its multiplicity would pass the degree + 1
Surface insert_knot_u(const Surface& s, double knot);
Surface insert_knot_v(const Surface& s, double knot);
/// Inserts every knot of `added` (sorted, repeats allowed) [Piegl97 A5.4]; S unchanged.
Surface refine_u(const Surface& s, std::span<const double> added);
Surface refine_v(const Surface& s, std::span<const double> added);

struct KnotRemoval {
  Surface surface;  ///< with the knot removed once where error <= tolerance, else unchanged
  bool removed = false;
  double error = 0;  ///< bound on the distance the removal moves S by, over the whole domain
};
/// Removes one interior knot once if S moves by at most `tolerance` [Piegl97 A5.8, Tiller92].
KnotRemoval remove_knot_u(const Surface& s, double knot, double tolerance);
KnotRemoval remove_knot_v(const Surface& s, double knot, double tolerance);

}  // namespace knotfit
