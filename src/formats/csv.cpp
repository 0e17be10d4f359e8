// Tables of points in text: CSV, TSV, blanks between columns.
#include <cmath>
#include <utility>

#include "formats/point_text.h"
#include "formats/readers.h"
#include "knotfit/errors.h"
namespace knotfit {
namespace {

/// Drops the points whose z is NaN (the nodata value).
void drop_holes(PointTable& table) {
  std::size_t kept = 0;
  const std::size_t n = table.z.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (std::isnan(table.z[k])) continue;
    for (int r = 0; r < kRoles; ++r)
      if (std::vector<double>& column = *column_of(table, static_cast<Role>(r)); !column.empty())
        column[kept] = column[k];
    table.line[kept++] = table.line[k];
  }
  for (int r = 0; r < kRoles; ++r)
    if (std::vector<double>& column = *column_of(table, static_cast<Role>(r)); !column.empty())
      column.resize(kept);
  table.line.resize(kept);
}

}  // namespace

SourceData table_of(const FileBytes& file, PointText&& points) {
  if (points.not_finite.number > 0) refuse_not_finite(file, points, points.not_finite);
  if (points.holes > 0) drop_holes(points.table);
  if (points.table.z.empty()) throw FileError(file.path(), "every point has the nodata value");
  return {file.path(), "csv", std::move(points.table)};
}

SourceData read_csv(const FileBytes& file, const ReadOptions& options) {
  return table_of(file, parse_point_text(file, options));
}

SourceData read_text_points(const FileBytes& file, const ReadOptions& options) {
  PointText points = parse_point_text(file, options);
  const bool rows = points.group_start.size() > 1 && !points.header && only_xyz(points.roles);
  return rows ? rows_of(file, std::move(points)) : table_of(file, std::move(points));
}

}  // namespace knotfit
