// Knots as spacings, whose logarithms are the unknowns of their optimisation [Jupp78; METHOD 3.2].
#pragma once
#include <vector>

#include "knotfit/interior_knots.h"
namespace knotfit {

/// One direction: lengths h_i of its spans, and the multiplicity of the knot after each but the last.
/// Equal knots are one unknown, so a multiple knot stays one.
struct KnotSpacings {
  std::vector<double> length;
  std::vector<int> multiplicity;

  KnotSpacings() = default;
  explicit KnotSpacings(const std::vector<double>& knots);
  std::vector<double> knots() const;
  std::size_t knot_count() const;
  /// h_i <- h_i exp(step_i), normalised to sum 1; spans then raised to `least` times the mean.
  KnotSpacings moved(const double* step, double least) const;
  /// Writes d u_j / d a_i = h_i ([i <= j] - u_j) for every knot (copies alike) at
  /// matrix[(row + j) * stride + column + i].
  void chain(std::vector<double>& matrix, std::size_t row, std::size_t column, std::size_t stride) const;
};

/// Both directions moved so. \param step  of u, then of v
InteriorKnots moved_knots(const InteriorKnots& knots, const double* step, double least);

/// Raises every length below `least` times the mean to it and shrinks the others in proportion.
void raise_lengths(std::vector<double>& length, double least);

}  // namespace knotfit
