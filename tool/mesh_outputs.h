// Surfaces and meshes as .obj, .ply and .vts files.
#pragma once
#include <span>

#include "knotfit/io.h"
#include "knotfit/mesh.h"
#include "outputs.h"
namespace knotfit::tool {

inline constexpr int kSamplesPerSpan = 4;

/// The surface in space, in triangles or as a grid.
/// \param points, errors  what the fit was to, in input order; null and empty: not measured
/// \throws InvalidInput  a surface that is neither in space nor a height field
void write_surface_mesh(const OutputFile& file, bool force, const Surface& surface, const ParameterMap& map,
                        bool height_field, int samples_per_span, const ParameterizedPoints* points,
                        std::span<const double> errors);

/// Before long work: what write_surface_mesh would refuse.
void check_surface_mesh(const OutputFile& file, int dimension, bool height_field);

/// \throws InvalidInput  .vts holds surfaces only
void write_mesh_file(const OutputFile& file, bool force, const Mesh& mesh);

}  // namespace knotfit::tool
