#include "correct/prepared_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "correct/final_parameters.h"
#include "data/mesh_data.h"
#include "fit/error_measure.h"
#include "knotfit/exceptions.h"
namespace knotfit::correction {
namespace {

void check_range(double x, double low, double high, const char* name) {
  if (!(x >= low && x <= high))
    throw InvalidInput(fmt::format("{} is {}: it must be {} to {}", name, x, low, high));
}

void check(const Mesh& mesh, const std::vector<double>& uv, const CorrectionOptions& options) {
  require_parameters(mesh, uv);
  for (std::size_t k = 0; k < uv.size(); ++k)
    if (!(uv[k] >= 0 && uv[k] <= 1))
      throw InvalidInput(fmt::format("{} of vertex {} is {}: parameters lie in [0,1]", k % 2 == 0 ? "u" : "v",
                                     k / 2, uv[k]));
  for (const double x : mesh.vertices)
    if (!std::isfinite(x)) throw InvalidInput("a coordinate of the mesh is not finite");
  if (mesh.faces.empty()) throw InvalidInput("the mesh has no faces: a correction needs its triangles");
  for (const auto& f : mesh.faces)
    for (const std::int32_t k : f)
      if (k < 0 || k >= mesh.vertex_count())
        throw InvalidInput(
            fmt::format("a face has the corner {}; there are {} vertices", k, mesh.vertex_count()));
  check_range(options.rounds, 0, 100000, "the number of rounds");
  check_range(options.reweighting, 0, 1e6, "the reweighting");
  check_range(options.gradient, 0, 1e6, "the weight of the gradients");
  check_range(options.fairness, 0, 1e6, "the fairness");
  check_range(options.holding, 0, 1e6, "the weight of added vertices");
  check_range(options.smoothing, 0, 1e6, "the smoothing floor");
  check_range(options.aspect, 0, 1e6, "the aspect");
  check_range(options.minimax_rounds, 0, 100000, "the number of minimax rounds");
  check_range(options.keep_by.value, 0, 1e300, "the error that ends the rounds");
  if (row_of(options.keep_by.measure).needs_share)
    check_range(options.keep_by.share, 1e-12, 1, "the share of the points");
  if (options.data_vertices > mesh.vertex_count())
    throw InvalidInput(fmt::format("{} vertices are to be data; the mesh has {}", options.data_vertices,
                                   mesh.vertex_count()));
}

/// Distances of the data vertices, each found from its own parameters.
void measure(CorrectionResult& result, const Mesh& mesh, Index data, const Control& control) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<char> used = data_vertices(mesh);
  std::vector<double> points, start;
  std::vector<Index> vertex;
  for (Index k = 0; k < mesh.vertex_count(); ++k) {
    if (!used[k] || k >= data) continue;
    vertex.push_back(k);
    points.insert(points.end(), mesh.vertex(k), mesh.vertex(k) + 3);
    start.insert(start.end(), &result.uv[2 * k], &result.uv[2 * k] + 2);
  }
  result.signed_distances.assign(static_cast<std::size_t>(mesh.vertex_count()), none);
  result.foot_points.assign(static_cast<std::size_t>(2 * mesh.vertex_count()), none);
  Control quiet;  // cannot be stopped: what is left to do is short
  quiet.progress = control.progress;
  PointDistances d = point_distances(result.surface, points, start, {}, quiet);
  for (std::size_t i = 0; i < vertex.size(); ++i) {
    result.signed_distances[vertex[i]] = d.signed_distances[i];
    std::copy_n(&d.uv[2 * i], 2, &result.foot_points[2 * vertex[i]]);
  }
  result.distance = d.summary;
  result.distance.worst = vertex[d.summary.worst];
}

}  // namespace

PreparedMesh::PreparedMesh(const Mesh& mesh, std::vector<double> uv, const CorrectionOptions& options)
    : mesh_(mesh),
      first_((check(mesh, uv, options), std::move(uv))),
      options_(options),
      frame_(mesh),
      holding_(holding_mesh(mesh, frame_.inside(mesh), first_,
                            options.data_vertices >= 0 ? options.data_vertices : mesh.vertex_count())),
      data_(holding_.own) {
  if (options_.aspect == 0) {
    options_.aspect = measure_map(mesh, first_).aspect;
    if (!(options_.aspect > 0) || !std::isfinite(options_.aspect)) options_.aspect = 1;
  }
  const std::vector<std::int32_t> measured = point_weights(holding_).vertex;
  if (measured.size() < 4 || data_ < 4)
    throw InvalidInput("fewer than 4 vertices are data: there is no surface to fit");
  untangling_ = slides(holding_, options.slide, options.round_corners);
  sliding_.assign(untangling_.size(), Slide::fixed);  // vertices that are no data stay
  for (const std::int32_t k : measured) sliding_[k] = untangling_[k];
}

CorrectionRun PreparedMesh::run(std::vector<double> uv, const KnotVector& knots_u, const KnotVector& knots_v,
                                const CorrectionOptions& options, const Stage& stage, bool keep_start) const {
  HoldingMesh mesh = holding_;
  mesh.uv = std::move(uv);
  return run_correction(std::move(mesh), knots_u, knots_v, options, stage, keep_start);
}

std::optional<KnotJacobian> PreparedMesh::knots(std::vector<double> uv, const Surface& surface) const {
  HoldingMesh mesh = holding_;
  mesh.uv = std::move(uv);
  return knot_jacobian(std::move(mesh), surface, options_);
}

double PreparedMesh::error(const CorrectionResult& result, const Tolerance& tolerance) const {
  std::vector<double> distances;
  for (const double d : result.signed_distances)
    if (!std::isnan(d)) distances.push_back(std::abs(d) / frame_.scale());
  return distances.empty() ? INFINITY : measured_error(distances, tolerance);
}

void keep_first(Index vertices, CorrectionResult& result) {
  const auto cut = [&](std::vector<double>& x, Index width) {
    if (!x.empty()) x.resize(static_cast<std::size_t>(width * vertices));
  };
  cut(result.uv, 2);
  cut(result.foot_points, 2);
  cut(result.signed_distances, 1);
}

CorrectionResult PreparedMesh::finish(CorrectionRun run, bool from_first_fit, const Control& control) const {
  CorrectionResult result;
  result.rounds = std::move(run.rounds);
  result.best_round = run.best;
  if (!run.surface) {
    result.status = CorrectionStatus::singular;
    result.uv = first_;
    return result;
  }
  result.status = run.stopped                            ? CorrectionStatus::stopped
                  : run.best == 0 && options_.rounds > 0 ? CorrectionStatus::no_gain
                                                         : CorrectionStatus::corrected;
  result.surface = frame_.outside(*run.surface);
  // Takes the first parameters. Takes others where fewer triangles are turned over, and the surface does not fold over
  // or folds no more.
  const auto take = [&](std::vector<double> uv) {
    FoldReport folds = measure_folds(result.surface, mesh_, uv);
    if (!result.uv.empty() && (folds.flipped >= result.folds.flipped ||
                               (folds_over(folds) && folds.blurred > result.folds.blurred)))
      return;
    result.uv = std::move(uv);
    result.folds = std::move(folds);
  };
  if (from_first_fit && run.best == 0) {
    take(first_);
  } else {
    // Begins with the rounds' own parameters, which turn hardly a triangle over; where some stay turned, with the map too.
    const std::vector<Vec3> position = frame_.inside(mesh_);
    const auto ended_at = [&](std::vector<double> from) {
      return final_parameters(mesh_.faces, position, sliding_, std::move(from), run.uv, *run.surface);
    };
    std::vector<double> near = run.uv;
    untangle(mesh_.faces, untangling_, first_, near);
    take(ended_at(std::move(near)));
    if (result.folds.flipped > 0) take(ended_at(first_));
  }
  measure(result, mesh_, data_, control);
  std::vector<double> nearer = result.uv;
  if (approach_feet(mesh_.faces, vertex_places(mesh_), sliding_, result.foot_points, result.signed_distances,
                    result.surface, nearer) > 0) {
    FoldReport folds = measure_folds(result.surface, mesh_, nearer);
    if (folds.flipped <= result.folds.flipped && (!folds_over(folds) || folds_over(result.folds))) {
      result.uv = std::move(nearer);
      result.folds = std::move(folds);
    }
  }
  return result;
}

}  // namespace knotfit::correction
