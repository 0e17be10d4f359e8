// Which entries of a matrix on a mesh are not 0.
#pragma once
#include <array>
#include <vector>

#include "mesh_support.h"
#include "parameterize/mesh_disk.h"
namespace knotfit::mesh_map {

struct Pattern {
  int vertices;
  std::vector<std::array<int, 2>> edges;
};

inline Pattern sheet_pattern(int cells) {
  const DiskMesh disk = make_disk(test::sheet(cells, cells + 3));
  return {disk.vertex_count(), disk.edge};
}

}  // namespace knotfit::mesh_map
