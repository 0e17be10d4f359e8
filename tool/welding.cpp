#include "welding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "knotfit/exceptions.h"
#include "knotfit/mesh_parameters.h"
#include "knotfit/weld_mesh.h"
#include "text_values.h"
namespace knotfit::tool {
namespace {

double diagonal_of(const Mesh& mesh) {
  double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
  for (Index k = 0; k < mesh.vertex_count(); ++k)
    for (int d = 0; d < 3; ++d) {
      low[d] = std::min(low[d], mesh.vertex(k)[d]);
      high[d] = std::max(high[d], mesh.vertex(k)[d]);
    }
  return mesh.vertex_count() > 0 ? std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) : 0;
}

std::string plural(Index count, const char* one, const char* several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

/// Parameters that differ on both sides of an edge belong to a mesh that is cut there: kept where they are one-to-one
/// and the cuts part nothing.
WeldSummary weld_with_parameters(Mesh& mesh, double tolerance, bool keep_parameters) {
  Mesh whole = mesh;
  const WeldSummary summary = weld(whole, tolerance);
  if (summary.parameters == 0) {
    mesh = std::move(whole);
    return summary;
  }
  Mesh cut = std::move(mesh);
  const WeldSummary of_cut = weld(cut, tolerance, true);
  const bool kept =
      keep_parameters || (of_cut.parts_after <= summary.parts_after && check_parameters(cut).one_to_one);
  mesh = kept ? std::move(cut) : std::move(whole);
  return kept ? of_cut : summary;
}

void drop_doubled(Mesh& mesh, SourceData& data) {
  DoubledFaces doubled;
  try {
    doubled = drop_doubled_faces(mesh);
  } catch (const InvalidInput& e) {
    throw InvalidInput(data.path + ": " + e.what());
  }
  if (doubled.faces == 0) return;
  std::string how = doubled.reversed == 0 ? "in the same order"
                    : doubled.reversed == doubled.faces
                        ? "in the opposite order, as in two-sided models"
                        : fmt::format("{} of them in the opposite order", doubled.reversed);
  data.notes.push_back(fmt::format("{} there a second time, with the same corners {}: one of each is kept",
                                   plural(doubled.faces, "face is", "faces are"), how));
}

}  // namespace

Index weld_input(SourceData& data, const InputOptions& options) {
  Mesh* mesh = std::get_if<Mesh>(&data.content);
  if (mesh == nullptr || options.every_vertex) return 0;
  drop_doubled(*mesh, data);
  const WeldChoice choice = parse_weld(options.weld.value_or("auto"));
  if (choice.off) return 0;
  WeldSummary summary;
  try {
    const double tolerance =
        !choice.tolerance
            ? weld_tolerance(*mesh, data.format == "stl")
            : choice.tolerance->value * (choice.tolerance->relative ? diagonal_of(*mesh) / 100 : 1);
    summary = mesh->uv.empty() ? weld(*mesh, tolerance)
                               : weld_with_parameters(*mesh, tolerance, options.keep_parameters);
  } catch (const InvalidInput& e) {
    throw InvalidInput(fmt::format("{}: {}{}", data.path, choice.tolerance ? "--weld: " : "", e.what()));
  }
  if (summary.vertices > 0)
    data.notes.push_back(
        fmt::format("welded: {} at the place of another (within {:.3g}) went into it, since faces had "
                    "corners of their own there; "
                    "--weld off keeps them",
                    plural(summary.vertices, "vertex", "vertices"), summary.tolerance));
  if (summary.parameters > 0)
    data.notes.push_back(
        fmt::format("the mesh's parameters (texture coordinates) are left aside: {} that were welded had "
                    "others than their "
                    "neighbour, a seam between charts",
                    plural(summary.parameters, "vertex", "vertices")));
  if (summary.left_apart > 0)
    data.notes.push_back(
        fmt::format("{} at the place of another on the border were left apart: the mesh is cut open there, "
                    "and would be no disk "
                    "without the cut",
                    plural(summary.left_apart, "vertex", "vertices")));
  return summary.vertices;
}

std::string weld_hint(const Mesh& mesh) {
  const Index parts = inspect(mesh).parts;
  if (parts < 2 || !std::isfinite(diagonal_of(mesh))) return "";
  Index fewest = parts;
  double best = 0;
  for (const double percent : {1e-5, 1e-4, 1e-3, 1e-2, 1e-1}) {
    Mesh copy = mesh;
    const Index left = weld(copy, percent / 100 * diagonal_of(mesh)).parts_after;
    if (left < fewest) fewest = left, best = percent;
    if (fewest == 1) break;
  }
  if (fewest == parts) return "";
  return fmt::format("; edges of different parts lie within {0:g} of each other: --weld {1:g}% makes {2}",
                     best / 100 * diagonal_of(mesh), best,
                     fewest == 1 ? "one part of them" : fmt::format("{} parts of them", fewest));
}

}  // namespace knotfit::tool
