#include "mesh_outputs.h"

#include <fmt/format.h>

#include "knotfit/exceptions.h"
#include "knotfit/io.h"
#include "knotfit/mesh_io.h"
namespace knotfit::tool {

void check_surface_mesh(const OutputFile& file, int dimension, bool height_field) {
  if (dimension != 3 && !height_field)
    throw InvalidInput(
        fmt::format("{}: holds a surface in space, but this one has {} component{} and is no height field",
                    file.path, dimension, dimension == 1 ? "" : "s"));
}

void write_surface_mesh(const OutputFile& file, bool force, const Surface& surface, const ParameterMap& map,
                        bool height_field, int samples_per_span, const ParameterizedPoints* points,
                        std::span<const double> errors) {
  check_surface_mesh(file, surface.dimension(), height_field);
  Tessellation t = tessellate(height_field ? height_field_in_space(surface, map) : surface, samples_per_span);
  t.map = map;
  if (points != nullptr) add_errors(t, *points, errors);
  write_file(file.path, force, [&](std::ostream& out) {
    if (file.extension == ".obj")
      write_obj(out, t);
    else if (file.extension == ".ply")
      write_ply(out, t);
    else
      write_vts(out, t);
  });
}

void write_mesh_file(const OutputFile& file, bool force, const Mesh& mesh) {
  if (file.extension == ".vts")
    throw InvalidInput(file.path + ": a .vts holds a fitted surface; a mesh becomes .obj or .ply");
  write_file(file.path, force, [&](std::ostream& out) {
    if (file.extension == ".obj")
      write_obj(out, mesh);
    else
      write_ply(out, mesh);
  });
}

}  // namespace knotfit::tool
