// NumPy array files: points (n x k, 3 x n), heights (H x W) and rows of points (H x W x 3).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "formats/binary_number.h"
#include "formats/column_guess.h"
#include "formats/columns.h"
#include "formats/missing.h"
#include "formats/nodata.h"
#include "formats/npy_header.h"
#include "formats/readers.h"
#include "knotfit/exceptions.h"
#include "knotfit/remedy.h"
namespace knotfit {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The items of the array as doubles, whatever their type, byte order and storage order.
class Items {
 public:
  Items(const FileBytes& file, const NpyHeader& header)
      : data_(file.view().data() + header.offset), size_(header.item_size), stride_(header.shape.size()) {
    load_ = number_loader({header.kind, size_}, header.big_endian);
    Index step = 1;
    for (std::size_t k = 0; k < stride_.size(); ++k) {
      const std::size_t axis = header.fortran_order ? k : stride_.size() - 1 - k;
      stride_[axis] = step;
      step *= header.shape[axis];
    }
  }
  double operator()(Index i, Index j) const { return at(i * stride_[0] + j * stride_[1]); }
  double operator()(Index i, Index j, Index k) const {
    return at(i * stride_[0] + j * stride_[1] + k * stride_[2]);
  }

 private:
  double at(Index k) const { return load_(data_ + k * size_); }
  const char* data_;
  int size_;
  LoadNumber load_ = nullptr;
  std::vector<Index> stride_;
};

/// Rows of an array as points; of a turned one its columns.
struct Points {
  Items item;
  Index size = 0, columns = 0;
  bool turned = false;
  double operator()(Index point, Index column) const {
    return turned ? item(column, point) : item(point, column);
  }
};

PointTable read_points(const FileBytes& file, const Points& points, std::span<const Role> roles,
                       const ReadOptions& options, Index& left_out) {
  const Index n = points.size;
  PointTable table;
  for (const Role role : roles)
    if (role != Role::skip) column_of(table, role)->reserve(static_cast<std::size_t>(n));
  const bool has_z = std::find(roles.begin(), roles.end(), Role::z) != roles.end();
  const int last = static_cast<int>(has_z || !options.curve ? Role::z : Role::y);
  std::vector<Index> missing;
  std::size_t columns = roles.size();
  for (Index i = 0; i < n; ++i) {
    double values[kRoles + 1] = {};
    values[static_cast<int>(Role::z)] = kNan;
    for (std::size_t j = 0; j < columns; ++j)
      values[static_cast<int>(roles[j])] = points(i, static_cast<Index>(j));
    clear_unknown_normal(values);
    bool finite = true;
    for (const Role role : roles)
      finite = finite && (role == Role::skip || std::isfinite(values[static_cast<int>(role)]));
    const bool misses = misses_value(values[last], finite, options.nodata);
    if (misses) missing.push_back(i);
    for (std::size_t j = 0; j < columns; ++j) {
      const Role role = roles[j];
      if (role == Role::skip) continue;
      const double value = values[static_cast<int>(role)];
      if (!misses && !std::isfinite(value))
        throw FileError(file.path(),
                        fmt::format("row {} (from 1), column {} ({}): {} is not a finite number; {}", i + 1,
                                    j + 1, role_name(role), value, leave_out_hint()));
      column_of(table, role)->push_back(value);
    }
    if (options.nodata) table.line.push_back(i + 1);
  }
  if (!has_z) table.z.assign(static_cast<std::size_t>(n), kNan);
  drop_points(table, missing);
  left_out = static_cast<Index>(missing.size()) + drop_far_nodata(table, options.nodata);
  if (table.z.empty()) throw FileError(file.path(), "every point is NaN or has the nodata value");
  if (left_out == 0) table.line.clear();
  drop_partial_normals(table);
  return table;
}

Raster read_heights(const FileBytes& file, const NpyHeader& header, const ReadOptions& options) {
  const Items item(file, header);
  Raster raster;
  raster.rows = header.shape[0];
  raster.columns = header.shape[1];
  if (options.nodata && std::isfinite(*options.nodata)) raster.nodata = *options.nodata;
  raster.z.reserve(static_cast<std::size_t>(header.count()));
  for (Index r = 0; r < raster.rows; ++r)
    for (Index c = 0; c < raster.columns; ++c) {
      double z = item(r, c);
      if (options.nodata && is_nodata(z, *options.nodata)) z = kNan;
      if (std::isinf(z))
        throw FileError(file.path(),
                        fmt::format("row {}, column {} (from 1): the height is infinite", r + 1, c + 1));
      raster.z.push_back(z);
    }
  return raster;
}

PointRows read_point_grid(const FileBytes& file, const NpyHeader& header, const ReadOptions& options) {
  const Items item(file, header);
  const Index rows = header.shape[0], columns = header.shape[1];
  PointRows out;
  out.xyz.reserve(static_cast<std::size_t>(header.count()));
  for (Index r = 0; r < rows; ++r) {
    out.row_start.push_back(r * columns);
    for (Index c = 0; c < columns; ++c) {
      const double p[3] = {item(r, c, 0), item(r, c, 1), item(r, c, 2)};
      const bool hole = std::isnan(p[0]) || std::isnan(p[1]) || std::isnan(p[2]) ||
                        (options.nodata && is_nodata(p[2], *options.nodata));
      for (int d = 0; d < 3; ++d) {
        if (!hole && std::isinf(p[d]))
          throw FileError(file.path(), fmt::format("row {}, column {} (from 1): {} is infinite", r + 1, c + 1,
                                                   role_name(static_cast<Role>(d))));
        out.xyz.push_back(hole ? kNan : p[d]);
      }
    }
  }
  out.row_start.push_back(rows * columns);
  return out;
}

constexpr Index kMostColumns = 9;  // of points; a raster has more

/// What the shape makes of an n x k array.
enum class Reading { heights, points, turned, open };

Reading reading_of(const std::vector<Index>& shape, const ReadOptions& options) {
  if (options.format == "npy-grid") return Reading::heights;
  const Index rows = shape[0], columns = shape[1];
  if (options.curve && columns == 2) return Reading::points;
  if (options.curve && rows == 2) return Reading::turned;
  if (columns == 3 || columns == 5 || columns == 6) return Reading::points;
  if (rows > kMostColumns && columns >= 2 && columns <= kMostColumns) return Reading::points;
  if (columns > kMostColumns && rows == 3) return Reading::turned;
  if (columns > 5 * rows && rows >= 4 && rows <= kMostColumns) return Reading::open;
  return Reading::heights;
}

GuessedColumns guess_of(const Points& points, const ReadOptions& options) {
  if (options.curve && points.columns == 2) return {{{Role::x, Role::y}, {"x", "y"}}, {}};
  ColumnValues values(points.columns);
  std::vector<double> row(static_cast<std::size_t>(points.columns));
  if (points.columns > 3)
    for (Index i = 0; i < points.size; ++i) {
      for (Index j = 0; j < points.columns; ++j) row[static_cast<std::size_t>(j)] = points(i, j);
      values.take(row);
    }
  return guess_columns(values, options.any_parameters);
}

SourceData points_of(const FileBytes& file, const NpyHeader& header, const ReadOptions& options,
                     bool turned) {
  const std::vector<Index>& shape = header.shape;
  const Points points{Items(file, header), shape[turned ? 1 : 0], shape[turned ? 0 : 1], turned};
  SourceData data{.path = file.path(), .format = "npy", .content = PointTable{}};
  Columns columns;
  if (options.columns.empty()) {
    GuessedColumns guess = guess_of(points, options);
    if (guess.columns.empty())
      throw FileError(file.path(),
                      fmt::format("an array of shape {}: {}; {} reads it as heights{}", shape_text(shape),
                                  guess.why, remedy_text(Remedy::format, "npy-grid"),
                                  points.columns == 2 ? ", fit-curve as the x, y of a curve" : ""));
    columns = std::move(guess.columns);
  } else {
    columns = columns_of_option(options.columns, options.places);
    if (static_cast<Index>(columns.roles.size()) != points.columns)
      throw FileError(file.path(), fmt::format("an array of shape {} has {} columns, but {} are named",
                                               shape_text(shape), points.columns, columns.roles.size()));
  }
  data.content = read_points(file, points, columns.roles, options, data.left_out);
  data.columns = std::move(columns.told);
  data.columns_from = options.columns.empty() ? "guess" : "option";
  if (turned)
    data.notes.push_back(fmt::format("an array of shape {}: a column is a point", shape_text(shape)));
  if (data.left_out > 0) data.notes.push_back(left_out_note(data.left_out, *options.nodata));
  return data;
}

}  // namespace

SourceData read_npy(const FileBytes& file, const ReadOptions& options) {
  const NpyHeader header = parse_npy_header(file);
  const std::vector<Index>& shape = header.shape;
  if (shape.size() == 3 && shape[2] == 3 && options.format != "npy-grid" && options.columns.empty())
    return {file.path(), "npy", read_point_grid(file, header, options)};
  if (shape.size() != 2)
    throw FileError(
        file.path(),
        fmt::format("an array of shape {} is neither n x 3 to n x 9 points, nor H x W heights, nor "
                    "H x W x 3 points{}",
                    shape_text(shape),
                    options.columns.empty() ? "" : " (and columns are named: n x k points only)"));
  if (!options.columns.empty() && options.format != "npy-grid") {
    const auto named = static_cast<Index>(options.columns.size());
    return points_of(file, header, options, shape[1] != named && shape[0] == named);
  }
  switch (reading_of(shape, options)) {
    case Reading::points:
      return points_of(file, header, options, false);
    case Reading::turned:
      return points_of(file, header, options, true);
    case Reading::open:
      if (guess_of({Items(file, header), shape[1], shape[0], true}, options).columns.empty()) break;
      throw FileError(
          file.path(),
          fmt::format("an array of shape {} may be {} points, one a column, or heights: name the rows as "
                      "columns ({}), or say {}",
                      shape_text(shape), shape[1], remedy_text(Remedy::columns, "x,y,z,..."),
                      remedy_text(Remedy::format, "npy-grid")));
    case Reading::heights:
      break;
  }
  return {file.path(), "npy", read_heights(file, header, options)};
}

}  // namespace knotfit
