// Corners that a file gives to each face apart: vertices at the same place made one where that joins the mesh. Faces that
// it gives twice.
#pragma once
#include "knotfit/mesh.h"
namespace [[gnu::visibility("default")]] knotfit {

struct WeldSummary {
  Index vertices = 0;    ///< that went into another one
  double distance = 0;   ///< the farthest that one of them lies from the vertex it went into
  double tolerance = 0;  ///< in force, in the mesh's unit
  Index parts_before = 0, parts_after = 0;
  /// Vertices at places of others on the border of a part that is left as it is cut: welded, it would be closed or
  /// have another rim more, and no disk.
  Index left_apart = 0;
  Index parameters = 0;  ///< vertices whose parameters differed from those of the one they went into
};

/// The usual tolerance: 1e-7 of the diagonal of the bounding box. For coordinates of single precision at least their
/// last bit, where that is more.
/// \param single_precision  by its format; else where every coordinate is such a number and their last bits are used
double weld_tolerance(const Mesh& mesh, bool single_precision = false);

/// Edges with one face whose ends lie within the tolerance of those of another such edge become one edge; vertices
/// that merely meet stay apart. No vertex moves: each goes into the first of those at its place. Faces whose corners
/// fall together stay, with a repeated corner. Parameters that differ where vertices become one are dropped as a whole.
/// \param tolerance  in the mesh's unit; 0: equal places alone. At most half the length of the edges it joins counts
/// \param keep_parameters  vertices whose parameters differ stay apart
/// \throws InvalidInput  see inspect(); the tolerance is negative, not finite or above 1 % of the diagonal
WeldSummary weld(Mesh& mesh, double tolerance, bool keep_parameters = false);

struct DoubledFaces {
  Index faces = 0;     ///< of the file, dropped
  Index reversed = 0;  ///< of them, those with their corners in the opposite order
};

/// Of faces whose corners lie at the very same places, in the same order or the opposite one (two-sided models), keeps
/// one: the first, turned where only that agrees with its neighbours and the file has it that way too. Vertices that then
/// no face uses go. Before weld(): two sides with vertices of their own would become a closed mesh.
/// \throws InvalidInput  see inspect()
DoubledFaces drop_doubled_faces(Mesh& mesh);

}  // namespace knotfit
