#include "knotfit/distance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "base/quantile.h"
#include "base/stage.h"
#include "data/mesh_data.h"
#include "knotfit/closest_point.h"
#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "nearest/largest_distance.h"
#include "nearest/map_samples.h"
#include "nearest/triangle_tree.h"
namespace knotfit {
namespace {

struct Sums {
  double square = 0, value = 0, sign = 0;
  Sums& operator+=(const Sums& o) {
    square += o.square, value += o.value, sign += o.sign;
    return *this;
  }
};

/// Leaves out the place of the worst.
DistanceSummary summarize(const std::vector<double>& distances) {
  DistanceSummary s;
  s.count = static_cast<Index>(distances.size());
  const Sums sums = parallel_sum<Sums>(s.count, [&](Index begin, Index end) {
    Sums part;
    for (Index k = begin; k < end; ++k) {
      const double d = std::abs(distances[k]);
      part += {d * d, d, distances[k]};
    }
    return part;
  });
  const auto n = static_cast<double>(s.count);
  s.rms = std::sqrt(sums.square / n);
  s.mean = sums.value / n;
  s.signed_mean = sums.sign / n;
  const Sums about = parallel_sum<Sums>(s.count, [&](Index begin, Index end) {
    Sums part;
    for (Index k = begin; k < end; ++k) part.square += std::pow(distances[k] - s.signed_mean, 2);
    return part;
  });
  s.deviation = std::sqrt(about.square / n);
  std::vector<double> sorted(distances.size());
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    sorted[k] = std::abs(distances[k]);
    if (s.worst < 0 || sorted[k] > std::abs(distances[s.worst])) s.worst = static_cast<Index>(k);
  }
  std::sort(sorted.begin(), sorted.end());
  s.max = sorted.back();
  const auto quantile = [&](double share) { return sorted[quantile_position(sorted.size(), share)]; };
  s.median = quantile(0.5);
  s.p95 = quantile(0.95);
  s.p99 = quantile(0.99);
  s.p995 = quantile(0.995);
  return s;
}

}  // namespace

PointDistances point_distances(const Surface& surface, std::span<const double> points,
                               std::span<const double> start, std::span<const double> normals,
                               const Control& control) {
  if (points.empty()) throw InvalidInput("there are no points to measure distances from");
  if (!normals.empty() && normals.size() != points.size())
    throw InvalidInput(fmt::format("{} points have {} numbers for normals: three each, or none",
                                   points.size() / 3, normals.size()));
  ClosestPoints closest = closest_points(surface, points, start, control);
  PointDistances result;
  result.stopped = closest.stopped;
  if (closest.stopped) return result;
  const Index n = static_cast<Index>(points.size() / 3);
  const CellPolynomials cells(surface);
  result.signed_distances = closest.distances;
  parallel_chunks(n, [&](Index, Index begin, Index end) {
    for (Index k = begin; k < end; ++k) {
      const Jet j = cells.jet(closest.uv[2 * k], closest.uv[2 * k + 1]);
      const Vec3 normal = normals.empty() ? cross(j.u, j.v) : at(&normals[3 * k]);
      if (dot(at(&points[3 * k]) - at(&closest.points[3 * k]), normal) < 0) result.signed_distances[k] *= -1;
    }
  });
  result.summary = summarize(result.signed_distances);
  DistanceSummary& s = result.summary;
  s.worst_u = closest.uv[2 * s.worst];
  s.worst_v = closest.uv[2 * s.worst + 1];
  std::copy_n(&points[3 * s.worst], 3, s.worst_point);
  result.uv = std::move(closest.uv);
  return result;
}

double share_within(const PointDistances& distances, double e) {
  Index within = 0;
  for (const double d : distances.signed_distances) within += std::abs(d) <= e;
  return distances.signed_distances.empty()
             ? 0
             : static_cast<double>(within) / static_cast<double>(distances.signed_distances.size());
}

DistanceSummary mesh_distances(const Surface& surface, const Mesh& mesh, std::span<const double> uv,
                               int samples, const Control& control) {
  if (surface.empty() || surface.dimension() != 3)
    throw InvalidInput(
        "distances to a mesh are of surfaces in space; height_field_in_space makes one of heights");
  if (mesh.faces.empty()) throw InvalidInput("the mesh has no faces to measure distances to");
  if (samples < 1)
    throw InvalidInput(fmt::format("{} samples: there must be at least 1 a direction", samples));
  if (!uv.empty()) require_parameters(mesh, uv);
  const SpanTable tu(surface.knots_u()), tv(surface.knots_v());
  const auto per = [&](const SpanTable& t) {
    return std::max(4, static_cast<int>(std::lround(samples / static_cast<double>(t.spans()))));
  };
  const std::vector<double> u = centred_places(tu, per(tu)), v = centred_places(tv, per(tv));
  const Index nu = static_cast<Index>(u.size()), nv = static_cast<Index>(v.size());
  // Triangles that close holes are no data: no distance is to them, and none is measured over them.
  std::vector<std::array<std::int32_t, 3>> faces;
  for (Index f = 0; f < mesh.face_count(); ++f)
    if (is_data(mesh, f)) faces.push_back(mesh.faces[f]);
  if (faces.empty()) throw InvalidInput("every face of the mesh only closes a hole: there is no data");
  std::vector<std::int32_t> over;
  if (!uv.empty()) over = sample_map({vertex_places(mesh), faces, {}, uv}, u, v).face;
  const TriangleTree tree(mesh.vertices, faces);
  std::vector<double> distances(static_cast<std::size_t>(nu * nv), -1.0);
  std::vector<double> places(static_cast<std::size_t>(3 * nu * nv));
  Stage stage(control, "distance to the mesh");
  const Index turn = 16;
  for (Index from = 0; from < nu; from += turn) {
    if (stage.report(static_cast<double>(from) / static_cast<double>(nu))) return {};
    const Index count = std::min(turn, nu - from);
    const std::vector<double> points = evaluate_grid(surface, std::span(u).subspan(from, count), v);
    std::copy(points.begin(), points.end(), places.begin() + from * nv * 3);
    parallel_for(count, [&](Index i) {
      Index hint = -1;
      for (Index j = 0; j < nv; ++j) {
        const Index q = (from + i) * nv + j;
        if (!over.empty() && over[q] < 0) continue;
        const TriangleHit hit = tree.nearest(at(&points[(i * nv + j) * 3]), hint);
        distances[q] = std::sqrt(hit.squared);
        hint = hit.face;
      }
    });
  }
  std::vector<Index> kept;
  std::vector<double> measured;
  for (Index q = 0; q < nu * nv; ++q)
    if (distances[q] >= 0) kept.push_back(q), measured.push_back(distances[q]);
  if (measured.empty())
    throw InvalidInput("the mesh covers no part of the surface's parameters: are these its own?");
  DistanceSummary s = summarize(measured);
  s.worst = kept[s.worst];
  const LargestDistance largest = largest_distance(surface, tree, {u, v, distances, places}, control);
  if (largest.stopped) return {};
  s.max = largest.distance;
  s.worst_u = largest.u;
  s.worst_v = largest.v;
  std::copy_n(largest.point, 3, s.worst_point);
  return s;
}

}  // namespace knotfit
