// The energy that holds a surface to its data where hardly any point does [METHOD 5.1].
#pragma once
#include <array>
#include <vector>

#include "solve/data_raster.h"
namespace knotfit {

/// Weights and goals over the square, of the data alone: no knots are in it, so a fit's error stays smooth in them.
///
///     sum over kinds of  int w_kind |D_kind S - G_kind|^2,   kinds  uu, uv, vv, u, v
///
/// w follows the data's own spacing, its roughness and the errors that are all the same to the caller; G are the
/// derivatives of the data's own local quadratic, 0 in holes. Piecewise constant on a raster.
class DataEnergy {
 public:
  static constexpr int kKinds = DataRaster::kKinds;
  /// Legendre degrees to which goals are resolved in a cell: moments against P_0, P_1 in each direction.
  static constexpr int kOrder = 2;

  explicit DataEnergy(DataRaster raster);

  int dimension() const { return raster_.dimension; }
  /// Over a cell of positive area.
  /// \param weight  5 integrals of w_kind
  /// \param goal    2 x 2 x 5 x dimension integrals of w_kind G_kind P_a(u') P_b(v'), u', v' in [-1,1]: entry
  ///   [((a * 2 + b) * 5 + kind) * dimension + e]
  /// \param scratch  scratch_size() numbers
  void integrate(double u0, double u1, double v0, double v1, double* weight, double* goal,
                 double* scratch) const;
  Index scratch_size() const { return 2 * channels_; }
  Index goal_size() const { return Index{kOrder * kOrder * kKinds} * dimension(); }
  /// The data's finest spacing along a strip low..high of u (of v: along_v) across the square: a span shorter than it is
  /// not worth a cut.
  double finest_spacing(double low, double high, bool along_v) const;

 private:
  void add_fragments(const std::array<Index, 4>& cells, const std::array<double, 4>& box, double* weight,
                     double* goal) const;
  void from_sums(const std::array<double, 4>& box, double* weight, double* goal, double* total) const;
  void sums_up_to(double u, double v, double* sums) const;

  DataRaster raster_;
  Index channels_;
  std::vector<double>
      sums_;  ///< (side_u + 1) x (side_v + 1) nodes x channels: weights, then the moments of goals
  std::vector<double> finest_u_, finest_v_;
};

}  // namespace knotfit
