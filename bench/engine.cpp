// The parts that every search is made of: fits, the Jacobian in the knots, a Levenberg-Marquardt step, evaluation.
#include <benchmark/benchmark.h>

#include "fit/moving_fit.h"
#include "knotfit/evaluate.h"
#include "knotfit/place.h"
#include "place/levenberg.h"
#include "place/shares.h"
#include "solve/banded_system.h"
#include "support/synthetic.h"
#include "verify/reference_field.h"
namespace knotfit {
namespace {

LeastSquaresOptions searching(bool use_grid = false) {
  LeastSquaresOptions options;
  options.refinement_steps = 0;
  options.estimate_condition = false;
  options.use_grid = use_grid;
  return options;
}

/// Two pairs of knot vectors in turn: a fit at knots it was just made for finds its points in order.
struct InTurn {
  explicit InTurn(int spans) : uniform{uniform_knots(spans - 1), uniform_knots(spans - 1)}, moved(uniform) {
    for (std::vector<double>* k : {&moved.u, &moved.v})
      for (double& x : *k) x += 0.2 / spans * std::sin(7 * x);
  }
  const InteriorKnots& next() { return (odd = !odd) ? moved : uniform; }
  InteriorKnots uniform, moved;
  bool odd = false;
};

void set_counters(benchmark::State& state, const ParameterizedPoints& points) {
  state.SetItemsProcessed(state.iterations() * points.size());
}

/// Assembly, factor, solve and residuals of scattered points. Arguments: points, spans a direction.
void scattered_fit(benchmark::State& state, const char* surface) {
  const ParameterizedPoints points = test::synthetic_points(surface, state.range(0));
  MovingFit problem(points, 3, 3, searching());
  InTurn knots(static_cast<int>(state.range(1)));
  for (auto _ : state) {
    problem.solve(knots.next());
    benchmark::DoNotOptimize(problem.phi());
  }
  set_counters(state, points);
}

void BM_ScatteredFit(benchmark::State& state) {
  scattered_fit(state, "franke");
}

/// Likewise of points in R^3.
void BM_ScatteredFit3d(benchmark::State& state) {
  scattered_fit(state, "torus");
}

/// A full grid, direction by direction. Arguments: lines a direction, spans a direction.
void BM_GridFit(benchmark::State& state) {
  ParameterizedPoints points;
  const Index lines = state.range(0);
  for (Index i = 0; i < lines; ++i)
    for (Index j = 0; j < lines; ++j) {
      const double u = static_cast<double>(i) / static_cast<double>(lines - 1);
      const double v = static_cast<double>(j) / static_cast<double>(lines - 1);
      points.uv.insert(points.uv.end(), {u, v});
      points.values.push_back(test::franke(u, v));
    }
  FitProblem problem(points, 3, 3, searching(true));
  if (!problem.on_grid()) state.SkipWithError("the points are no grid");
  InTurn knots(static_cast<int>(state.range(1)));
  for (auto _ : state) {
    problem.solve(knots.next());
    benchmark::DoNotOptimize(problem.phi());
  }
  set_counters(state, points);
}

/// Kaufman's Jacobian products in all knots, the fit given; third argument 1: the exact one.
void BM_KnotJacobian(benchmark::State& state) {
  const ParameterizedPoints points = test::synthetic_points("franke", state.range(0));
  MovingFit problem(points, 3, 3, searching());
  problem.solve(InTurn(static_cast<int>(state.range(1))).moved);
  for (auto _ : state) benchmark::DoNotOptimize(problem.jacobian(state.range(2) == 1));
  set_counters(state, points);
}

/// One accepted step of the knots: Jacobian, damped normal equations, the fit at the new knots.
void BM_LevenbergStep(benchmark::State& state) {
  const ParameterizedPoints points = test::synthetic_points("franke", state.range(0));
  MovingFit problem(points, 3, 3, searching());
  const InteriorKnots start = InTurn(static_cast<int>(state.range(1))).moved;
  for (auto _ : state) {
    state.PauseTiming();
    problem.solve(start);
    state.ResumeTiming();
    SpacingStep step(problem, start, false);
    step.solve(1e-2, 1.0);
    problem.solve(step.moved(0.005));
    benchmark::DoNotOptimize(problem.phi());
  }
  set_counters(state, points);
}

/// The whole default call at a fixed size.
void BM_PlaceOptimal(benchmark::State& state) {
  const ParameterizedPoints points = test::synthetic_points("franke", state.range(0));
  PlacementOptions options;
  options.interior_u = options.interior_v = static_cast<int>(state.range(1)) - 1;
  for (auto _ : state) benchmark::DoNotOptimize(place_knots("optimal", points, options));
}

/// The surface at many scattered parameters.
void BM_Evaluate(benchmark::State& state) {
  const ParameterizedPoints points = test::synthetic_points("franke", 10000);
  MovingFit problem(points, 3, 3, searching());
  problem.solve(InTurn(20).moved);
  const Surface surface = problem.surface();
  test::Uniform random(7);
  std::vector<double> uv(static_cast<std::size_t>(2 * state.range(0)));
  for (double& x : uv) x = random();
  for (auto _ : state) benchmark::DoNotOptimize(evaluate(surface, uv));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// Local references between the data: what the guard and the honest numbers are made of.
void BM_Reference(benchmark::State& state) {
  const ParameterizedPoints points = test::synthetic_points("franke", 10000);
  const double tolerance = 1e-3 * test::synthetic_diagonal(points);
  const verify::ReferenceField field(points, tolerance, {}, {}, 1);
  test::Uniform random(7);
  std::vector<verify::Place> places(static_cast<std::size_t>(state.range(0)));
  for (verify::Place& place : places) place = {random(), random()};
  for (auto _ : state) benchmark::DoNotOptimize(field.at(places));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

const std::vector<std::vector<std::int64_t>> kSizes = {{10000, 100000}, {8, 20}};
BENCHMARK(BM_ScatteredFit)->ArgsProduct(kSizes)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ScatteredFit3d)->ArgsProduct(kSizes)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(BM_GridFit)
    ->Args({100, 8})
    ->Args({100, 20})
    ->Args({1000, 20})
    ->Args({1000, 200})
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(BM_KnotJacobian)
    ->ArgsProduct({kSizes[0], kSizes[1], {0, 1}})
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(BM_LevenbergStep)->ArgsProduct(kSizes)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(BM_PlaceOptimal)
    ->Args({10000, 8})
    ->Args({10000, 16})
    ->MeasureProcessCPUTime()
    ->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Evaluate)->Arg(1000000)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Reference)->Arg(1000)->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace knotfit
