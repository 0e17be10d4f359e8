#include "data_conversion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "input.h"
#include "knotfit/exceptions.h"
namespace knotfit::tool {
namespace {

constexpr double kOffGrid = 1e-3;  // of a cell: what digits in a file may be off
constexpr double kMostCells = 4e8;

struct Lines {
  double first = 0, step = 0;
  Index count = 0;
  Index index(double at) const { return static_cast<Index>(std::llround((at - first) / step)); }
};

// Equally spaced lines that hold every coordinate; some may hold none.
Lines grid_lines(std::vector<double> at, const std::string& path, const char* name) {
  const auto refuse = [&](const std::string& why) {
    throw InvalidInput(
        fmt::format("{}: the points lie on no grid of equal cells ({}: {}); fit them: knotfit fit "
                    "--height-field -o name.asc --cell SIZE",
                    path, name, why));
  };
  std::sort(at.begin(), at.end());
  const double length = at.back() - at.front();
  double gap = length;
  for (std::size_t k = 1; k < at.size(); ++k)
    if (at[k] - at[k - 1] > 1e-9 * length) gap = std::min(gap, at[k] - at[k - 1]);
  if (!(length > 0)) refuse("all are equal");
  Lines lines{at.front(), gap, 0};
  if (length / gap > kMostCells) refuse("the spacing is uneven");
  lines.count = lines.index(at.back()) + 1;
  lines.step = length / static_cast<double>(lines.count - 1);
  for (const double x : at) {
    const double off = (x - lines.first) / lines.step - static_cast<double>(lines.index(x));
    if (std::abs(off) > kOffGrid) refuse(fmt::format("{} is off the spacing {:.6g}", x, lines.step));
  }
  return lines;
}

PointTable as_table(const SourceData& data) {
  if (const PointRows* rows = std::get_if<PointRows>(&data.content)) return table_of(*rows);
  if (const Mesh* mesh = std::get_if<Mesh>(&data.content)) return table_of(*mesh);
  return std::get<PointTable>(data.content);
}

}  // namespace

Table points_table(const SourceData& data) {
  Table table;
  if (const Raster* raster = std::get_if<Raster>(&data.content)) {
    PointTable heights = table_of(*raster);
    table.add("x", std::move(heights.x));
    table.add("y", std::move(heights.y));
    table.add("z", std::move(heights.z));
    return table;
  }
  PointTable points = as_table(data);
  const auto add = [&](const char* name, std::vector<double>& column) {
    if (!column.empty()) table.add(name, std::move(column));
  };
  add("x", points.x);
  add("y", points.y);
  add("z", points.z);
  add("u", points.u);
  add("v", points.v);
  add("w", points.weight);
  add("nx", points.nx);
  add("ny", points.ny);
  add("nz", points.nz);
  return table;
}

Raster raster_of(const SourceData& data) {
  if (const Raster* raster = std::get_if<Raster>(&data.content)) return *raster;
  const PointTable points = as_table(data);
  if (points.x.empty()) throw InvalidInput(data.path + ": an .asc output needs columns x, y, z");
  const Lines columns = grid_lines(points.x, data.path, "x");
  const Lines rows = grid_lines(points.y, data.path, "y");
  if (static_cast<double>(columns.count) * static_cast<double>(rows.count) > kMostCells)
    throw InvalidInput(fmt::format("{}: {} x {} cells are too many", data.path, columns.count, rows.count));
  Raster raster;
  raster.columns = columns.count;
  raster.rows = rows.count;
  raster.dx = columns.step;
  raster.dy = rows.step;
  raster.x0 = columns.first - 0.5 * columns.step;
  raster.y0 = rows.first - 0.5 * rows.step;
  raster.z.assign(columns.count * rows.count, std::numeric_limits<double>::quiet_NaN());
  for (Index k = 0; k < points.size(); ++k) {
    const Index row = rows.count - 1 - rows.index(points.y[k]);
    double& z = raster.z[row * columns.count + columns.index(points.x[k])];
    if (!std::isnan(z))
      throw InvalidInput(fmt::format("{}: line {}: a second point in the cell at x = {}, y = {}", data.path,
                                     points.line.empty() ? k + 1 : points.line[k], points.x[k], points.y[k]));
    z = points.z[k];
  }
  return raster;
}

}  // namespace knotfit::tool
