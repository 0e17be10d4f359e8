#include "knotfit/folds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "data/mesh_data.h"
#include "data/orientation.h"
#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "nearest/map_samples.h"
namespace knotfit {
namespace {

constexpr int kPerSpan = 8, kReach = 4;

void check(const Surface& surface, const Mesh& mesh, std::span<const double> uv) {
  if (surface.empty()) throw InvalidInput("the surface is empty: it cannot fold");
  if (surface.dimension() != 3)
    throw InvalidInput(fmt::format("folds are of surfaces in space; this one has {} coordinate{}",
                                   surface.dimension(), surface.dimension() == 1 ? "" : "s"));
  require_parameters(mesh, uv);
  for (std::size_t k = 0; k < uv.size(); ++k)
    if (!std::isfinite(uv[k]))
      throw InvalidInput(fmt::format("the parameters of vertex {} are not finite", k / 2));
}

/// The connected sets of folded samples, the largest first.
std::vector<FoldPlace> places(const MapSamples& grid, const std::vector<char>& folded,
                              const std::vector<double>& turned, const std::vector<double>& weight,
                              const Surface& surface) {
  const Index nu = static_cast<Index>(grid.u.size()), nv = static_cast<Index>(grid.v.size());
  std::vector<char> seen(folded.size(), 0);
  std::vector<FoldPlace> result;
  for (Index first = 0; first < nu * nv; ++first) {
    if (!folded[first] || seen[first]) continue;
    std::vector<Index> stack{first};
    seen[first] = 1;
    FoldPlace place;
    Index deepest = first;
    while (!stack.empty()) {
      const Index q = stack.back(), i = q / nv, j = q % nv;
      stack.pop_back();
      place.share += weight[q];
      if (turned[q] < turned[deepest] || (turned[q] == turned[deepest] && q < deepest)) deepest = q;
      for (Index a = std::max<Index>(0, i - 1); a <= std::min(nu - 1, i + 1); ++a)
        for (Index b = std::max<Index>(0, j - 1); b <= std::min(nv - 1, j + 1); ++b)
          if (folded[a * nv + b] && !seen[a * nv + b]) {
            seen[a * nv + b] = 1;
            stack.push_back(a * nv + b);
          }
    }
    place.u = grid.u[deepest / nv];
    place.v = grid.v[deepest % nv];
    evaluate(surface, place.u, place.v, place.point);
    result.push_back(place);
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const FoldPlace& a, const FoldPlace& b) { return a.share > b.share; });
  return result;
}

/// 1 for triangles that agree with those around them: the normals at their corners have a mean longer than 0.8, and theirs
/// is within 45 degrees of it.
std::vector<char> agreeing_faces(const MapView& map) {
  constexpr double least_length = 0.8, least_cosine = 0.7071;
  std::vector<Vec3> normal(map.faces.size()), sum(map.vertices.size());
  std::vector<int> count(map.vertices.size(), 0);
  for (std::size_t f = 0; f < map.faces.size(); ++f) {
    const auto face = static_cast<std::int32_t>(f);
    normal[f] = map.normal(face);
    if (map.is_data(face))
      for (const std::int32_t k : map.faces[f]) sum[k] += normal[f], ++count[k];
  }
  std::vector<char> agree(map.faces.size(), 0);
  for (std::size_t f = 0; f < agree.size(); ++f) {
    Vec3 all;
    int n = 0;
    for (const std::int32_t k : map.faces[f]) all += sum[k], n += count[k];
    if (n == 0) continue;
    const double mean = length(all) / n;
    agree[f] = mean > least_length && dot(normal[f], unit(all)) > least_cosine;
  }
  return agree;
}

}  // namespace

FoldReport measure_folds(const Surface& surface, const Mesh& mesh, std::span<const double> uv) {
  check(surface, mesh, uv);
  FoldReport report;
  report.flipped = count_flipped(mesh.faces, uv);
  const std::vector<Vec3> vertices = vertex_places(mesh);
  const MapView map{vertices, mesh.faces, mesh.virtual_face, uv};
  const CellPolynomials cells(surface);
  const MapSamples grid =
      sample_map(map, centred_places(cells.u(), kPerSpan), centred_places(cells.v(), kPerSpan));
  const Index nu = static_cast<Index>(grid.u.size()), nv = static_cast<Index>(grid.v.size()), n = nu * nv;
  std::vector<char> use(static_cast<std::size_t>(n), 0);
  std::vector<double> normals(static_cast<std::size_t>(3 * n), 0.0), weight(static_cast<std::size_t>(n), 0.0);
  std::vector<Vec3> own(static_cast<std::size_t>(n));
  std::vector<double> area(static_cast<std::size_t>(n)), sine(static_cast<std::size_t>(n));
  parallel_for(nu, [&](Index i) {
    for (Index j = 0; j < nv; ++j) {
      const Index q = i * nv + j;
      const std::int32_t f = grid.face[q];
      const double share =
          cells.u().length(i / kPerSpan) * cells.v().length(j / kPerSpan) / (kPerSpan * kPerSpan);
      const Jet jet = cells.jet(grid.u[i], grid.v[j]);
      own[q] = cross(jet.u, jet.v);
      area[q] = length(own[q]);
      const double sides = length(jet.u) * length(jet.v);
      sine[q] = sides > 0 ? area[q] / sides : 0;
      weight[q] = share;
      if (f < 0 || !map.is_data(f)) continue;
      use[q] = 1;
      const Vec3 normal = map.normal(f);
      normals[3 * q] = normal.x, normals[3 * q + 1] = normal.y, normals[3 * q + 2] = normal.z;
    }
  });
  const std::vector<char> agree = agreeing_faces(map);
  const std::vector<double> means = window_means(normals, 3, use, nu, nv, kReach);
  double all = 0, covered = 0, area_sum = 0;
  for (Index q = 0; q < n; ++q) {
    all += weight[q];
    if (use[q]) covered += weight[q], area_sum += weight[q] * area[q];
  }
  if (!(covered > 0))
    throw InvalidInput("the mesh covers no part of the surface's parameters: are these its own?");
  report.covered = covered / all;
  const double mean_area = area_sum / covered;
  std::vector<char> folded(static_cast<std::size_t>(n), 0);
  std::vector<double> turned(static_cast<std::size_t>(n), 0.0);
  double angles = 0;
  report.least_area = report.least_sine = INFINITY;
  for (Index q = 0; q < n; ++q) {
    if (!use[q]) continue;
    const double w = weight[q] /= covered;
    const Vec3 normal = unit(own[q]), mean = at(&means[3 * q]);
    turned[q] = dot(normal, mean);
    const double angle = std::acos(std::clamp(dot(normal, unit(mean)), -1.0, 1.0));
    angles += w * angle * angle;
    folded[q] = turned[q] < 0;
    if (folded[q]) report.blurred += w;
    if (dot(own[q], at(&normals[3 * q])) < 0) {
      report.raw += w;
      if (agree[grid.face[q]] != 0) report.pleats += w;
    }
    const double relative = mean_area > 0 ? area[q] / mean_area : 0;
    report.least_area = std::min(report.least_area, relative);
    report.least_sine = std::min(report.least_sine, sine[q]);
    if (relative < 0.05) report.small_area += w;
    if (sine[q] < 0.05) report.small_sine += w;
  }
  report.normal_angle = std::sqrt(angles) * 180 / std::numbers::pi;
  report.places = places(grid, folded, turned, weight, surface);
  return report;
}

}  // namespace knotfit
