#include "formats/point_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "formats/airfoil.h"
#include "formats/missing.h"
#include "formats/number.h"
#include "formats/point_line.h"
#include "formats/text_opening.h"
#include "knotfit/exceptions.h"
#include "knotfit/remedy.h"
namespace knotfit {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

std::string column_title(std::size_t column, Role role) {
  return role == Role::skip ? fmt::format("column {}", column + 1)
                            : fmt::format("column {} ({})", column + 1, role_name(role));
}

/// Finds out what is wrong with a line that the fast path refused, and says so.
[[noreturn]] void refuse_line(const FileBytes& file, const TextOpening& opening, const TextLine& line) {
  const std::vector<Role>& roles = opening.columns.roles;
  const auto fields = split_fields(line.text, opening.separator);
  if (fields.size() != roles.size())
    throw FileError(file.path(), line.number,
                    fmt::format("{} column{}, but {}{}", fields.size(), fields.size() == 1 ? "" : "s",
                                opening.origin, opening.hint));
  const std::string hint = line.number == opening.first.number ? opening.hint : "";
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (roles[i] == Role::skip) continue;
    const std::string title = column_title(i, roles[i]);
    const NumberStatus status = parse_number(fields[i]).status;
    if (status == NumberStatus::too_large)
      throw FileError(file.path(), line.number,
                      fmt::format("{}: {} is beyond the range of a double", title, in_quotes(fields[i])));
    if (status == NumberStatus::not_a_number && !is_missing_word(fields[i]))
      throw FileError(file.path(), line.number,
                      fmt::format("{}: {} is not a number{}", title, in_quotes(fields[i]),
                                  fields[i].find(',') == std::string_view::npos ? hint
                                  : fields[i].find('.') == std::string_view::npos
                                      ? " (write decimal points, not commas)"
                                      : " (write numbers without commas between thousands)"));
  }
  throw FileError(file.path(), line.number, "the line cannot be read");
}

/// A line between the points of a curve that names or counts those to come: words alone, one number, or GMT's >.
bool begins_block(const TextOpening& opening, const TextLine& line) {
  if (line.text.starts_with('>')) return true;
  const auto fields = split_fields(line.text, opening.separator);
  const auto is_number = [](std::string_view field) {
    return parse_number(field).status != NumberStatus::not_a_number;
  };
  if (fields.size() == 1 && is_number(fields[0])) return opening.columns.roles.size() > 1;
  const bool letters = std::any_of(line.text.begin(), line.text.end(),
                                   [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); });
  return letters && std::none_of(fields.begin(), fields.end(), is_number);
}

struct Row {
  double value[kRoles + 1];
  double operator[](Role role) const { return value[static_cast<int>(role)]; }
};

/// One block of those of a text, or all where there is one.
void take_block(const FileBytes& file, const ReadOptions& options, PointText& points) {
  const auto blocks = static_cast<Index>(points.group_start.size());
  if (options.block == 0 && !options.curve) return;
  if (options.block > blocks)
    throw FileError(file.path(), fmt::format("block {} is asked for, but there {} {}", options.block,
                                             blocks == 1 ? "is" : "are", blocks));
  if (blocks == 1) return;
  const auto end = [&](Index block) {
    return block < blocks ? points.group_start[block] : static_cast<Index>(points.table.line.size());
  };
  if (options.block == 0) {
    std::string sizes;
    for (Index b = 1; b <= std::min<Index>(blocks, 8); ++b)
      sizes += fmt::format("{}{} from line {}", b > 1 ? ", " : "", end(b) - points.group_start[b - 1],
                           points.table.line[points.group_start[b - 1]]);
    throw FileError(file.path(),
                    fmt::format("{} blocks of points ({}{}): a curve is one; {} "
                                "takes the block N, from 1",
                                blocks, sizes, blocks > 8 ? ", ..." : "", remedy_text(Remedy::block, "N")));
  }
  const Index first = points.group_start[options.block - 1], last = end(options.block);
  std::vector<Index> others;
  for (Index k = 0; k < static_cast<Index>(points.table.line.size()); ++k)
    if (k < first || k >= last) others.push_back(k);
  drop_points(points.table, others);
  std::vector<Index> missing;
  for (const Index k : points.missing)
    if (k >= first && k < last) missing.push_back(k - first);
  points.missing = std::move(missing);
  points.group_start = {0};
  points.notes.push_back(fmt::format("block {} of {}", options.block, blocks));
}

}  // namespace

PointText parse_point_text(const FileBytes& file, const ReadOptions& options) {
  const std::string_view text = text_of(file);
  TextOpening opening = open_point_text(file, options);
  PointText out;
  out.roles = opening.columns.roles;
  out.told = std::move(opening.columns.told);
  out.columns_from = opening.columns_from;
  out.notes = std::move(opening.notes);
  out.header = opening.header;
  out.separator = opening.separator;
  const bool xyz = only_xyz(out.roles);
  std::vector<Role> used;
  for (const Role role : out.roles)
    if (role != Role::skip) used.push_back(role);
  const auto has = [&](Role role) { return std::find(used.begin(), used.end(), role) != used.end(); };
  const bool has_z = has(Role::z);
  // What a nodata value stands in; of places alone none.
  const Role last = has_z || !options.curve ? Role::z : Role::y;
  // A line holds one digit a column and what parts them, at least.
  LineReader lines = opening.rest;
  TextLine line = opening.first;
  const std::size_t most = (lines.left() + line.text.size()) / (2 * used.size()) + 1;
  const std::size_t expected =
      std::min(most, static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1);
  for (const Role role : used) column_of(out.table, role)->reserve(expected);
  out.table.line.reserve(expected);

  Row row{};
  row.value[static_cast<int>(Role::z)] = kNan;
  std::vector<double*> into;
  for (const Role role : out.roles)
    into.push_back(role == Role::skip ? nullptr : row.value + static_cast<int>(role));
  bool gap = true;  // a blank line, or the beginning, stands before the next point
  do {
    if (is_empty_line(line.text)) {
      gap = true;
      continue;
    }
    if (is_comment(line.text)) continue;
    if (!parse_line(line, into, out.separator)) {
      if (!options.curve || !begins_block(opening, line)) refuse_line(file, opening, line);
      out.notes.push_back(
          fmt::format("line {} left out, above a block: {}", line.number, in_quotes(line.text)));
      gap = true;
      continue;
    }
    clear_unknown_normal(row.value);
    bool finite = true;
    for (const Role role : used) finite = finite && std::isfinite(row[role]);
    if (misses_value(row[last], finite, options.nodata)) {
      for (const Role role : {Role::x, Role::y, Role::z}) row.value[static_cast<int>(role)] = kNan;
      out.missing.push_back(static_cast<Index>(out.table.line.size()));
    } else if (!finite) {
      const bool in_block =
          options.block == 0 || static_cast<Index>(out.group_start.size()) + gap == options.block;
      if (in_block && out.not_finite.number == 0) out.not_finite = line;
      const bool hole =
          xyz && std::isnan(row[Role::x]) && std::isnan(row[Role::y]) && std::isnan(row[Role::z]);
      if (in_block && !hole && out.broken.number == 0) out.broken = line;
    }
    if (gap) out.group_start.push_back(static_cast<Index>(out.table.line.size()));
    gap = false;
    for (const Role role : used) column_of(out.table, role)->push_back(row[role]);
    out.table.line.push_back(line.number);
  } while (lines.next(line));
  drop_partial_normals(out.table);
  if (!has_z) out.table.z.assign(out.table.line.size(), kNan);
  if (opening.upper > 0 && options.block == 0) {
    out.joins = opening.upper;
    out.group_start = {0};
  }
  take_block(file, options, out);
  return out;
}

void refuse_not_finite(const FileBytes& file, const PointText& points, const TextLine& line) {
  auto fields = split_fields(line.text, points.separator);
  if (fields.size() < points.roles.size() && points.separator == Separator::tab)
    fields = split_fields(line.whole, points.separator);
  fields.resize(std::max(fields.size(), points.roles.size()));  // an empty cell at the end
  for (std::size_t i = 0; i < points.roles.size(); ++i) {
    const Role role = points.roles[i];
    if (role == Role::skip || (role >= Role::nx && role <= Role::nz)) continue;
    const std::string title = column_title(i, role);
    if (fields[i].empty())
      throw FileError(file.path(), line.number, fmt::format("{} is empty; {}", title, leave_out_hint()));
    const ParsedNumber number = parse_number(fields[i]);
    if (number.status == NumberStatus::ok && std::isfinite(number.value)) continue;
    throw FileError(
        file.path(), line.number,
        fmt::format("{}: {} is not a finite number; {}", title, in_quotes(fields[i]), leave_out_hint()));
  }
  throw FileError(file.path(), line.number, "a number is not finite");
}

}  // namespace knotfit
