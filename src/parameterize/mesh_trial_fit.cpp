#include "parameterize/mesh_trial_fit.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fit/fit_problem.h"
#include "knotfit/evaluate.h"
namespace knotfit::mesh_map {
namespace {

// Own vertices at faces that are not virtual, and the edges between them, numbered among these.
struct Measured {
  ParameterizedPoints points;
  std::vector<std::array<Index, 2>> edges;
};

Measured measured_vertices(const DiskMesh& disk, std::span<const double> uv) {
  std::vector<Index> number(disk.position.size(), -1);
  for (int f = 0; f < disk.face_count(); ++f)
    if (!disk.virtual_face[f])
      for (const int i : disk.face[f]) number[i] = 0;
  Measured measured;
  ParameterizedPoints& points = measured.points;
  points.dimension = 3;
  for (Index i = 0; i < disk.own; ++i) {
    if (number[i] < 0) continue;
    number[i] = points.size();
    points.uv.insert(points.uv.end(), {uv[2 * i], uv[2 * i + 1]});
    points.values.insert(points.values.end(), disk.position[i].begin(), disk.position[i].end());
  }
  for (const auto& [a, b] : disk.edge)
    if (a < disk.own && b < disk.own && number[a] >= 0 && number[b] >= 0)
      measured.edges.push_back({number[a], number[b]});
  return measured;
}

// Gauss-Newton step of the foot point in the tangent plane; a coordinate that would leave the square
// stays on its edge. r = S - P.
std::array<double, 2> tangent_step(const double* r, const double* su, const double* sv, const double* uv) {
  double uu = 0, cross = 0, vv = 0, gu = 0, gv = 0;
  for (int c = 0; c < 3; ++c) {
    uu += su[c] * su[c], cross += su[c] * sv[c], vv += sv[c] * sv[c];
    gu += su[c] * r[c], gv += sv[c] * r[c];
  }
  const bool stay_u = (uv[0] <= 0 && gu > 0) || (uv[0] >= 1 && gu < 0);
  const bool stay_v = (uv[1] <= 0 && gv > 0) || (uv[1] >= 1 && gv < 0);
  const double determinant = uu * vv - cross * cross;
  if (stay_u || stay_v || !(determinant > 1e-12 * uu * vv))
    return {stay_u || !(uu > 0) ? 0.0 : -gu / uu, stay_v || stay_u == stay_v || !(vv > 0) ? 0.0 : -gv / vv};
  return {-(vv * gu - cross * gv) / determinant, -(uu * gv - cross * gu) / determinant};
}

double squared_distance(const double* a, const double* b) {
  const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return x * x + y * y + z * z;
}

// Foot points from the points' own parameters; where a neighbour's is nearer they go on from there.
double rms_distance(const Surface& surface, const Measured& measured) {
  constexpr int rounds = 15, between_exchanges = 4;
  const ParameterizedPoints& points = measured.points;
  const Index n = points.size();
  std::vector<double> foot = points.uv, trial = foot, on_surface(points.values.size());
  std::vector<double> squared(static_cast<std::size_t>(n), std::numeric_limits<double>::infinity());
  std::vector<double> step(foot.size(), 0);
  for (int round = 1; round <= rounds; ++round) {
    const std::vector<double> s = evaluate(surface, trial), su = evaluate(surface, trial, 1, 0),
                              sv = evaluate(surface, trial, 0, 1);
    for (Index k = 0; k < n; ++k) {
      const double d = squared_distance(&s[3 * k], points.value(k));
      double r[3];
      for (int c = 0; c < 3; ++c) r[c] = s[3 * k + c] - points.value(k)[c];
      if (d < squared[k]) {
        squared[k] = d;
        std::copy_n(&trial[2 * k], 2, &foot[2 * k]);
        std::copy_n(&s[3 * k], 3, &on_surface[3 * k]);
        const auto [u, v] = tangent_step(r, &su[3 * k], &sv[3 * k], &foot[2 * k]);
        step[2 * k] = u;
        step[2 * k + 1] = v;
      } else {
        step[2 * k] *= 0.3;
        step[2 * k + 1] *= 0.3;
      }
      for (Index c = 2 * k; c < 2 * k + 2; ++c) trial[c] = std::clamp(foot[c] + step[c], 0.0, 1.0);
    }
    if (round % between_exchanges != 0) continue;
    std::vector<double> nearest = squared;
    for (const auto& edge : measured.edges)
      for (const int way : {0, 1}) {
        const Index from = edge[way], to = edge[1 - way];
        const double d = squared_distance(&on_surface[3 * from], points.value(to));
        if (d >= nearest[to]) continue;
        nearest[to] = d;
        std::copy_n(&foot[2 * from], 2, &trial[2 * to]);
      }
  }
  double sum = 0;
  for (const double d : squared) sum += d;
  return std::sqrt(sum / static_cast<double>(n));
}

}  // namespace

TrialFit trial_fit(const DiskMesh& disk, std::span<const double> uv) {
  constexpr int degree = 3;
  constexpr Index most = 20;
  const Measured measured = measured_vertices(disk, uv);
  const ParameterizedPoints& points = measured.points;
  const auto fitting = static_cast<Index>(std::sqrt(static_cast<double>(points.size()) / 2));
  const Index spans = std::clamp(fitting, Index{degree + 1}, most) - degree;
  InteriorKnots knots;
  for (Index k = 1; k < spans; ++k) knots.u.push_back(static_cast<double>(k) / static_cast<double>(spans));
  knots.v = knots.u;
  LeastSquaresOptions options;
  options.refinement_steps = 0;
  options.estimate_condition = false;
  options.use_grid = false;
  FitProblem problem(points, degree, degree, options);
  if (!problem.solve(knots)) {
    constexpr double none = std::numeric_limits<double>::infinity();
    return {none, none};
  }
  return {problem.rms(), rms_distance(problem.surface(), measured)};
}

}  // namespace knotfit::mesh_map
