#include "knotfit/openings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "data/orientation.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

double length_between(const Mesh& mesh, std::int32_t a, std::int32_t b) {
  const double *p = mesh.vertex(a), *q = mesh.vertex(b);
  return std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
}

double area_of(std::span<const double> uv, const std::array<std::int32_t, 3>& t) {
  return std::abs(twice_area(uv, t)) / 2;
}

void check_corners(const Mesh& mesh) {
  for (Index f = 0; f < mesh.face_count(); ++f)
    for (const std::int32_t k : mesh.faces[f])
      if (k < 0 || k >= mesh.vertex_count())
        throw InvalidInput(
            fmt::format("face {} has the corner {}, and there are {} vertices", f, k, mesh.vertex_count()));
}

}  // namespace

std::vector<Opening> find_openings(const Mesh& mesh) {
  check_corners(mesh);
  std::vector<Opening> openings;
  // Virtual faces by their edges; an edge of one such face alone is rim.
  std::map<std::array<std::int32_t, 2>, std::vector<std::int32_t>> at_edge;
  for (Index f = 0; f < static_cast<Index>(mesh.virtual_face.size()); ++f)
    if (mesh.virtual_face[f] != 0)
      for (int k = 0; k < 3; ++k) {
        const auto [a, b] = std::minmax(mesh.faces[f][k], mesh.faces[f][(k + 1) % 3]);
        at_edge[{a, b}].push_back(static_cast<std::int32_t>(f));
      }
  std::vector<char> taken(mesh.virtual_face.size(), 0);
  for (Index first = 0; first < static_cast<Index>(taken.size()); ++first) {
    if (mesh.virtual_face[first] == 0 || taken[first] != 0) continue;
    Opening opening;
    opening.faces.push_back(static_cast<std::int32_t>(first));
    taken[first] = 1;
    for (std::size_t i = 0; i < opening.faces.size(); ++i)
      for (int k = 0; k < 3; ++k) {
        const auto& corner = mesh.faces[opening.faces[i]];
        const auto [a, b] = std::minmax(corner[k], corner[(k + 1) % 3]);
        const std::vector<std::int32_t>& faces = at_edge[{a, b}];
        if (faces.size() == 1) {
          const double length = length_between(mesh, a, b);
          opening.length += length;
          for (int d = 0; d < 3; ++d)
            opening.place[d] += length * 0.5 * (mesh.vertex(a)[d] + mesh.vertex(b)[d]);
        }
        for (const std::int32_t g : faces)
          if (taken[g] == 0) {
            taken[g] = 1;
            opening.faces.push_back(g);
          }
      }
    for (double& x : opening.place) x /= opening.length > 0 ? opening.length : 1;
    openings.push_back(std::move(opening));
  }
  std::stable_sort(openings.begin(), openings.end(),
                   [](const Opening& a, const Opening& b) { return a.length > b.length; });
  return openings;
}

void measure_openings(std::vector<Opening>& openings, const Mesh& mesh, std::span<const double> uv) {
  for (Opening& o : openings) {
    o.share_of_square = 0;
    for (const std::int32_t f : o.faces) o.share_of_square += area_of(uv, mesh.faces[f]);
  }
}

double covered_share(const Mesh& mesh, std::span<const double> uv, const std::vector<Opening>& openings) {
  double share = 0;
  for (const auto& f : mesh.faces) share += area_of(uv, f);
  // A whole square is one, whatever its areas round to, and where the map bends edges that it halves (MeshMap).
  if (std::abs(share - 1) < 1e-3) share = 1;
  for (const Opening& o : openings) share -= o.share_of_square;
  return std::max(share, 0.0);
}

std::string describe(const std::vector<Opening>& openings) {
  std::string text =
      fmt::format("{} opening{} beside the rim", openings.size(), openings.size() == 1 ? "" : "s");
  for (std::size_t k = 0; k < openings.size() && k < 5; ++k) {
    const Opening& o = openings[k];
    text += fmt::format(", at ({:.8g}, {:.8g}, {:.8g}) {:.3g} around", o.place[0], o.place[1], o.place[2],
                        o.length);
  }
  return openings.size() > 5 ? text + ", ..." : text;
}

}  // namespace knotfit
