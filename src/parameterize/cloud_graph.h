// A mesh of nearest neighbours, mapped to the square.
#pragma once
#include <span>
#include <vector>

#include "knotfit/parameterize_cloud.h"
#include "parameterize/cloud_neighbours.h"
namespace knotfit::cloud {

/// Triangles that the Delaunay triangulations of neighbourhoods, each in its own plane, agree on [Gopi00]: those that
/// two or three of their corners have, those of three first, as long as no edge gets a third and no vertex a second
/// fan. Gaps are left open.
/// \param near, normals  of the points; neighbours whose normals point away from each other do not count
Mesh join_neighbours(std::span<const double> points, const NeighbourLists& near,
                     const std::vector<Vector>& normals);

/// Its largest part, holes closed by virtual faces, mapped by parameterize_mesh().
/// \throws InvalidInput  there is no part that is a disk with most of the points: why
/// \throws OpenSheet     it has openings, and they are not to be filled
CloudMap map_graph(std::span<const double> points, const NeighbourLists& near,
                   const std::vector<Vector>& normals, const CloudOptions& options, const Control& control);

}  // namespace knotfit::cloud
