// Data as rows and columns of points: what the methods ask for that were made for grids.
#pragma once
#include <string>
#include <vector>

#include "fit/fit_problem.h"
namespace knotfit {

/// Positions X(u_i, v_j): the values, or (u, v, z) where they have one component.
struct RowGrid {
  std::vector<double> u, v;  ///< grid lines
  int dimension = 3;
  std::vector<double> x;  ///< u.size() x v.size() x dimension
  std::string note;       ///< how scattered data was resampled; empty: the data's own grid
  const std::vector<double>& lines(bool along_v) const { return along_v ? v : u; }
  /// Point of line i of one direction and line j of the other.
  const double* at(bool along_v, Index i, Index j) const {
    return x.data() +
           (along_v ? j * static_cast<Index>(v.size()) + i : i * static_cast<Index>(v.size()) + j) *
               dimension;
  }
};

/// The points' own grid, or a fit on uniform knots sampled on 101 x 101 lines, ends
/// included [METHOD 2.3].
RowGrid make_row_grid(FitProblem& problem, const InteriorKnots& uniform);

/// Bending and length of the rows that cross the lines of one direction, added over the rows [Park11; METHOD 2.3].
struct RowShape {
  std::vector<double> bend;    ///< a line: turning angles there; 0 at both ends
  std::vector<double> length;  ///< a line: distances to the line before; 0 at the first
};
RowShape row_shape(const RowGrid& grid, bool along_v);

}  // namespace knotfit
