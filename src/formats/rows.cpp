// Rows of points: a blank line ends a row.
#include <utility>

#include "formats/point_text.h"
#include "formats/readers.h"
#include "knotfit/errors.h"
namespace knotfit {

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
  SourceData data{.path = file.path(), .format = "rows", .content = std::move(rows)};
  data.notes = std::move(points.notes);
  data.columns = std::move(points.told);
  data.columns_from = std::move(points.columns_from);
  return data;
}

SourceData read_rows(const FileBytes& file, const ReadOptions& options) {
  return rows_of(file, parse_point_text(file, options));
}

}  // namespace knotfit
