#include "feature_file.h"

#include <fmt/format.h>

#include "input.h"
#include "knotfit/exceptions.h"
#include "knotfit/io.h"
namespace knotfit::tool {
namespace {

PointTable values_of(const std::string& path) {
  SourceData data = read_input(path, {});
  if (const Raster* raster = std::get_if<Raster>(&data.content)) return table_of(*raster);
  if (PointTable* table = std::get_if<PointTable>(&data.content)) return std::move(*table);
  if (const PointRows* rows = std::get_if<PointRows>(&data.content)) return table_of(*rows);
  throw FileError(path,
                  "is a mesh; a feature measure is a grid, or points x,y,z or u,v,z with the measure as z");
}

bool inside(double t) {
  return t >= 0 && t <= 1;
}

/// \param where  the place of value k, for a file without lines
void check_measure(const std::string& path, const PointTable& table, Index k, double f,
                   const std::string& where) {
  if (f >= 0) return;
  const std::string what = fmt::format("the feature measure is {} there: it must be at least 0", f);
  if (table.line.empty()) throw FileError(path, where + ": " + what);
  throw FileError(path, table.line[k], what);
}

}  // namespace

FeatureMap read_feature_file(const std::string& path, const ParameterMap& map) {
  const PointTable table = values_of(path);
  const bool by_uv = !table.u.empty();
  const std::vector<double>&a = by_uv ? table.u : table.x, &b = by_uv ? table.v : table.y;
  ParameterizedPoints points;
  for (Index k = 0; k < table.size(); ++k) {
    const double u = map.to_u(a[k]), v = map.to_v(b[k]);
    check_measure(path, table, k, table.z[k], fmt::format("{},{}", a[k], b[k]));
    if (!inside(u) || !inside(v)) continue;
    points.uv.insert(points.uv.end(), {u, v});
    points.values.push_back(table.z[k]);
  }
  if (points.size() == 0)
    throw FileError(path, fmt::format("has no value over the data, {} in [{}, {}] and {} in [{}, {}]",
                                      map.name_u, map.u0, map.u1, map.name_v, map.v0, map.v1));
  return point_features(points, points.values);
}

FeatureMap read_curve_feature_file(const std::string& path, const CurvePoints& curve) {
  ReadOptions read;
  read.columns = {"x", "y"};
  read.places = true;
  const SourceData data = read_source(path, read);
  const PointTable* table = std::get_if<PointTable>(&data.content);
  if (table == nullptr || table->x.empty())
    throw FileError(path, curve.function ? "a feature measure of a function is two columns: x and the measure"
                                         : "a feature measure of a curve is two columns: t, from 0 at its "
                                           "start to 1 at its end, and the measure");
  ParameterizedPoints points;
  for (Index k = 0; k < table->size(); ++k) {
    check_measure(path, *table, k, table->y[k], fmt::format("{}", table->x[k]));
    const double t = curve.function ? (table->x[k] - curve.x0) / (curve.x1 - curve.x0) : table->x[k];
    if (!inside(t)) continue;
    points.uv.insert(points.uv.end(), {t, 0.5});
    points.values.push_back(table->y[k]);
  }
  if (points.size() == 0)
    throw FileError(path,
                    fmt::format("has no value over the curve, {} in [{}, {}]", curve.function ? "x" : "t",
                                curve.function ? curve.x0 : 0, curve.function ? curve.x1 : 1));
  return point_features(points, points.values);
}

}  // namespace knotfit::tool
