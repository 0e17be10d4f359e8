// Steps of a mesh repair, each on its own.
#pragma once
#include <vector>

#include "knotfit/mesh.h"
namespace knotfit {

/// Keeps the faces whose entry is not 0, and notes which face of the file each came from.
void keep_faces(Mesh& mesh, const std::vector<char>& keep);

/// Keeps the vertices whose entry is not 0, and notes which vertex of the file each was. No face has one of the others.
void keep_vertices(Mesh& mesh, const std::vector<char>& keep);

/// 1 for every vertex that a face has.
std::vector<char> used_vertices(const Mesh& mesh);

/// Fills face_source, vertex_source: what an empty one stands for.
void name_sources(Mesh& mesh);

/// Drops every face of no area. Two corners at the same place are merged where the mesh stays manifold; a
/// corner on the opposite side becomes a corner of the face beyond it, which is split there. Neither opens a gap.
/// \return faces dropped
Index drop_degenerate_faces(Mesh& mesh);

/// Closes every boundary loop but the longest of its part: a new vertex in the middle, virtual faces to the edges.
/// \return holes filled
Index fill_holes(Mesh& mesh);

}  // namespace knotfit
