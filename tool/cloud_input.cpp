#include "cloud_input.h"

#include <fmt/format.h>

#include <numeric>

#include "input.h"
#include "knotfit/base_surface.h"
#include "knotfit/exceptions.h"
#include "parameterize/table_checks.h"
#include "surface_file.h"
#include "text_values.h"
namespace knotfit::tool {
namespace {

MappedMesh mapped(CloudMap cloud, const std::vector<Index>& line) {
  MappedMesh result;
  result.cloud.emplace();
  take_map(result, std::move(cloud), line);
  return result;
}

MeshMapOptions map_options(const FitChoices& choices) {
  MeshMapOptions options;
  options.omega = choices.omega.value_or(-1);
  const CornerChoice corners = parse_corners(choices.corners.value_or("auto"));
  if (!corners.vertices.empty() || !corners.places.empty())
    throw InvalidInput(
        "--corners " + *choices.corners +
        ": the corners of points without a mesh are found by a rule: auto, sharpest or search");
  options.corners = corners.rule;
  return options;
}

/// The points of a file with a boundary curve.
std::vector<double> curve_points(const std::string& path) {
  const SourceData data = read_input(path, {});
  PointTable table;
  if (const PointTable* t = std::get_if<PointTable>(&data.content)) table = *t;
  if (const PointRows* rows = std::get_if<PointRows>(&data.content)) table = table_of(*rows);
  if (table.x.empty()) throw InvalidInput(path + ": holds no points x, y, z of a boundary curve");
  std::vector<double> xyz;
  for (Index k = 0; k < table.size(); ++k) xyz.insert(xyz.end(), {table.x[k], table.y[k], table.z[k]});
  return xyz;
}

Surface base_surface(const BaseChoice& base) {
  if (base.curves.empty())
    return surface_in_space(read_one_surface(base.surface, {}), base.surface + ": is no surface in space");
  std::array<std::vector<double>, 4> curves;
  for (std::size_t k = 0; k < 4; ++k) curves[k] = curve_points(base.curves[k]);
  return coons_surface(curves);
}

/// Lays points over the base that was asked for.
CloudMap lay(std::span<const double> points, std::span<const Index> index, const std::vector<double>& normals,
             const FitChoices& choices, const Control& control) {
  const BaseChoice base = parse_base(choices.base.value_or("auto"));
  const bool fill_holes = choices.fill_holes.value_or(false);
  if (base.kind == CloudBase::surface) {
    CloudMap cloud = parameterize_cloud(points, base_surface(base), control);
    if (!fill_holes) require_no_openings(cloud);
    return cloud;
  }
  CloudOptions options;
  options.base = base.kind;
  options.map = map_options(choices);
  options.fill_holes = fill_holes;
  if (!normals.empty())
    for (const Index k : index)
      options.normals.insert(options.normals.end(), &normals[3 * k], &normals[3 * k] + 3);
  return parameterize_cloud(points, options, control);
}

}  // namespace

MappedMesh map_cloud(const PointTable& table, const FitChoices& choices, const Control& control) {
  if (table.x.empty()) throw InvalidInput("z without x, y and u, v columns: there is nothing to fit it over");
  std::vector<double> xyz;
  xyz.reserve(static_cast<std::size_t>(3 * table.size()));
  for (Index k = 0; k < table.size(); ++k) xyz.insert(xyz.end(), {table.x[k], table.y[k], table.z[k]});
  parameterize::check_strays(xyz, 3, table.line);
  std::vector<double> normals;
  for (std::size_t k = 0; k < table.nx.size(); ++k)
    normals.insert(normals.end(), {table.nx[k], table.ny[k], table.nz[k]});
  std::vector<Index> all(static_cast<std::size_t>(table.size()));
  std::iota(all.begin(), all.end(), Index{0});
  const Index most =
      table.weight.empty() ? sample_of(table.size(), choices) : 0;  // weights count at every point
  if (most == 0) return mapped(lay(xyz, all, normals, choices, control), table.line);
  auto sampled = std::make_shared<Sampled>();
  sampled->most = most;
  sampled->line = table.line;
  sampled->source =
      cloud_source(std::move(xyz), [normals = std::move(normals), choices, control](
                                       std::span<const double> points, std::span<const Index> index) {
        return lay(points, index, normals, choices, control);
      });
  sampled->map = map_sample(sampled->source, most);
  MappedMesh result = mapped(sampled->map, table.line);
  result.sampled = std::move(sampled);
  return result;
}

MappedMesh map_points(const ParameterizedPoints& points, bool in_rows, const FitChoices& choices,
                      const Control& control) {
  CloudMap cloud = in_rows ? map_rows(points.values, points.uv, map_options(choices), control)
                           : triangulate_parameters(points.values, points.uv);
  if (choices.new_parameters.value_or(false) && !cloud.mapped)
    map_outline(cloud, map_options(choices), control);
  return mapped(std::move(cloud), points.source);
}

}  // namespace knotfit::tool
