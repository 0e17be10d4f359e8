// Whether the parameters that a mesh came with, such as texture coordinates, can be parameters of a surface.
#pragma once
#include <string>

#include "knotfit/mesh.h"
namespace [[gnu::visibility("default")]] knotfit {

struct ParameterCheck {
  bool one_to_one = false;
  std::string
      why;  ///< not so: "they are equal at all vertices", "64 of 128 triangles are mirrored"; else empty
};

/// Of a mesh with parameters: every vertex has its own place in the plane, every triangle with an area in space has
/// one there (the tenth part of a percent of them aside), all turn the same way and none covers another. To within
/// 1e-6 of their range, as files of six digits round. Virtual faces do not count. O(n log n) for charts of
/// triangles that are not all slivers.
/// \throws InvalidInput  see inspect(); mesh.uv is not two numbers a vertex
ParameterCheck check_parameters(const Mesh& mesh);

}  // namespace knotfit
