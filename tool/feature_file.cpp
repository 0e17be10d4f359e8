#include "feature_file.h"

#include <fmt/format.h>

#include <cmath>

#include "input.h"
#include "knotfit/errors.h"
namespace knotfit::tool {
namespace {

PointTable values_of(const std::string& path) {
  SourceData data = read_input(path, {});
  if (const Raster* raster = std::get_if<Raster>(&data.content)) {
    PointTable table;
    for (Index r = 0; r < raster->rows; ++r)
      for (Index c = 0; c < raster->columns; ++c) {
        const double z = raster->z[r * raster->columns + c];
        if (std::isnan(z)) continue;
        table.x.push_back(raster->x(c));
        table.y.push_back(raster->y(r));
        table.z.push_back(z);
      }
    return table;
  }
  if (PointTable* table = std::get_if<PointTable>(&data.content)) return std::move(*table);
  if (const PointRows* rows = std::get_if<PointRows>(&data.content)) return table_of(*rows);
  throw FileError(path,
                  "is a mesh; a feature measure is a grid, or points x,y,z or u,v,z with the measure as z");
}

bool inside(double t) {
  return t >= 0 && t <= 1;
}

}  // namespace

FeatureMap read_feature_file(const std::string& path, const ParameterMap& map) {
  const PointTable table = values_of(path);
  const bool by_uv = !table.u.empty();
  const std::vector<double>&a = by_uv ? table.u : table.x, &b = by_uv ? table.v : table.y;
  ParameterizedPoints points;
  for (Index k = 0; k < table.size(); ++k) {
    const double u = map.to_u(a[k]), v = map.to_v(b[k]);
    if (!(table.z[k] >= 0)) {
      const std::string what =
          fmt::format("the feature measure is {} there: it must be at least 0", table.z[k]);
      if (table.line.empty()) throw FileError(path, fmt::format("{},{}: {}", a[k], b[k], what));
      throw FileError(path, table.line[k], what);
    }
    if (!inside(u) || !inside(v)) continue;
    points.uv.insert(points.uv.end(), {u, v});
    points.values.push_back(table.z[k]);
  }
  if (points.size() == 0)
    throw FileError(path, fmt::format("has no value over the data, {} in [{}, {}] and {} in [{}, {}]",
                                      map.name_u, map.u0, map.u1, map.name_v, map.v0, map.v1));
  return point_features(points, points.values);
}

}  // namespace knotfit::tool
