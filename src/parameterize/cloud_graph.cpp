#include "parameterize/cloud_graph.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "base/parallel.h"
#include "data/mesh_topology.h"
#include "knotfit/exceptions.h"
#include "knotfit/remedy.h"
#include "parameterize/cloud_gaps.h"
#include "parameterize/delaunay.h"
namespace knotfit::cloud {
namespace {

using Corners = std::array<std::int32_t, 3>;

constexpr double kLeastShare = 0.9;  // of the points, in one piece
constexpr double kFlat =
    -0.99;  // cosine: 172 degrees opposite the rim; rounding and kMove leave 175 on a straight one
constexpr double kMove = 0.02;  // of the distance to the nearest neighbour

/// The points, each moved by up to 2 % of the distance to its nearest neighbour, by its number alone. On a regular grid four
/// points lie on a circle, and the triangulations around them, each in a plane of its own, would choose its diagonal at
/// random.
std::vector<double> apart_from_ties(std::span<const double> points, const NeighbourLists& near) {
  std::vector<double> moved(points.begin(), points.end());
  for (std::size_t k = 0; 3 * k < moved.size(); ++k) {
    double nearest = 0;
    for (std::size_t i = 0, count = static_cast<std::size_t>(near.count); i < count && !(nearest > 0); ++i)
      nearest = std::sqrt(near.squared[k * count + i]);
    for (std::size_t c = 0; c < 3; ++c) {
      // splitmix64 [Steele14]
      std::uint64_t x = (3 * k + c + 1) * 0x9e3779b97f4a7c15;
      x = (x ^ x >> 30) * 0xbf58476d1ce4e5b9;
      x = (x ^ x >> 27) * 0x94d049bb133111eb;
      moved[3 * k + c] += kMove * nearest * (std::ldexp(static_cast<double>((x ^ x >> 31) >> 11), -52) - 1);
    }
  }
  return moved;
}

/// Pairs of neighbours of point k between which its own triangulation has a triangle with k, counter-clockwise.
std::vector<std::array<std::int32_t, 2>> star(std::span<const double> points, Index k,
                                              const NeighbourLists& near,
                                              const std::vector<Vector>& normals) {
  const Vector& n = normals[k];
  const auto [a, b] = frame_of(n);
  std::vector<std::int32_t> number{static_cast<std::int32_t>(k)};
  std::vector<double> flat{0, 0};
  double reach = 0;
  for (int i = 0; i < near.count; ++i) {
    const std::uint32_t j = near.of(k)[i];
    if (!(dot(n, normals[j]) > 0)) continue;
    const Vector d{points[3 * j] - points[3 * k], points[3 * j + 1] - points[3 * k + 1],
                   points[3 * j + 2] - points[3 * k + 2]};
    number.push_back(static_cast<std::int32_t>(j));
    flat.push_back(dot(d, a)), flat.push_back(dot(d, b));
    reach = std::max({reach, std::abs(flat[flat.size() - 2]), std::abs(flat.back())});
  }
  std::vector<std::array<std::int32_t, 2>> pairs;
  if (!(reach > 0)) return pairs;
  std::vector<Place> places;
  const double scale = std::ldexp(1, kGridBits - 1) / reach;
  for (std::size_t i = 0; i < number.size(); ++i)
    places.push_back(
        {std::llround((flat[2 * i] + reach) * scale), std::llround((flat[2 * i + 1] + reach) * scale)});
  for (const Corners& t : delaunay(places).triangle)
    for (int c = 0; c < 3; ++c)
      if (t[c] == 0) pairs.push_back({number[t[(c + 1) % 3]], number[t[(c + 2) % 3]]});
  return pairs;
}

struct Candidate {
  Corners corners;     ///< the least first
  int votes = 0;       ///< of its corners
  double longest = 0;  ///< squared
};

std::vector<Candidate> candidates(std::span<const double> points, const NeighbourLists& near,
                                  const std::vector<Vector>& normals) {
  const auto n = static_cast<Index>(normals.size());
  std::vector<std::vector<std::array<std::int32_t, 2>>> stars(static_cast<std::size_t>(n));
  const std::vector<double> moved = apart_from_ties(points, near);
  parallel_for(n, [&](Index k) { stars[k] = star(moved, k, near, normals); });
  std::vector<Corners> all;
  for (Index k = 0; k < n; ++k)
    for (const auto& [i, j] : stars[k]) {
      Corners t{static_cast<std::int32_t>(k), i, j};
      std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
      all.push_back(t);
    }
  std::sort(all.begin(), all.end());
  std::vector<Candidate> result;
  for (std::size_t k = 0; k < all.size();) {
    std::size_t end = k + 1;
    while (end < all.size() && all[end] == all[k]) ++end;
    Candidate c{all[k], static_cast<int>(end - k), 0};
    for (int side = 0; side < 3; ++side) {
      double d = 0;
      for (int x = 0; x < 3; ++x)
        d += std::pow(points[3 * c.corners[side] + x] - points[3 * c.corners[(side + 1) % 3] + x], 2);
      c.longest = std::max(c.longest, d);
    }
    result.push_back(c);
    k = end;
  }
  std::sort(result.begin(), result.end(), [](const Candidate& a, const Candidate& b) {
    if (a.votes != b.votes) return a.votes > b.votes;
    return a.longest != b.longest ? a.longest < b.longest : a.corners < b.corners;
  });
  return result;
}

/// Triangles around every vertex as fans that share edges: all but the largest fan of each go.
bool keep_one_fan(std::vector<Corners>& faces, Index vertices) {
  std::vector<std::vector<std::int32_t>> around(static_cast<std::size_t>(vertices));
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (const std::int32_t k : faces[f]) around[k].push_back(static_cast<std::int32_t>(f));
  std::vector<char> gone(faces.size(), 0);
  for (Index k = 0; k < vertices; ++k) {
    const std::vector<std::int32_t>& mine = around[k];
    if (mine.size() < 2) continue;
    std::vector<int> fan(mine.size());
    for (std::size_t i = 0; i < mine.size(); ++i) fan[i] = static_cast<int>(i);
    const auto others = [&](std::int32_t f) {
      const Corners& t = faces[f];
      const int c = t[0] == k ? 0 : t[1] == k ? 1 : 2;
      return std::array{t[(c + 1) % 3], t[(c + 2) % 3]};
    };
    for (std::size_t i = 0; i < mine.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const auto a = others(mine[i]), b = others(mine[j]);
        if (fan[i] == fan[j] || (a[0] != b[1] && a[1] != b[0])) continue;
        const int from = fan[i], to = fan[j];
        for (int& x : fan)
          if (x == from) x = to;
      }
    std::map<int, int> size;
    for (const int x : fan) ++size[x];
    if (size.size() == 1) continue;
    const int largest = std::max_element(size.begin(), size.end(), [](auto& a, auto& b) {
                          return a.second < b.second;
                        })->first;
    for (std::size_t i = 0; i < mine.size(); ++i)
      if (fan[i] != largest) gone[mine[i]] = 1;
  }
  std::size_t kept = 0;
  for (std::size_t f = 0; f < faces.size(); ++f)
    if (gone[f] == 0) faces[kept++] = faces[f];
  const bool changed = kept < faces.size();
  faces.resize(kept);
  return changed;
}

/// Flat triangles against the rim, as rounding leaves them along a straight one: their corners lie on a line, nearly. One
/// goes where its other two edges have another face each, so that no point is lost.
bool peel_flat(Mesh& mesh) {
  const MeshTopology topology(mesh);
  std::vector<char> gone(mesh.faces.size(), 0), rim(mesh.faces.size(), 0), open(3 * mesh.faces.size(), 0);
  for (const BoundaryLoop& loop : topology.loops())
    for (const std::int32_t h : loop.half_edges) open[h] = 1, ++rim[h / 3];
  for (std::size_t h = 0; h < open.size(); ++h) {
    if (open[h] == 0 || rim[h / 3] != 1) continue;
    const Corners& t = mesh.faces[h / 3];
    const double *p = mesh.vertex(t[(h + 2) % 3]), *a = mesh.vertex(t[h % 3]),
                 *b = mesh.vertex(t[(h + 1) % 3]);
    double along = 0, to_a = 0, to_b = 0;
    for (int c = 0; c < 3; ++c) {
      const double x = a[c] - p[c], y = b[c] - p[c];
      along += x * y, to_a += x * x, to_b += y * y;
    }
    gone[h / 3] = !(along > kFlat * std::sqrt(to_a) * std::sqrt(to_b));
  }
  std::size_t kept = 0;
  for (std::size_t f = 0; f < gone.size(); ++f)
    if (gone[f] == 0) mesh.faces[kept++] = mesh.faces[f];
  const bool changed = kept < gone.size();
  mesh.faces.resize(kept);
  return changed;
}

}  // namespace

Mesh join_neighbours(std::span<const double> points, const NeighbourLists& near,
                     const std::vector<Vector>& normals) {
  Mesh mesh;
  mesh.vertices.assign(points.begin(), points.end());
  // Edges taken, one way each, by their first vertex.
  std::vector<std::vector<std::int32_t>> taken(normals.size());
  const auto is_taken = [&](std::int32_t a, std::int32_t b) {
    return std::find(taken[a].begin(), taken[a].end(), b) != taken[a].end();
  };
  for (const Candidate& c : candidates(points, near, normals)) {
    const auto& [a, b, d] = c.corners;
    if (is_taken(a, b) || is_taken(b, d) || is_taken(d, a)) continue;
    // One vote alone closes what two leave open: a hole of three edges, a notch in the rim.
    if (c.votes < 2 && is_taken(b, a) + is_taken(d, b) + is_taken(a, d) < 2) continue;
    taken[a].push_back(b), taken[b].push_back(d), taken[d].push_back(a);
    mesh.faces.push_back(c.corners);
  }
  do {
    while (keep_one_fan(mesh.faces, mesh.vertex_count())) {
    }
  } while (!mesh.faces.empty() && peel_flat(mesh));
  return mesh;
}

CloudMap map_graph(std::span<const double> points, const NeighbourLists& near,
                   const std::vector<Vector>& normals, const CloudOptions& options, const Control& control) {
  const Mesh joined = join_neighbours(points, near, normals);
  if (joined.faces.empty()) throw InvalidInput("no triangles of their nearest neighbours agree");
  CloudMap cloud;
  cloud.base = CloudBase::graph;
  cloud.points = static_cast<Index>(normals.size());
  cloud.mesh = joined;
  // Looked at before the work of a map.
  const RepairedMesh largest = repair(joined, {.largest_part = true, .fill_holes = true});
  const Index joined_points = static_cast<Index>(largest.kept.size()) - std::ranges::count(largest.kept, -1);
  const double share = static_cast<double>(joined_points) / static_cast<double>(cloud.points);
  if (share < kLeastShare)
    throw InvalidInput(
        fmt::format("their nearest neighbours join only {:.3g} % of them to one sheet", 100 * share));
  if (!options.fill_holes) {
    CloudMap open;
    open.base = CloudBase::graph;
    open.points = cloud.points;
    open.mesh = largest.mesh;
    std::vector<char> kept(normals.size(), 0);
    for (const Index k : largest.kept)
      if (k >= 0) kept[k] = 1;
    open.openings = cloud_openings(open.mesh, loose_points(points, kept));
    require_no_openings(open);
  }
  try {
    map_outline(cloud, options.map, control);
  } catch (const InvalidInput& e) {
    // Without the options that repair a mesh of a file.
    const std::string_view what = e.what();
    throw InvalidInput(fmt::format(
        "the mesh of their nearest neighbours is no sheet with one outline: {}; {} or cylinder lays the "
        "points over a base",
        what.substr(0, what.find("; `")), remedy_text(Remedy::base, "plane")));
  }
  return cloud;
}

}  // namespace knotfit::cloud
