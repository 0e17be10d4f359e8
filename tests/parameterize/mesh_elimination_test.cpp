#include "parameterize/mesh_elimination.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "pattern.h"

namespace knotfit::mesh_map {
namespace {

TEST(Elimination, GivesEveryVertexOnePlaceAndEveryEdgeOneEntry) {
  const Pattern p = sheet_pattern(12);
  const Elimination elimination(p.vertices, p.edges);
  std::vector<int> seen(static_cast<std::size_t>(p.vertices), 0), entered(p.edges.size(), 0);
  int place = 0;
  for (int f = 0; f < static_cast<int>(elimination.fronts().size()); ++f) {
    const Front& front = elimination.fronts()[f];
    EXPECT_EQ(front.first, place);
    for (int k = 0; k < front.width; ++k) ++seen[elimination.vertex(place++)];
    EXPECT_TRUE(front.parent < 0 || front.parent > f);
    for (const EdgeEntry& entry : elimination.entries(f)) ++entered[entry.edge];
  }
  EXPECT_EQ(place, p.vertices);
  EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int n) { return n == 1; }));
  EXPECT_TRUE(std::all_of(entered.begin(), entered.end(), [](int n) { return n == 1; }));
}

}  // namespace
}  // namespace knotfit::mesh_map
