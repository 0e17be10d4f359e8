#include "data/vertex_stars.h"

#include "base/counting_sort.h"
namespace knotfit {

VertexStars::VertexStars(std::span<const std::array<std::int32_t, 3>> faces, Index vertices) {
  std::vector<std::int32_t> corner;
  corner.reserve(3 * faces.size());
  for (const auto& t : faces) corner.insert(corner.end(), t.begin(), t.end());
  start_ = counting_sort(corner, vertices, face_);
  for (std::int32_t& k : face_) k /= 3;
}

}  // namespace knotfit
