// Keeps parameter triangles from turning over [METHOD 8.4].
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "data/vertex_stars.h"
#include "nearest/foot_points.h"
namespace knotfit::correction {

class ParameterGuard {
 public:
  using Faces = std::span<const std::array<std::int32_t, 3>>;
  ParameterGuard(Faces faces, Index vertices);

  /// Every triangle keeps at least `keep` of its area. The vertices of one that would not go half way back to `from`, from the
  /// seventh time on all the way, until none is left. This ends, since `from` is such a state.
  /// \param to  n x 2, moved   \return vertices held
  Index hold(std::span<const double> from, std::span<double> to, double keep = 0.02);

  /// For after hold(): moves held vertices that slide freely half way to the mean of their neighbours where no triangle turns
  /// over. Without it they jam.
  void relax(std::span<double> to, std::span<const Slide> slide, int passes) const;

 private:
  Faces faces_;
  VertexStars stars_;
  std::vector<unsigned char> back_;  ///< times each vertex went back
};

}  // namespace knotfit::correction
