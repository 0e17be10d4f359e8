// A mesh as its file is read: polygons fanned into triangles, corners checked.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "formats/file_bytes.h"
#include "knotfit/mesh.h"
#include "knotfit/source_data.h"
namespace knotfit {

class MeshBuilder {
 public:
  /// \param counted_from  the file's number of its first vertex and face
  MeshBuilder(const FileBytes& file, Index counted_from);

  /// Room for as many; call it only once the file's size can hold them.
  void reserve(Index vertices, Index triangles, bool lines);
  /// \param line  in the file, from 1; 0: binary
  /// \throws FileError  not finite
  void add_vertex(const double* xyz, Index line);
  /// \throws FileError  the face about to be added has more corners than the file vertices
  void check_corners(Index count, Index vertices, Index line) const;
  /// \param corners  counted from 0
  /// \throws FileError  fewer than three; a million triangles on so few vertices that edges must be shared by more
  ///   than two of them
  /// \param vertices  there are in the file
  void add_face(std::span<const std::int32_t> corners, Index line, Index vertices);
  /// Parameters of every vertex in order, or of the vertices that faces name one by one.
  void add_parameters(double u, double v);
  /// A corner's own parameters: kept where all corners of each vertex agree, else dropped as a whole.
  void set_corner_parameters(std::int32_t vertex, double u, double v);
  /// All parameters are left aside. \param why  for the notes: "face 3 (counted from 1) names texture vertex 9, ..."
  void drop_parameters(const std::string& why);

  const double* vertex(Index k) const { return mesh_.vertex(k); }
  Index vertex_count() const { return mesh_.vertex_count(); }
  /// Faces of the file, not triangles.
  Index face_count() const { return faces_; }

  /// `value` as a corner of the face about to be added, counted from 0.
  /// \param vertices  there are in the file
  /// \throws FileError  not whole, or no vertex of the file
  std::int32_t corner(double value, Index vertices, Index line) const;

  /// \throws FileError  at a line, or at the face or vertex that `what` names in a file without lines
  [[noreturn]] void fail(Index line, const std::string& message) const;

  /// The vertices as points, in a file without faces: with their parameters where each has some.
  PointTable points();
  /// The mesh. \throws FileError  no faces
  Mesh finish();
  /// What there is to say of the mesh after finish(): parameters that were left aside.
  std::vector<std::string> notes() const { return notes_; }

 private:
  void take_corner_parameters();
  /// Where they were dropped, or one is not finite, which is said.
  void leave_parameters_aside(std::string_view whose, std::string_view of_the);

  const FileBytes& file_;
  Mesh mesh_;
  Index faces_ = 0;
  std::vector<double> corner_uv_;   // n x 2, NaN: none yet
  std::vector<std::int32_t> seam_;  // vertices with several, each as often as it was seen
  std::string dropped_;             // why there are no parameters
  std::vector<std::string> notes_;
};

/// "vertices" or "faces" that a header claims against the bytes that follow, `least` bytes each at least.
/// \throws FileError  they cannot hold them, or more than 32 bits can count
void check_claim(const FileBytes& file, Index count, const char* what, double least, std::size_t left);

/// "a PNG image" where bytes begin like a file of a well-known other kind; else empty.
std::string foreign_kind(std::string_view bytes);

}  // namespace knotfit
