#include "knotfit/correct.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "correct/final_parameters.h"
#include "correct/rounds.h"
#include "knotfit/errors.h"
namespace knotfit {
namespace {

using namespace correction;

void check_knots(const KnotVector& knots, const char* name) {
  if (!knots.is_clamped() || knots.first() != 0 || knots.last() != 1)
    throw InvalidInput(fmt::format("the knots in {} must be clamped on [0,1] for a correction", name));
}

void check_range(double x, double low, double high, const char* name) {
  if (!(x >= low && x <= high))
    throw InvalidInput(fmt::format("{} is {}: it must be {} to {}", name, x, low, high));
}

void check(const Mesh& mesh, const std::vector<double>& uv, const KnotVector& knots_u,
           const KnotVector& knots_v, const CorrectionOptions& options) {
  if (static_cast<Index>(uv.size()) != 2 * mesh.vertex_count())
    throw InvalidInput(fmt::format("{} vertices need {} parameters, u and v each; there are {}",
                                   mesh.vertex_count(), 2 * mesh.vertex_count(), uv.size()));
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
  check_knots(knots_u, "u");
  check_knots(knots_v, "v");
  check_range(options.rounds, 0, 100000, "the number of rounds");
  check_range(options.reweighting, 0, 1e6, "the reweighting");
  check_range(options.gradient, 0, 1e6, "the weight of the gradients");
  check_range(options.holding, 0, 1e6, "the weight of added vertices");
  check_range(options.smoothing, 0, 1e6, "the smoothing floor");
  check_range(options.aspect, 0, 1e6, "the aspect");
  if (options.data_vertices > mesh.vertex_count())
    throw InvalidInput(fmt::format("{} vertices are to be data; the mesh has {}", options.data_vertices,
                                   mesh.vertex_count()));
  if (options.start && (options.start->dimension() != 3 || options.start->knots_u() != knots_u ||
                        options.start->knots_v() != knots_v))
    throw InvalidInput("the surface to start from is over other knots");
}

/// x -> (x - centre) / diagonal.
struct CorrectionFrame {
  Vec3 centre;
  double diagonal = 1;
  explicit CorrectionFrame(const Mesh& mesh) {
    Vec3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
    for (const auto& f : mesh.faces)
      for (const std::int32_t k : f) {
        const double* p = mesh.vertex(k);
        low = {std::min(low.x, p[0]), std::min(low.y, p[1]), std::min(low.z, p[2])};
        high = {std::max(high.x, p[0]), std::max(high.y, p[1]), std::max(high.z, p[2])};
      }
    centre = 0.5 * low + 0.5 * high;
    diagonal = length(high - low);
    if (!(diagonal > 0) || !std::isfinite(diagonal))
      throw InvalidInput(
          "all vertices of the mesh are at one place, or too far apart: there is no surface to fit");
  }
  std::vector<Vec3> inside(const Mesh& mesh) const {
    std::vector<Vec3> p;
    for (Index k = 0; k < mesh.vertex_count(); ++k)
      p.push_back((1 / diagonal) * (at(mesh.vertex(k)) - centre));
    return p;
  }
  Surface map(const Surface& s, bool out) const {
    std::vector<double> net = s.net();
    const double c[3] = {centre.x, centre.y, centre.z};
    for (std::size_t i = 0; i < net.size(); ++i)
      net[i] = out ? net[i] * diagonal + c[i % 3] : (net[i] - c[i % 3]) / diagonal;
    return Surface(s.knots_u(), s.knots_v(), 3, std::move(net));
  }
};

/// Distances of the data vertices, each found from its own parameters.
void measure(CorrectionResult& result, const Mesh& mesh, Index data, const Control& control) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<char> used(static_cast<std::size_t>(mesh.vertex_count()), 0);
  for (Index f = 0; f < mesh.face_count(); ++f)
    if (mesh.virtual_face.empty() || !mesh.virtual_face[f])
      for (const std::int32_t k : mesh.faces[f]) used[k] = k < data;
  std::vector<double> points, start;
  std::vector<Index> vertex;
  for (Index k = 0; k < mesh.vertex_count(); ++k) {
    if (!used[k]) continue;
    vertex.push_back(k);
    points.insert(points.end(), mesh.vertex(k), mesh.vertex(k) + 3);
    start.insert(start.end(), &result.uv[2 * k], &result.uv[2 * k] + 2);
  }
  result.signed_distances.assign(static_cast<std::size_t>(mesh.vertex_count()), none);
  result.foot_points.assign(static_cast<std::size_t>(2 * mesh.vertex_count()), none);
  Control quiet;  // what is left to do is short; the rounds are what a stop cuts
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

CorrectionResult correct_parameters(const Mesh& mesh, const std::vector<double>& uv,
                                    const KnotVector& knots_u, const KnotVector& knots_v,
                                    const CorrectionOptions& given, const Control& control) {
  check(mesh, uv, knots_u, knots_v, given);
  CorrectionOptions options = given;
  if (options.aspect == 0) {
    options.aspect = measure_map(mesh, uv).aspect;
    if (!(options.aspect > 0) || !std::isfinite(options.aspect)) options.aspect = 1;
  }
  const Index data = options.data_vertices >= 0 ? options.data_vertices : mesh.vertex_count();
  const CorrectionFrame frame(mesh);
  if (options.start) options.start = frame.map(*options.start, false);
  HoldingMesh holding = holding_mesh(mesh, frame.inside(mesh), uv, data);
  if (point_weights(holding).vertex.size() < 4 || data < 4)
    throw InvalidInput("fewer than 4 vertices are data: there is no surface to fit");
  std::vector<Slide> sliding = slides(holding, options.slide, options.round_corners);
  std::vector<char> measured(sliding.size(), 0);
  for (const std::int32_t k : point_weights(holding).vertex) measured[k] = 1;
  for (std::size_t k = 0; k < sliding.size(); ++k)
    if (!measured[k]) sliding[k] = Slide::fixed;  // in the middle of a hole

  CorrectionResult result;
  const Watch watch(control, "correction");
  Rounds rounds = run_rounds(std::move(holding), knots_u, knots_v, options, watch);
  result.rounds = std::move(rounds.rounds);
  result.best_round = rounds.best;
  if (!rounds.surface) {
    result.status = CorrectionStatus::singular;
    result.uv = uv;
    return result;
  }
  result.status = rounds.stopped                           ? CorrectionStatus::stopped
                  : rounds.best == 0 && options.rounds > 0 ? CorrectionStatus::no_gain
                                                           : CorrectionStatus::corrected;
  result.surface = frame.map(*rounds.surface, true);
  result.uv = rounds.best == 0 && !options.start
                  ? uv
                  : final_parameters(mesh.faces, frame.inside(mesh), sliding, uv, std::move(rounds.uv),
                                     *rounds.surface);
  measure(result, mesh, data, control);
  result.folds = measure_folds(result.surface, mesh, result.uv);
  return result;
}

CorrectionResult correct_parameters(const Mesh& mesh, const MeshMap& map, const KnotVector& knots_u,
                                    const KnotVector& knots_v, const CorrectionOptions& given,
                                    const Control& control) {
  CorrectionOptions options = given;
  if (options.aspect == 0) options.aspect = map.quality.aspect;
  if (options.data_vertices < 0) options.data_vertices = mesh.vertex_count();
  std::vector<double> uv = map.uv;
  uv.insert(uv.end(), map.halved_uv.begin(), map.halved_uv.end());
  CorrectionResult result =
      correct_parameters(halve_edges(mesh, map.halved_edges), uv, knots_u, knots_v, options, control);
  for (std::vector<double>* x : {&result.uv, &result.foot_points})
    if (!x->empty()) x->resize(static_cast<std::size_t>(2 * mesh.vertex_count()));
  if (!result.signed_distances.empty())
    result.signed_distances.resize(static_cast<std::size_t>(mesh.vertex_count()));
  return result;
}

}  // namespace knotfit
