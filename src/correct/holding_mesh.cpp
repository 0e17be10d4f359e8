#include "correct/holding_mesh.h"

#include <algorithm>
#include <cmath>

#include "data/mesh_topology.h"
#include "data/orientation.h"
namespace knotfit::correction {
namespace {

using Edge = std::uint64_t;  ///< the lesser vertex first

Edge edge_of(std::int32_t a, std::int32_t b) {
  return static_cast<Edge>(static_cast<std::uint32_t>(std::min(a, b))) << 32 |
         static_cast<std::uint32_t>(std::max(a, b));
}

double area_of(const HoldingMesh& mesh, std::size_t f) {
  const auto& t = mesh.face[f];
  return length(cross(mesh.position[t[1]] - mesh.position[t[0]], mesh.position[t[2]] - mesh.position[t[0]])) /
         2;
}

}  // namespace

HoldingMesh holding_mesh(const Mesh& mesh, std::vector<Vec3> position, std::vector<double> uv, Index own) {
  HoldingMesh m;
  m.position = std::move(position);
  m.face = mesh.faces;
  m.virtual_face = mesh.virtual_face;
  if (m.virtual_face.empty()) m.virtual_face.assign(m.face.size(), 0);
  m.uv = std::move(uv);
  m.own = own;
  const MeshTopology topology(mesh);
  for (const MeshEdge& edge : topology.edges)
    if (edge.count == 1) {
      const std::int32_t half_edge = topology.half_edges[edge.first];
      m.border.push_back({topology.from(half_edge), topology.to(half_edge)});
    }
  return m;
}

void halve_long_edges(HoldingMesh& mesh, double longest_u, double longest_v) {
  constexpr int most_passes = 12;
  constexpr Index most_vertices = 400000;
  const auto too_long = [&](std::int32_t a, std::int32_t b) {
    return std::abs(mesh.uv[2 * a] - mesh.uv[2 * b]) > longest_u ||
           std::abs(mesh.uv[2 * a + 1] - mesh.uv[2 * b + 1]) > longest_v;
  };
  for (int pass = 0; pass < most_passes && mesh.size() < most_vertices; ++pass) {
    std::vector<Edge> edges;
    for (const auto& t : mesh.face)
      for (int k = 0; k < 3; ++k)
        if (too_long(t[k], t[(k + 1) % 3])) edges.push_back(edge_of(t[k], t[(k + 1) % 3]));
    if (edges.empty()) return;
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    const auto first = static_cast<std::int32_t>(mesh.size());
    for (const Edge e : edges) {
      const std::size_t a = e >> 32, b = e & 0xffffffff;
      mesh.position.push_back(0.5 * (mesh.position[a] + mesh.position[b]));
      for (std::size_t c = 0; c < 2; ++c) mesh.uv.push_back((mesh.uv[2 * a + c] + mesh.uv[2 * b + c]) / 2);
    }
    const auto middle = [&](std::int32_t a, std::int32_t b) {
      const auto at = std::lower_bound(edges.begin(), edges.end(), edge_of(a, b));
      return at != edges.end() && *at == edge_of(a, b) ? first + static_cast<std::int32_t>(at - edges.begin())
                                                       : -1;
    };
    const std::size_t faces = mesh.face.size();
    for (std::size_t f = 0; f < faces; ++f) {
      const auto t = mesh.face[f];
      std::int32_t c[3];
      int halved = 0;
      for (int k = 0; k < 3; ++k) halved += (c[k] = middle(t[k], t[(k + 1) % 3])) >= 0;
      if (halved == 0) continue;
      const char closes = mesh.virtual_face[f];
      const auto add = [&](std::int32_t x, std::int32_t y, std::int32_t z) {
        mesh.face.push_back({x, y, z});
        mesh.virtual_face.push_back(closes);
      };
      if (halved == 3) {
        mesh.face[f] = {c[0], c[1], c[2]};
        add(t[0], c[0], c[2]);
        add(t[1], c[1], c[0]);
        add(t[2], c[2], c[1]);
      } else if (halved == 1) {
        const int k = c[0] >= 0 ? 0 : c[1] >= 0 ? 1 : 2;
        mesh.face[f] = {t[k], c[k], t[(k + 2) % 3]};
        add(c[k], t[(k + 1) % 3], t[(k + 2) % 3]);
      } else {
        const int k = c[0] < 0 ? 0 : c[1] < 0 ? 1 : 2;  // the edge kept
        const std::int32_t a = t[k], b = t[(k + 1) % 3], p = t[(k + 2) % 3], x = c[(k + 1) % 3],
                           y = c[(k + 2) % 3];
        mesh.face[f] = {p, y, x};
        add(a, b, x);
        add(a, x, y);
      }
    }
    std::vector<std::array<std::int32_t, 2>> border;
    for (const auto& [a, b] : mesh.border) {
      const std::int32_t c = middle(a, b);
      if (c < 0) {
        border.push_back({a, b});
      } else {
        border.push_back({a, c});
        border.push_back({c, b});
      }
    }
    mesh.border = std::move(border);
  }
}

std::vector<Slide> slides(const HoldingMesh& mesh, bool slide, bool round) {
  std::vector<Slide> result(mesh.position.size(), Slide::free);
  for (const auto& edge : mesh.border)
    for (const std::int32_t k : edge) {
      const double u = mesh.uv[2 * k], v = mesh.uv[2 * k + 1];
      const bool on_u = u == 0 || u == 1, on_v = v == 0 || v == 1;
      if (!on_u && !on_v) continue;
      result[k] = !slide         ? Slide::fixed
                  : round        ? Slide::round
                  : on_u && on_v ? Slide::fixed
                  : on_u         ? Slide::along_v
                                 : Slide::along_u;
    }
  return result;
}

PointWeights point_weights(const HoldingMesh& mesh) {
  std::vector<double> area(mesh.position.size(), 0.0);
  std::vector<char> used(mesh.position.size(), 0);
  double total = 0;
  for (std::size_t f = 0; f < mesh.face.size(); ++f) {
    if (mesh.virtual_face[f]) continue;
    const double a = area_of(mesh, f) / 3;
    for (const std::int32_t k : mesh.face[f]) {
      area[k] += a;
      used[k] = 1;
      total += a;
    }
  }
  PointWeights points;
  double data = 0;
  for (Index k = 0; k < mesh.size(); ++k) {
    if (!used[k]) continue;
    points.vertex.push_back(static_cast<std::int32_t>(k));
    points.data.push_back(k < mesh.own);
    points.area.push_back(area[k] / total);
    data += k < mesh.own;
  }
  for (const char own : points.data) points.weight.push_back(own ? 1 / data : 0);
  return points;
}

void weigh_added(const HoldingMesh& mesh, double share, PointWeights& points) {
  std::vector<double> area(mesh.position.size(), 0.0);
  for (std::size_t f = 0; f < mesh.face.size(); ++f) {
    if (mesh.virtual_face[f]) continue;
    const double part = std::abs(twice_area(mesh.uv, mesh.face[f])) / 6;
    for (const std::int32_t k : mesh.face[f]) area[k] += part;
  }
  for (std::size_t i = 0; i < points.vertex.size(); ++i)
    if (!points.data[i]) points.weight[i] = share * std::max(area[points.vertex[i]], points.area[i]);
}

}  // namespace knotfit::correction
