// The triangles at each vertex.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "knotfit/index.h"
namespace knotfit {

class VertexStars {
 public:
  VertexStars(std::span<const std::array<std::int32_t, 3>> faces, Index vertices);
  /// Ascending; a face with a repeated corner stands there for each of them.
  std::span<const std::int32_t> of(Index vertex) const {
    return std::span(face_).subspan(static_cast<std::size_t>(start_[vertex]),
                                    static_cast<std::size_t>(start_[vertex + 1] - start_[vertex]));
  }

 private:
  std::vector<Index> start_;
  std::vector<std::int32_t> face_;
};

}  // namespace knotfit
