#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "knotfit/exceptions.h"
#include "knotfit/parameterize.h"
#include "knotfit/remedy.h"
#include "parameterize/table_checks.h"
namespace knotfit {
namespace {

void check_raster(const Raster& raster) {
  if (raster.rows < 2 || raster.columns < 2)
    throw InvalidInput(fmt::format("a grid of {} rows and {} columns: a surface needs at least 2 of each",
                                   raster.rows, raster.columns));
  if (static_cast<Index>(raster.z.size()) != raster.rows * raster.columns)
    throw InvalidInput(fmt::format("a grid of {} rows and {} columns with {} heights", raster.rows,
                                   raster.columns, raster.z.size()));
  if (!(raster.dx > 0 && raster.dy > 0 && std::isfinite(raster.dx) && std::isfinite(raster.dy)))
    throw InvalidInput(
        fmt::format("cells of {} by {}: their size must be positive and finite", raster.dx, raster.dy));
  const double x1 = raster.x(raster.columns - 1), y1 = raster.y(0);
  if (!std::isfinite(raster.x0) || !std::isfinite(raster.y0) || !std::isfinite(x1) || !std::isfinite(y1))
    throw InvalidInput(fmt::format("a grid from ({}, {}) to ({}, {}): its corners are not finite", raster.x0,
                                   raster.y0, x1, y1));
  if (!(raster.x(0) < raster.x(1) && raster.y(1) < raster.y(0)))
    throw InvalidInput(fmt::format("cells of {} by {} are below the rounding of the corner ({}, {})",
                                   raster.dx, raster.dy, raster.x0, raster.y0));
}

}  // namespace

ParameterizedPoints parameterize_height_field(const Raster& raster) {
  check_raster(raster);
  ParameterizedPoints points;
  points.dimension = 1;
  points.height_field = true;
  points.map = {"x", "y", raster.x(0), raster.x(raster.columns - 1), raster.y(raster.rows - 1), raster.y(0)};
  const auto last_column = static_cast<double>(raster.columns - 1),
             last_row = static_cast<double>(raster.rows - 1);
  for (Index r = 0; r < raster.rows; ++r)
    for (Index c = 0; c < raster.columns; ++c) {
      const Index cell = r * raster.columns + c;
      const double z = raster.z[cell];
      if (std::isnan(z)) continue;
      if (!std::isfinite(z))
        throw InvalidInput(
            fmt::format("row {}, column {} of the grid: height {} is not finite", r + 1, c + 1, z));
      points.uv.push_back(static_cast<double>(c) / last_column);
      points.uv.push_back(static_cast<double>(raster.rows - 1 - r) / last_row);
      points.values.push_back(z);
      points.source.push_back(cell + 1);
    }
  if (points.size() == 0)
    throw InvalidInput(fmt::format("a grid of {} rows and {} columns without a cell that has data",
                                   raster.rows, raster.columns));
  if (points.size() == raster.rows * raster.columns) points.source.clear();  // index + 1 everywhere
  return points;
}

ParameterizedPoints parameterize_height_field(const PointTable& table) {
  parameterize::check_table(table);
  if (table.x.empty())
    throw InvalidInput(remedy_text(Remedy::height_field) +
                       " fits z over (x, y), and there are no x and y columns; name them with " +
                       remedy_text(Remedy::columns));
  parameterize::check_plane(table.x, table.y, "x", "y", table.line);
  const parameterize::Range x = parameterize::range_of(table.x, "x"),
                            y = parameterize::range_of(table.y, "y");
  ParameterizedPoints points;
  points.dimension = 1;
  points.height_field = true;
  points.map = {"x", "y", x.low, x.high, y.low, y.high};
  points.values = table.z;
  points.weights = table.weight;
  points.source = table.line;
  points.uv.reserve(2 * table.z.size());
  for (Index k = 0; k < table.size(); ++k) {
    points.uv.push_back(std::clamp(points.map.to_u(table.x[k]), 0.0, 1.0));
    points.uv.push_back(std::clamp(points.map.to_v(table.y[k]), 0.0, 1.0));
  }
  return points;
}

}  // namespace knotfit
