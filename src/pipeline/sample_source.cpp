#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "data/mesh_data.h"
#include "data/mesh_decimate.h"
#include "data/spaced_sample.h"
#include "knotfit/exceptions.h"
#include "knotfit/fit_sample.h"
namespace knotfit {

SampleSource cloud_source(
    std::vector<double> points,
    std::function<CloudMap(std::span<const double> points, std::span<const Index> index)> lay) {
  SampleSource source{.points = std::move(points)};
  source.map = [lay = std::move(lay)](std::span<const double> all, std::span<const Index> index) {
    std::vector<double> some;
    some.reserve(3 * index.size());
    for (const Index k : index) some.insert(some.end(), &all[3 * k], &all[3 * k] + 3);
    CloudMap map = lay(some, index);
    for (Index& line : map.mesh.vertex_line)
      if (line > 0) line = index[line - 1] + 1;
    return map;
  };
  return source;
}

SampleSource mesh_source(const Mesh& mesh, std::function<MeshMap(const Mesh&)> map) {
  auto whole = std::make_shared<Mesh>(mesh);
  whole->uv.clear();
  whole->vertex_line.assign(static_cast<std::size_t>(mesh.vertex_count()), 0);
  SampleSource source;
  std::vector<Index> vertex;  // of each point
  const std::vector<char> is_point = data_vertices(mesh);
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (is_point[v] == 0) continue;
    vertex.push_back(v);
    whole->vertex_line[v] = static_cast<Index>(vertex.size());
    source.points.insert(source.points.end(), mesh.vertex(v), mesh.vertex(v) + 3);
  }
  source.mesh = whole;
  source.map = [whole, vertex = std::move(vertex), map = std::move(map)](std::span<const double>,
                                                                         std::span<const Index> index) {
    std::vector<char> keep(static_cast<std::size_t>(whole->vertex_count()), 0);
    for (const Index k : index) keep[vertex[k]] = 1;
    CloudMap made;
    made.mesh = decimate(*whole, keep);
    made.map = map(made.mesh);
    return made;
  };
  return source;
}

CloudMap map_sample(const SampleSource& source, Index most, std::span<const Index> also) {
  const std::vector<double>& points = source.points;
  const auto n = static_cast<Index>(points.size()) / 3;
  if (points.size() % 3 != 0)
    throw InvalidInput(fmt::format("{} coordinates are no points in space", points.size()));
  for (std::size_t k = 0; k < points.size(); ++k)
    if (!(std::abs(points[k]) < 1e150))
      throw InvalidInput(
          fmt::format("point {} (from 1): coordinate {} is not finite or beyond what distances can hold",
                      k / 3 + 1, points[k]));
  if (most < 4) throw InvalidInput(fmt::format("a sample of {} points: a surface needs at least 4", most));
  for (const Index k : also)
    if (k < 0 || k >= n) throw InvalidInput(fmt::format("there is no point {} (from 0) among {}", k, n));
  std::vector<Index> index = spaced_sample(points, most);
  index.insert(index.end(), also.begin(), also.end());
  std::sort(index.begin(), index.end());
  index.erase(std::unique(index.begin(), index.end()), index.end());
  CloudMap map = source.map(points, index);
  map.points = n;
  const std::vector<Index>& line = map.mesh.vertex_line;
  const Index mapped = std::count_if(line.begin(), line.end(), [](Index number) { return number > 0; });
  map.sample = static_cast<Index>(index.size()) < n && mapped < n ? mapped : 0;
  return map;
}

}  // namespace knotfit
