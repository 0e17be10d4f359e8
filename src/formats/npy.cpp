// NumPy array files: points (n x k), heights (H x W) and rows of points (H x W x 3).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "formats/binary_number.h"
#include "formats/columns.h"
#include "formats/nodata.h"
#include "formats/npy_header.h"
#include "formats/readers.h"
#include "knotfit/errors.h"
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

PointTable read_points(const FileBytes& file, const NpyHeader& header, std::span<const Role> roles,
                       const ReadOptions& options) {
  const Items item(file, header);
  const Index n = header.shape[0], columns = header.shape[1];
  PointTable table;
  for (const Role role : roles)
    if (role != Role::skip) column_of(table, role)->reserve(static_cast<std::size_t>(n));
  std::vector<Index> kept;
  bool holes = false;
  for (Index i = 0; i < n; ++i) {
    // A point whose coordinates are all NaN, or whose z is the nodata value, is a hole.
    bool hole = false, seen = false;
    for (Index j = 0; j < columns; ++j) {
      const Role role = roles[static_cast<std::size_t>(j)];
      if (role > Role::z) continue;
      if (role == Role::z && options.nodata && is_nodata(item(i, j), *options.nodata)) {
        hole = true;
        break;
      }
      hole = (hole || !seen) && std::isnan(item(i, j));
      seen = true;
    }
    if (hole) {
      if (!holes)
        for (Index k = 0; k < i; ++k) kept.push_back(k + 1);
      holes = true;
      continue;
    }
    double values[kRoles + 1] = {};
    for (Index j = 0; j < columns; ++j)
      values[static_cast<int>(roles[static_cast<std::size_t>(j)])] = item(i, j);
    clear_unknown_normal(values);
    for (Index j = 0; j < columns; ++j) {
      const Role role = roles[static_cast<std::size_t>(j)];
      if (role == Role::skip) continue;
      const double value = values[static_cast<int>(role)];
      if (!std::isfinite(value))
        throw FileError(file.path(), fmt::format("row {} (from 1), column {} ({}): {} is not a finite number",
                                                 i + 1, j + 1, role_name(role), value));
      column_of(table, role)->push_back(value);
    }
    if (holes) kept.push_back(i + 1);
  }
  const std::size_t size = std::max(table.x.size(), table.u.size());
  if (std::find(roles.begin(), roles.end(), Role::z) == roles.end()) table.z.assign(size, kNan);
  if (table.z.empty()) throw FileError(file.path(), "every point is NaN or has the nodata value");
  drop_partial_normals(table);
  table.line = std::move(kept);
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

}  // namespace

SourceData read_npy(const FileBytes& file, const ReadOptions& options) {
  const NpyHeader header = parse_npy_header(file);
  const std::vector<Index>& shape = header.shape;
  if (shape.size() == 3 && shape[2] == 3 && options.format != "npy-grid" && options.columns.empty())
    return {file.path(), "npy", read_point_grid(file, header, options)};
  if (shape.size() != 2)
    throw FileError(
        file.path(),
        fmt::format("an array of shape {} is neither n x 3, n x 5 or n x 6 points, nor H x W heights, nor "
                    "H x W x 3 points{}",
                    shape_text(shape),
                    options.columns.empty() ? "" : " (and columns are named: n x k points only)"));
  if (options.format == "npy-grid") return {file.path(), "npy", read_heights(file, header, options)};
  if (!options.columns.empty()) {
    const std::vector<Role> roles = roles_of_option(options.columns, options.places);
    if (static_cast<Index>(roles.size()) != shape[1])
      throw FileError(file.path(), fmt::format("an array of shape {} has {} columns, but {} are named",
                                               shape_text(shape), shape[1], roles.size()));
    return {file.path(), "npy", read_points(file, header, roles, options)};
  }
  const std::vector<Role> roles = roles_of_count(shape[1]);
  if (roles.empty()) return {file.path(), "npy", read_heights(file, header, options)};
  return {file.path(), "npy", read_points(file, header, roles, options)};
}

}  // namespace knotfit
