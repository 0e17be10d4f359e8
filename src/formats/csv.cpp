// Tables of points in text: CSV, TSV, blanks between columns.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "formats/airfoil.h"
#include "formats/missing.h"
#include "formats/point_text.h"
#include "formats/readers.h"
#include "knotfit/exceptions.h"
namespace knotfit {

SourceData table_of(const FileBytes& file, PointText&& points, const ReadOptions& options) {
  if (points.not_finite.number > 0) refuse_not_finite(file, points, points.not_finite);
  SourceData data{.path = file.path(), .format = "csv", .content = PointTable{}};
  data.notes = std::move(points.notes);
  data.columns = std::move(points.told);
  data.columns_from = std::move(points.columns_from);
  PointTable& table = points.table;
  drop_points(table, points.missing);
  const Index upper =
      points.joins -
      (std::lower_bound(points.missing.begin(), points.missing.end(), points.joins) - points.missing.begin());
  if (upper > 0 && upper < table.size()) data.notes.push_back(join_lednicer(table, upper));
  data.left_out = static_cast<Index>(points.missing.size()) + drop_far_nodata(table, options.nodata);
  if (table.z.empty()) throw FileError(file.path(), "every point has the nodata value");
  if (data.left_out > 0) data.notes.push_back(left_out_note(data.left_out, *options.nodata));
  data.content = std::move(table);
  return data;
}

SourceData read_csv(const FileBytes& file, const ReadOptions& options) {
  return table_of(file, parse_point_text(file, options), options);
}

SourceData read_text_points(const FileBytes& file, const ReadOptions& options) {
  PointText points = parse_point_text(file, options);
  const bool rows = points.group_start.size() > 1 && !points.header && only_xyz(points.roles);
  return rows ? rows_of(file, std::move(points)) : table_of(file, std::move(points), options);
}

}  // namespace knotfit
