// What a mesh costs before and after its knots are known: the map, the search for corners around it, rounds of the
// correction. The face of samples/ (17 157 vertices).
#include <benchmark/benchmark.h>

#include "correct/prepared_mesh.h"
#include "knotfit/io.h"
#include "knotfit/parameterize_mesh.h"
namespace knotfit {
namespace {

void by_both_clocks(benchmark::internal::Benchmark* b) {
  b->Unit(benchmark::kMillisecond)->UseRealTime()->MeasureProcessCPUTime();
}

const Mesh& face() {
  static const Mesh mesh = [] {
    const SourceData data = read_data(KNOTFIT_SAMPLES "/face.obj");
    return repair(std::get<Mesh>(data.content), {.fill_holes = true}).mesh;
  }();
  return mesh;
}

MeshMapOptions one_map() {
  MeshMapOptions options;
  options.corners = CornerRule::sharpest;
  options.omega = 0.05;
  return options;
}

void map(benchmark::State& state, bool searched) {
  const MeshMapOptions options = searched ? MeshMapOptions{} : one_map();
  for (auto _ : state) benchmark::DoNotOptimize(parameterize_mesh(face(), options));
}
BENCHMARK_CAPTURE(map, one, false)->Apply(by_both_clocks);
BENCHMARK_CAPTURE(map, searched, true)->Apply(by_both_clocks);

struct Prepared {
  MeshMap map = parameterize_mesh(face(), one_map());
  Mesh mesh = halve_edges(face(), map.halved_edges);
  correction::PreparedMesh at_start{mesh, map.all_uv(), options()};

  CorrectionOptions options() const {
    CorrectionOptions options;
    options.aspect = map.quality.aspect;
    options.data_vertices = face().vertex_count();
    return options;
  }
};

/// 30 rounds at N x N control points; with "measured", the parameters that are left and distances and folds too.
void rounds(benchmark::State& state, bool measured) {
  static const Prepared prepared;
  const KnotVector knots = KnotVector::uniform(3, static_cast<int>(state.range(0)) - 4);
  const Control control;
  for (auto _ : state) {
    correction::CorrectionRun r = prepared.at_start.run(
        prepared.at_start.first(), knots, knots, prepared.at_start.options(), Stage(control, "correction"));
    if (measured) benchmark::DoNotOptimize(prepared.at_start.finish(std::move(r), true, control));
  }
}
BENCHMARK_CAPTURE(rounds, alone, false)->Arg(20)->Arg(40)->Apply(by_both_clocks);
BENCHMARK_CAPTURE(rounds, measured, true)->Arg(20)->Arg(40)->Apply(by_both_clocks);

}  // namespace
}  // namespace knotfit
