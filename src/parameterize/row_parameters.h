// Parameters of points along rows, from the distances between neighbours.
#pragma once
#include <span>
#include <vector>

#include "knotfit/parameterize.h"
namespace knotfit::parameterize {

/// Distances between neighbours as the spacing's rule takes them: |d| by chord, its root by centripetal, 1
/// for uniform.
/// \param a, b  x, y, z each; NaN where either is a hole (uniform: 1 all the same)
double spacing_length(const double* a, const double* b, RowSpacing spacing);

/// Running sums of the lengths over their total: 0 to 1, one more than lengths. Empty where all are zero.
std::vector<double> cumulative_parameters(std::span<const double> lengths);

/// One parameter a node for several lines over the same nodes: the mean of each line's own [Piegl97 A9.3].
/// A line with holes has lengths for its known gaps only; its scale is then the one that makes those gaps as
/// long as the mean says: gaps w_j and scales s_r of lengths d_rj ~ s_r w_j are found in turn, which for lines
/// without holes ends at once in the mean. Lines of no length are left out; gaps that no line knows
/// take the mean of the others.
/// \param lengths  lines x gaps, row-major, NaN where unknown
/// \return gaps + 1 parameters from 0 to 1; empty where no line has a length
std::vector<double> averaged_parameters(std::span<const double> lengths, Index gaps);

}  // namespace knotfit::parameterize
