// Rows of points: a blank line ends a row.
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "formats/point_text.h"
#include "formats/readers.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

/// A pole written once: the first or last row is one point, and stands for as many as the row beside it has.
void spread_pole(PointRows& rows, bool first, std::vector<std::string>& notes) {
  const Index row = first ? 0 : rows.rows() - 1, beside = first ? 1 : row - 1;
  if (rows.rows() < 3 || rows.row_start[row + 1] - rows.row_start[row] != 1) return;
  const Index count = rows.row_start[beside + 1] - rows.row_start[beside];
  if (count < 2) return;
  const Index at = rows.row_start[row];
  if (std::isnan(rows.xyz[3 * at + 2])) return;  // a hole
  const std::vector<double> point(rows.xyz.begin() + 3 * at, rows.xyz.begin() + 3 * at + 3);
  for (Index k = 1; k < count; ++k) rows.xyz.insert(rows.xyz.begin() + 3 * at, point.begin(), point.end());
  rows.line.insert(rows.line.begin() + at, static_cast<std::size_t>(count - 1), Index{rows.line[at]});
  for (Index r = row + 1; r <= rows.rows(); ++r) rows.row_start[r] += count - 1;
  notes.push_back(
      fmt::format("the {} row is one point (line {}): a pole, taken for all {} points of that row",
                  first ? "first" : "last", rows.line[at], count));
}

}  // namespace

SourceData rows_of(const FileBytes& file, PointText&& points) {
  if (!only_xyz(points.roles))
    throw FileError(file.path(), "rows of points have the columns x, y and z only");
  if (points.broken.number > 0) refuse_not_finite(file, points, points.broken);
  const PointTable& table = points.table;
  PointRows rows;
  rows.xyz.reserve(3 * table.z.size());
  for (std::size_t k = 0; k < table.z.size(); ++k)
    rows.xyz.insert(rows.xyz.end(), {table.x[k], table.y[k], table.z[k]});
  rows.row_start = std::move(points.group_start);
  rows.row_start.push_back(rows.size());
  rows.line = std::move(points.table.line);
  SourceData data{.path = file.path(), .format = "rows", .content = PointRows{}};
  data.notes = std::move(points.notes);
  data.columns = std::move(points.told);
  data.columns_from = std::move(points.columns_from);
  spread_pole(rows, true, data.notes);
  spread_pole(rows, false, data.notes);
  data.content = std::move(rows);
  return data;
}

SourceData read_rows(const FileBytes& file, const ReadOptions& options) {
  return rows_of(file, parse_point_text(file, options));
}

}  // namespace knotfit
