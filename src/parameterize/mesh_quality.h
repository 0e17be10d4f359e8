// What a map does to a mesh, in the numbers that are shown.
#pragma once
#include <span>

#include "knotfit/parameterize_mesh.h"
#include "parameterize/mesh_disk.h"
namespace knotfit::mesh_map {

MapQuality measure_quality(const DiskMesh& disk, std::span<const double> uv);

}  // namespace knotfit::mesh_map
