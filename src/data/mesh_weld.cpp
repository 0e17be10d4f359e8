#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "data/border_edges.h"
#include "data/mesh_edit.h"
#include "data/mesh_topology.h"
#include "knotfit/exceptions.h"
#include "knotfit/weld_mesh.h"
namespace knotfit {
namespace {

constexpr double kShare = 1e-7;           // of the diagonal
constexpr double kMostShare = 1e-2;       // of the diagonal: what is farther apart is not one place
constexpr double kSameParameters = 1e-6;  // of their range: six digits

struct Box {
  double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
  double most = 0;  // coordinate, by its size
  explicit Box(const Mesh& mesh) {
    for (Index k = 0; k < mesh.vertex_count(); ++k)
      for (int d = 0; d < 3; ++d) {
        const double x = mesh.vertex(k)[d];
        low[d] = std::min(low[d], x);
        high[d] = std::max(high[d], x);
        most = std::max(most, std::abs(x));
      }
  }
  double diagonal() const {
    return most > 0 ? std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) : 0;
  }
};

/// Every coordinate is a single-precision number, and their last bits are in use: of those set by chance half are 1.
bool is_single_precision(const Mesh& mesh) {
  Index odd = 0, all = 0;
  for (const double x : mesh.vertices) {
    const auto rounded = static_cast<float>(x);
    if (static_cast<double>(rounded) != x) return false;
    if (x == 0) continue;
    ++all;
    odd += std::bit_cast<std::uint32_t>(rounded) & 1U;
  }
  return 4 * odd > all;
}

/// What tells a disk from a tube, of each part of the mesh as it was: its least face stands for it.
struct PartShape {
  Index euler_characteristic = 0, rims = 0;
};

std::vector<PartShape> shapes(const Mesh& mesh, const MeshTopology& topology, const MeshTopology& parts) {
  std::vector<PartShape> out(mesh.faces.size());
  const auto part = [&](Index face) { return parts.part(face); };
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (topology.repeated[f]) continue;
    ++out[part(f)].euler_characteristic;
    for (int k = 0; k < 3; ++k)
      if (topology.fan(f, k) == 3 * f + k) ++out[part(f)].euler_characteristic;
  }
  for (const MeshEdge& e : topology.edges) --out[part(topology.half_edges[e.first] / 3)].euler_characteristic;
  for (const BoundaryLoop& loop : topology.loops()) ++out[part(loop.half_edges[0] / 3)].rims;
  return out;
}

class Welder {
 public:
  Welder(Mesh& mesh, double tolerance, bool keep_parameters)
      : mesh_(mesh), before_(mesh), tolerance_(tolerance), keep_parameters_(keep_parameters) {
    double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    for (std::size_t k = 0; k < mesh.uv.size(); ++k) {
      low[k % 2] = std::min(low[k % 2], mesh.uv[k]);
      high[k % 2] = std::max(high[k % 2], mesh.uv[k]);
    }
    for (int d = 0; d < 2; ++d) same_[d] = kSameParameters * (high[d] - low[d]);
  }

  WeldSummary run() {
    WeldSummary summary;
    summary.tolerance = tolerance_;
    summary.parts_before = summary.parts_after = count_parts(before_);
    std::vector<EdgePair> pairs = equal_border_edges(mesh_, before_, tolerance_);
    if (keep_parameters_)
      std::erase_if(pairs, [&](const EdgePair& p) {
        return !same_parameters(p.a[0], p.b[0]) || !same_parameters(p.a[1], p.b[1]);
      });
    if (pairs.empty()) return summary;
    DisjointSets places = joined(pairs);
    if (const std::vector<char> cut = parts_left_cut(pairs, places); !cut.empty()) {
      const Index all = count_merged(places);
      std::erase_if(pairs, [&](const EdgePair& p) { return cut[before_.part(p.face[0])] != 0; });
      places = joined(pairs);
      summary.left_apart = all - count_merged(places);
    }
    summary.vertices = count_merged(places);
    if (summary.vertices == 0) return summary;
    for (Index k = 0; k < mesh_.vertex_count(); ++k) {
      const std::int32_t root = places.root(static_cast<std::int32_t>(k));
      if (root == k) continue;
      const double *p = mesh_.vertex(k), *q = mesh_.vertex(root);
      summary.distance = std::max(summary.distance, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
      summary.parameters += !same_parameters(static_cast<std::int32_t>(k), root);
    }
    if (summary.parameters > 0) mesh_.uv.clear();
    merge(places);
    summary.parts_after = count_parts(MeshTopology(mesh_));
    return summary;
  }

 private:
  bool same_parameters(std::int32_t a, std::int32_t b) const {
    for (int d = 0; d < 2 && !mesh_.uv.empty(); ++d) {
      const double x = mesh_.uv[2 * a + d], y = mesh_.uv[2 * b + d];
      // Missing ones (NaN) are the same where both are missing.
      if (x != y && !(std::abs(x - y) <= same_[d]) && !(std::isnan(x) && std::isnan(y))) return false;
    }
    return true;
  }

  Index count_parts(const MeshTopology& topology) const {
    Index parts = 0;
    for (Index f = 0; f < mesh_.face_count(); ++f) parts += !topology.repeated[f] && topology.part(f) == f;
    return parts;
  }

  DisjointSets joined(const std::vector<EdgePair>& pairs) const {
    DisjointSets places(mesh_.vertex_count());
    for (const EdgePair& p : pairs)
      for (int k = 0; k < 2; ++k) places.unite(p.a[k], p.b[k]);
    return places;
  }

  Index count_merged(const DisjointSets& places) const {
    Index merged = 0;
    for (Index k = 0; k < mesh_.vertex_count(); ++k) merged += places.root(static_cast<std::int32_t>(k)) != k;
    return merged;
  }

  /// Parts that would be joined to themselves alone, and not become more of a disk by that: a tube that was cut
  /// open. An entry a face, of use at each part's least face; empty where there is none.
  std::vector<char> parts_left_cut(const std::vector<EdgePair>& pairs, const DisjointSets& places) const {
    std::vector<char> alone(mesh_.faces.size(), 0), cut;
    for (const EdgePair& p : pairs) alone[before_.part(p.face[0])] = 1;
    for (const EdgePair& p : pairs)
      if (before_.part(p.face[0]) != before_.part(p.face[1]))
        alone[before_.part(p.face[0])] = alone[before_.part(p.face[1])] = 0;
    if (std::find(alone.begin(), alone.end(), 1) == alone.end()) return cut;
    Mesh welded;
    welded.vertices = mesh_.vertices;
    welded.faces = mesh_.faces;
    for (auto& corners : welded.faces)
      for (std::int32_t& v : corners) v = places.root(v);
    const MeshTopology after(welded);
    const std::vector<PartShape> was = shapes(mesh_, before_, before_), is = shapes(welded, after, before_);
    for (std::size_t f = 0; f < alone.size(); ++f)
      if (alone[f] != 0 && (is[f].rims < 1 || is[f].euler_characteristic < was[f].euler_characteristic)) {
        cut.resize(alone.size(), 0);
        cut[f] = 1;
      }
    return cut;
  }

  void merge(const DisjointSets& places) {
    std::vector<char> keep(static_cast<std::size_t>(mesh_.vertex_count()));
    for (std::size_t k = 0; k < keep.size(); ++k)
      keep[k] = places.root(static_cast<std::int32_t>(k)) == static_cast<std::int32_t>(k);
    for (auto& corners : mesh_.faces)
      for (std::int32_t& v : corners) v = places.root(v);
    keep_vertices(mesh_, keep);
  }

  Mesh& mesh_;
  const MeshTopology before_;
  double tolerance_;
  bool keep_parameters_;
  double same_[2];
};

}  // namespace

double weld_tolerance(const Mesh& mesh, bool single_precision) {
  const Box box(mesh);
  const double share = kShare * box.diagonal();
  if (!single_precision && !is_single_precision(mesh)) return share;
  // A last bit in each coordinate: at most 2^-23 of the largest.
  const double last_bit = std::sqrt(3.0) * 0x1p-23 * box.most;
  return std::min(std::max(share, last_bit), kMostShare * box.diagonal());
}

WeldSummary weld(Mesh& mesh, double tolerance, bool keep_parameters) {
  const double diagonal = Box(mesh).diagonal();
  if (!std::isfinite(diagonal)) return {};  // beyond what distances can hold: left to the checks of the fit
  if (!(tolerance >= 0 && tolerance <= kMostShare * diagonal))
    throw InvalidInput(fmt::format(
        "vertices within {:g} of each other cannot be one: at most 1 % of the mesh's diagonal, which is {:g}",
        tolerance, kMostShare * diagonal));
  return Welder(mesh, tolerance, keep_parameters).run();
}

}  // namespace knotfit
