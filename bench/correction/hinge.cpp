// What hinge rows cost and save: knotfit_bench_hinge N MESH...
// Each mesh at N x N control points on uniform knots, with hinge rows and without; a line of JSON each on standard output,
// for docs/parameters.md (scripts/correction --part hinge). Lengths over the diagonal of the vertices.
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <nlohmann/json.hpp>

#include "knotfit/correct.h"
#include "knotfit/io.h"
#include "knotfit/parameterize.h"
#include "knotfit/parameterize_mesh.h"
namespace {

using namespace knotfit;

nlohmann::ordered_json measured(const Mesh& mesh, const MeshMap& map, int control_points, bool hinge) {
  CorrectionOptions options;
  options.hinge = hinge;
  const KnotVector knots = KnotVector::uniform(3, control_points - 4);
  const CorrectionResult r = correct_parameters(mesh, map, knots, knots, options);
  const DistanceSummary back = mesh_distances(r.surface, mesh, r.uv);
  const double diagonal = bounding_diagonal(mesh_points(mesh, r.uv));
  return {{"hinge", hinge},
          {"v", {r.distance.rms / diagonal, r.distance.max / diagonal}},
          {"r", {back.rms / diagonal, back.max / diagonal}},
          {"raw", r.folds.raw},
          {"blurred", r.folds.blurred}};
}

}  // namespace

int main(int argc, char** argv) {
  const int control_points = argc > 2 ? std::atoi(argv[1]) : 0;
  if (control_points < 4) {
    std::fprintf(stderr, "usage: knotfit_bench_hinge N MESH..., N at least 4\n");
    return 2;
  }
  try {
    for (int k = 2; k < argc; ++k) {
      const SourceData data = read_data(argv[k]);
      const Mesh* read = std::get_if<Mesh>(&data.content);
      if (!read) throw std::runtime_error(std::string(argv[k]) + ": is no mesh");
      const Mesh mesh = repair(*read, {.fill_holes = true}).mesh;
      const MeshMap map = parameterize_mesh(mesh);
      for (const bool hinge : {true, false}) {
        std::printf("%s\n", measured(mesh, map, control_points, hinge).dump().c_str());
        std::fflush(stdout);
      }
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "knotfit_bench_hinge: %s\n", error.what());
    return 1;
  }
  return 0;
}
