// What every repair of a mesh keeps.
#pragma once
#include <gtest/gtest.h>

#include "knotfit/mesh.h"
namespace knotfit::test {

/// What came from the mesh is where it was.
inline void expect_same_places(const Mesh& before, const RepairedMesh& after) {
  ASSERT_EQ(static_cast<Index>(after.kept.size()), after.mesh.vertex_count());
  for (Index k = 0; k < after.mesh.vertex_count(); ++k) {
    if (after.kept[k] < 0) continue;
    for (int d = 0; d < 3; ++d) EXPECT_EQ(after.mesh.vertex(k)[d], before.vertex(after.kept[k])[d]);
  }
}

}  // namespace knotfit::test
