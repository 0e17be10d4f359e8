// PCD, files of the Point Cloud Library: points, or a camera's grid of points.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "formats/columns.h"
#include "formats/lzf.h"
#include "formats/mesh_builder.h"
#include "formats/missing.h"
#include "formats/number.h"
#include "formats/pcd_header.h"
#include "formats/readers.h"
#include "formats/text_lines.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

constexpr Role kTaken[] = {Role::x, Role::y, Role::z, Role::u, Role::v, Role::nx, Role::ny, Role::nz};

/// x, y, z and, where all of them are there, u and v, and the normals.
struct Fields {
  std::array<Index, kRoles> at;
  std::vector<Role> used;
};

Fields find_fields(const FileBytes& file, const PcdHeader& header) {
  Fields fields;
  fields.at.fill(-1);
  for (std::size_t f = header.fields.size(); f-- > 0;) {
    const std::string& name = header.fields[f].name;
    for (const Role role : kTaken)
      if (name == role_name(role) ||
          (role >= Role::nx && name == fmt::format("normal_{}", role_name(role).substr(1))))
        fields.at[static_cast<std::size_t>(role)] = static_cast<Index>(f);
  }
  const auto has = [&](Role role) { return fields.at[static_cast<std::size_t>(role)] >= 0; };
  for (const Role role : {Role::x, Role::y, Role::z})
    if (!has(role)) throw FileError(file.path(), fmt::format("the points have no field {}", role_name(role)));
  const bool parameters = has(Role::u) && has(Role::v),
             normals = has(Role::nx) && has(Role::ny) && has(Role::nz);
  for (const Role role : kTaken)
    if (role <= Role::z || (role <= Role::v ? parameters : normals)) fields.used.push_back(role);
  return fields;
}

/// What each field was taken for; padding is none.
std::vector<std::string> told(const PcdHeader& header, const Fields& fields) {
  std::vector<std::string> names;
  for (std::size_t f = 0; f < header.fields.size(); ++f) {
    const std::string& name = header.fields[f].name;
    Role taken = Role::skip;
    for (const Role role : fields.used)
      if (fields.at[static_cast<std::size_t>(role)] == static_cast<Index>(f)) taken = role;
    if (name != "_") names.push_back(told_name(taken, name));
  }
  return names;
}

class Points {
 public:
  Points(const FileBytes& file, const PcdHeader& header, const ReadOptions& options)
      : file_(file), header_(header), fields_(find_fields(file, header)), options_(options) {
    grid_ = header.height > 1;
    for (const Role role : fields_.used)
      column_of(table_, role)->reserve(static_cast<std::size_t>(header.points));
  }

  /// \param value  by role
  void take(double* value, Index point, Index line) {
    clear_unknown_normal(value);
    bool finite = true;
    for (const Role role : fields_.used) finite = finite && std::isfinite(value[static_cast<int>(role)]);
    bool hole = misses_value(value[2], finite, options_.nodata);
    // In a camera's grid a point without coordinates is a pixel that saw nothing.
    for (int c = 0; c < 3 && grid_; ++c) hole = hole || std::isnan(value[c]);
    for (const Role role : fields_.used)
      if (!hole && !std::isfinite(value[static_cast<int>(role)])) {
        const std::string message = fmt::format("point {} (from 1): {} is not finite; {}", point + 1,
                                                role_name(role), leave_out_hint());
        if (line > 0) throw FileError(file_.path(), static_cast<long long>(line), message);
        throw FileError(file_.path(), message);
      }
    holes_ += hole;
    if (hole && !grid_) return;
    for (const Role role : fields_.used)
      column_of(table_, role)->push_back(hole ? kNan : value[static_cast<int>(role)]);
    lines_.push_back(line > 0 ? line : point + 1);
  }

  SourceData finish() {
    if (holes_ == header_.points) throw FileError(file_.path(), "every point is NaN or has the nodata value");
    if (!grid_) {
      table_.line = std::move(lines_);
      SourceData data{.path = file_.path(), .format = "pcd", .content = PointTable{}};
      data.left_out = holes_ + drop_far_nodata(table_, options_.nodata);
      if (table_.z.empty()) throw FileError(file_.path(), "every point has the nodata value");
      if (data.left_out > 0) data.notes.push_back(left_out_note(data.left_out, *options_.nodata));
      if (data.left_out == 0 && header_.encoding != PcdEncoding::ascii) table_.line.clear();
      data.content = std::move(table_);
      data.columns = told(header_, fields_);
      data.columns_from = "header";
      return data;
    }
    PointRows rows;
    rows.xyz.reserve(static_cast<std::size_t>(3 * header_.points));
    for (Index k = 0; k < header_.points; ++k)
      rows.xyz.insert(rows.xyz.end(), {table_.x[k], table_.y[k], table_.z[k]});
    for (Index r = 0; r <= header_.height; ++r) rows.row_start.push_back(r * header_.width);
    SourceData data{.path = file_.path(), .format = "pcd", .content = std::move(rows)};
    // A camera's grid has its own neighbours: only the places are taken.
    fields_.used.assign({Role::x, Role::y, Role::z});
    data.columns = told(header_, fields_);
    data.columns_from = "header";
    return data;
  }

  const Fields& fields() const { return fields_; }

 private:
  const FileBytes& file_;
  const PcdHeader& header_;
  Fields fields_;
  const ReadOptions& options_;
  bool grid_ = false;
  Index holes_ = 0;
  PointTable table_;
  std::vector<Index> lines_;
};

void check_size(const FileBytes& file, const PcdHeader& header, double bytes_each, std::size_t left) {
  const double bytes = static_cast<double>(header.points) * bytes_each;
  const bool text = header.encoding == PcdEncoding::ascii;
  if (bytes > static_cast<double>(left) + (text ? 1 : 0))  // the last line may have no end
    throw FileError(file.path(),
                    fmt::format("the header claims {} points, which take {:.0f} bytes{}, but only {} bytes "
                                "follow; it is cut off",
                                header.points, bytes, text ? " at least" : "", left));
}

void read_text(const FileBytes& file, const PcdHeader& header, const ReadOptions& options, SourceData& data) {
  LineReader lines(text_of(file).substr(header.offset));
  Index numbers = 0;
  for (const PcdField& field : header.fields) numbers += field.count;
  // A number takes a digit and what parts it from the next.
  check_size(file, header, 2 * static_cast<double>(numbers), lines.left());
  Points points(file, header, options);
  std::vector<Index> first;  // number of the line that a field begins with
  for (Index at = 0; const PcdField& field : header.fields) first.push_back(at), at += field.count;
  TextLine line;
  Index point = 0;
  while (lines.next(line)) {
    if (line.text.empty()) continue;
    const auto number = static_cast<long long>(line.number + header.lines);
    if (point == header.points)
      throw FileError(file.path(), number, "data after the last point that the header claims");
    const auto words = split_fields(line.text, Separator::blanks);
    if (static_cast<Index>(words.size()) != numbers)
      throw FileError(file.path(), number,
                      fmt::format("{} numbers, but the header's fields have {}", words.size(), numbers));
    double value[kRoles] = {};
    for (const Role role : points.fields().used) {
      const auto c = static_cast<std::size_t>(role);
      const std::string_view word =
          words[static_cast<std::size_t>(first[static_cast<std::size_t>(points.fields().at[c])])];
      ParsedNumber parsed = parse_number(word);
      if (parsed.status == NumberStatus::not_a_number && is_missing_word(word))
        parsed = {NumberStatus::ok, kNan};
      if (parsed.status != NumberStatus::ok)
        throw FileError(file.path(), number,
                        fmt::format("{}: {} is not a number", role_name(role), in_quotes(word)));
      value[c] = parsed.value;
    }
    points.take(value, point++, number);
  }
  if (point < header.points)
    throw FileError(file.path(),
                    fmt::format("ends after {} of the {} points that the header claims; it is cut off", point,
                                header.points));
  data = points.finish();
}

/// Numbers of point after point: beside each other, or field by field (compressed).
void read_numbers(std::string_view bytes, const PcdHeader& header, bool padding, Points& points) {
  const Fields& fields = points.fields();
  const char* start[kRoles] = {};
  Index step[kRoles] = {};
  LoadNumber load[kRoles] = {};
  const bool apart = header.encoding == PcdEncoding::compressed;
  Index at = 0;
  for (std::size_t f = 0; f < header.fields.size(); ++f) {
    const PcdField& field = header.fields[f];
    for (const Role role : fields.used)
      if (const auto c = static_cast<std::size_t>(role); fields.at[c] == static_cast<Index>(f)) {
        start[c] = bytes.data() + at;
        step[c] = apart ? field.bytes() : header.point_bytes();
        load[c] = number_loader(field.type, false);
      }
    if (!apart)
      at += field.bytes();
    else if (padding || field.name != "_")
      at += field.bytes() * header.points;
  }
  for (Index k = 0; k < header.points; ++k) {
    double value[kRoles] = {};
    for (const Role role : fields.used) {
      const auto c = static_cast<std::size_t>(role);
      value[c] = load[c](start[c] + k * step[c]);
    }
    points.take(value, k, 0);
  }
}

std::string unpacked(const FileBytes& file, const PcdHeader& header, bool& padding) {
  const std::string_view left = file.view().substr(header.offset);
  if (left.size() < 8)
    throw FileError(file.path(), "ends before the sizes of its compressed data: it is cut off");
  const auto size = [&](std::size_t at) {
    return static_cast<std::size_t>(number_loader({'u', 4}, false)(left.data() + at));
  };
  const std::size_t packed = size(0), whole = size(4);
  if (packed > left.size() - 8)
    throw FileError(file.path(),
                    fmt::format("the header claims {} compressed bytes, but only {} follow; it is cut off",
                                packed, left.size() - 8));
  double all = 0, named = 0;
  for (const PcdField& field : header.fields) {
    const double bytes = static_cast<double>(field.bytes()) * static_cast<double>(header.points);
    all += bytes;
    if (field.name != "_") named += bytes;
  }
  // PCL leaves padding out of compressed data; others may not.
  padding = static_cast<double>(whole) == all;
  if (!padding && static_cast<double>(whole) != named)
    throw FileError(file.path(),
                    fmt::format("{} points take {:.0f} bytes, but the compressed data stands for {}",
                                header.points, named, whole));
  std::optional<std::string> bytes = decompress_lzf(left.substr(8, packed), whole);
  if (!bytes) throw FileError(file.path(), "the compressed data is damaged");
  return std::move(*bytes);
}

}  // namespace

SourceData read_pcd(const FileBytes& file, const ReadOptions& options) {
  const PcdHeader header = parse_pcd_header(file);
  SourceData data;
  if (header.encoding == PcdEncoding::ascii) {
    read_text(file, header, options, data);
    return data;
  }
  const std::string_view left = file.view().substr(header.offset);
  bool padding = true;
  std::string bytes;
  if (header.encoding == PcdEncoding::compressed)
    bytes = unpacked(file, header, padding);
  else
    check_size(file, header, static_cast<double>(header.point_bytes()), left.size());
  check_claim(file, header.points, "points", 0, 0);
  Points points(file, header, options);
  read_numbers(header.encoding == PcdEncoding::compressed ? std::string_view(bytes) : left, header, padding,
               points);
  return points.finish();
}

}  // namespace knotfit
