// Sparse factors of systems on a mesh: multifrontal, no pivoting, on one Elimination.
#pragma once
#include <span>
#include <vector>

#include "parameterize/mesh_elimination.h"
namespace knotfit::mesh_map {

/// Cholesky factor of a positive definite matrix of 2 x 2 blocks, a block a vertex.
class BlockCholesky {
 public:
  explicit BlockCholesky(const Elimination& elimination) : elimination_(elimination) {}
  /// \param diagonal  a vertex each: its block, row by row (4 numbers, symmetric)
  /// \param off       an edge (a, b) each: rows of a, columns of b, row by row (4 numbers)
  /// \return false where the matrix is not positive definite to rounding
  bool factor(std::span<const double> diagonal, std::span<const double> off);
  /// x <- A^-1 x, 2 numbers a vertex.
  void solve(std::span<double> x) const;
  /// Frees the factor.
  void release() { columns_.clear(); }

 private:
  const Elimination& elimination_;
  std::vector<std::vector<double>> columns_;  ///< a front each: its own columns, rows x width scalars
};

/// LU factor of a matrix with a unit diagonal that needs no pivots: rows of a convex combination map
/// are diagonally dominant.
class DirectedLU {
 public:
  explicit DirectedLU(const Elimination& elimination) : elimination_(elimination) {}
  /// \param forward, backward  an edge (a, b) each: entry (a, b) and entry (b, a)
  /// \return false where a pivot vanishes
  bool factor(std::span<const double> forward, std::span<const double> backward);
  /// x <- A^-1 x for two right sides, x and y of each vertex side by side.
  void solve(std::span<double> x) const;

 private:
  const Elimination& elimination_;
  std::vector<std::vector<double>>
      lower_;  ///< a front each: rows x width, unit lower part and U's diagonal block
  std::vector<std::vector<double>> upper_;  ///< a front each: U right of that block, transposed
};

}  // namespace knotfit::mesh_map
