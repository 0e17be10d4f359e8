#include "formats/point_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "formats/nodata.h"
#include "formats/number.h"
#include "knotfit/errors.h"
namespace knotfit {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A line of separators alone (a spreadsheet's empty row) counts as blank.
bool is_empty_line(std::string_view line) {
  return line.find_first_not_of(",; \t\r\f\v") == std::string_view::npos;
}

bool is_number(std::string_view field) {
  return parse_number(field).status != NumberStatus::not_a_number;
}

std::string list_of(const std::vector<std::string_view>& fields) {
  std::string out;
  for (std::size_t i = 0; i < fields.size() && i < 12; ++i) out += (i > 0 ? ", " : "") + in_quotes(fields[i]);
  return out + (fields.size() > 12 ? ", ..." : "");
}

std::string column_title(std::size_t column, Role role) {
  return role == Role::skip ? fmt::format("column {}", column + 1)
                            : fmt::format("column {} ({})", column + 1, role_name(role));
}

/// What the first lines tell: header, columns, separator.
class Opening {
 public:
  Opening(const FileBytes& file, const ReadOptions& options) : file_(file), places_(options.places) {
    if (!options.columns.empty()) {
      roles = roles_of_option(options.columns, places_);
      named_by_option_ = true;
    }
  }

  /// \return true when the line is the first with data, false when it was a header
  bool take_content(const TextLine& line) {
    separator = find_separator(line.text);
    std::vector<std::string_view> fields = split_fields(line.text, separator);
    if (!header && is_header(fields)) {
      header = true;
      if (!named_by_option_) take_header(line, fields);
      return false;
    }
    if (separator == Separator::tab && blanks_part(fields, line.text)) {
      separator = Separator::blanks;
      fields = split_fields(line.text, separator);
    }
    if (roles.empty()) take_count(line, fields);
    first = line;
    return true;
  }

  void take_comment(std::string_view text) {
    comment_ = trimmed(text.substr(std::min(text.find_first_not_of("#%/"), text.size())));
  }

  std::vector<Role> roles;
  Separator separator = Separator::blanks;
  bool header = false;
  TextLine first;

  /// Where the number of columns comes from, for messages.
  std::string origin() const {
    if (named_by_option_) return fmt::format("{} are named", roles.size());
    if (header) return fmt::format("the header names {}", roles.size());
    return fmt::format("line {} has {}", first.number, roles.size());
  }

 private:
  bool is_header(const std::vector<std::string_view>& fields) const {
    if (named_by_option_) {
      for (std::size_t i = 0; i < fields.size() && i < roles.size(); ++i)
        if (roles[i] != Role::skip && is_number(fields[i])) return false;
      return fields.size() == roles.size() || !std::any_of(fields.begin(), fields.end(), is_number);
    }
    if (std::any_of(fields.begin(), fields.end(), [](auto f) { return role_of(f) != Role::skip; }))
      return true;
    return std::none_of(fields.begin(), fields.end(), is_number);
  }

  void take_header(const TextLine& line, const std::vector<std::string_view>& fields) {
    for (const std::string_view field : fields) roles.push_back(role_of(field));
    if (const std::string why = objection(roles, places_); !why.empty())
      throw FileError(
          file_.path(), line.number,
          fmt::format("{} in the header {}; name the columns with --columns", why, list_of(fields)));
  }

  /// A blank inside a tab's field: tabs and blanks are mixed, and both part the columns.
  bool blanks_part(const std::vector<std::string_view>& fields, std::string_view line) const {
    const std::size_t by_blanks = split_fields(line, Separator::blanks).size();
    if (!roles.empty()) return fields.size() != roles.size() && by_blanks == roles.size();
    return by_blanks != fields.size();
  }

  void take_count(const TextLine& line, const std::vector<std::string_view>& fields) {
    // A comment right before the data may be its header, as NumPy's savetxt writes it.
    const auto names = split_fields(comment_, find_separator(comment_));
    if (names.size() == fields.size()) {
      for (const std::string_view name : names) roles.push_back(role_of(name));
      if (objection(roles, places_).empty()) return;
    }
    roles = roles_of_count(static_cast<Index>(fields.size()));
    if (roles.empty())
      throw FileError(file_.path(), line.number,
                      fmt::format("{} column{} and no header line (without one 3 are x,y,z, 5 are x,y,z,u,v "
                                  "and 6 are x,y,z,u,v,w); name the columns with --columns",
                                  fields.size(), fields.size() == 1 ? "" : "s"));
  }

  const FileBytes& file_;
  bool places_;
  bool named_by_option_ = false;
  std::string_view comment_;
};

/// Finds out what is wrong with a line that the fast path refused, and says so.
[[noreturn]] void refuse_line(const FileBytes& file, const Opening& opening, const TextLine& line) {
  const auto fields = split_fields(line.text, opening.separator);
  if (fields.size() != opening.roles.size())
    throw FileError(
        file.path(), line.number,
        fmt::format("{} column{}, but {}", fields.size(), fields.size() == 1 ? "" : "s", opening.origin()));
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (opening.roles[i] == Role::skip) continue;
    const std::string title = column_title(i, opening.roles[i]);
    if (fields[i].empty()) throw FileError(file.path(), line.number, title + " is empty");
    const NumberStatus status = parse_number(fields[i]).status;
    if (status == NumberStatus::too_large)
      throw FileError(file.path(), line.number,
                      fmt::format("{}: {} is beyond the range of a double", title, in_quotes(fields[i])));
    if (status == NumberStatus::not_a_number)
      throw FileError(
          file.path(), line.number,
          fmt::format(
              "{}: {} is not a number{}", title, in_quotes(fields[i]),
              fields[i].find(',') != std::string_view::npos ? " (write decimal points, not commas)" : ""));
  }
  throw FileError(file.path(), line.number, "the line cannot be read");
}

/// Fills row[role] from a line. \return false where something is wrong with it
bool parse_line(std::string_view text, std::span<const Role> roles, Separator separator, double* row) {
  const char* p = text.data();
  const char* const end = p + text.size();
  const bool blanks = separator == Separator::blanks;
  const char mark = static_cast<char>(separator);
  const std::size_t columns = roles.size();
  bool parted = false;  // a separator was the last thing read
  for (std::size_t column = 0;; ++column) {
    while (p < end && is_blank(*p) && (blanks || *p != mark)) ++p;
    if (column == columns) return p == end || is_comment({p, static_cast<std::size_t>(end - p)});
    // Nothing is left: good only for a last column that is skipped and empty.
    if (p == end) return parted && column + 1 == columns && roles[column] == Role::skip;
    const char* next = nullptr;
    if (roles[column] == Role::skip) {
      next = field_end(p, end, separator);
    } else {
      double& value = row[static_cast<int>(roles[column])];
      next = parse_prefix(p, end, value);
      if (next == p || (next < end && *next != mark && !is_blank(*next))) {
        next = field_end(p, end, separator);
        std::string_view token = trimmed({p, static_cast<std::size_t>(next - p)});
        if (token.size() >= 2 && token.front() == '"' && token.back() == '"')
          token = trimmed(token.substr(1, token.size() - 2));
        const ParsedNumber parsed = parse_number(token);
        if (parsed.status != NumberStatus::ok) return false;
        value = parsed.value;
      }
    }
    if (!blanks) {
      while (next < end && is_blank(*next) && *next != mark) ++next;
      parted = next < end && *next == mark;
      if (parted)
        ++next;
      else if (next < end &&
               (column + 1 < columns || !is_comment({next, static_cast<std::size_t>(end - next)})))
        return false;
    }
    p = next;
  }
}

struct Row {
  double value[kRoles + 1];
  double operator[](Role role) const { return value[static_cast<int>(role)]; }
};

}  // namespace

PointText parse_point_text(const FileBytes& file, const ReadOptions& options) {
  const std::string_view text = text_of(file);
  LineReader lines(text);
  Opening opening(file, options);
  PointText out;
  TextLine line;
  Index last_header = 0;
  bool found = false;
  while (!found && lines.next(line)) {
    if (is_empty_line(line.text)) continue;
    if (is_comment(line.text)) {
      opening.take_comment(line.text);
    } else if (!lower_case(line.text).starts_with("sep=")) {  // a spreadsheet's note on its separator
      found = opening.take_content(line);
      if (!found) last_header = line.number;
    }
  }
  if (!found)
    throw FileError(file.path(),
                    last_header > 0
                        ? fmt::format("there is no data line after the header (line {})", last_header)
                        : std::string("there is no line with data"));

  out.roles = opening.roles;
  out.header = opening.header;
  out.separator = opening.separator;
  const bool xyz = only_xyz(out.roles);
  std::vector<Role> used;
  for (const Role role : out.roles)
    if (role != Role::skip) used.push_back(role);
  const bool has_z = std::find(used.begin(), used.end(), Role::z) != used.end();
  const bool has_xy = std::find(used.begin(), used.end(), Role::x) != used.end();
  // A line holds one digit a column and what parts them, at least.
  const std::size_t most = (lines.left() + line.text.size()) / (2 * used.size()) + 1;
  const std::size_t expected =
      std::min(most, static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n')) + 1);
  for (const Role role : used) column_of(out.table, role)->reserve(expected);
  out.table.line.reserve(expected);

  Row row{};
  bool gap = true;  // a blank line, or the beginning, stands before the next point
  do {
    if (is_empty_line(line.text)) {
      gap = true;
      continue;
    }
    if (is_comment(line.text)) continue;
    if (!parse_line(line.text, out.roles, out.separator, row.value)) refuse_line(file, opening, line);
    clear_unknown_normal(row.value);
    bool finite = true;
    for (const Role role : used) finite = finite && std::isfinite(row[role]);
    if (has_z && options.nodata && is_nodata(row[Role::z], *options.nodata)) {
      row.value[static_cast<int>(Role::z)] = kNan;
      if (has_xy) row.value[static_cast<int>(Role::x)] = row.value[static_cast<int>(Role::y)] = kNan;
      ++out.holes;
    } else if (!finite) {
      if (out.not_finite.number == 0) out.not_finite = line;
      const bool hole =
          xyz && std::isnan(row[Role::x]) && std::isnan(row[Role::y]) && std::isnan(row[Role::z]);
      if (!hole && out.broken.number == 0) out.broken = line;
    }
    if (gap) out.group_start.push_back(static_cast<Index>(out.table.line.size()));
    gap = false;
    for (const Role role : used) column_of(out.table, role)->push_back(row[role]);
    out.table.line.push_back(line.number);
  } while (lines.next(line));
  drop_partial_normals(out.table);
  if (!has_z) out.table.z.assign(out.table.line.size(), kNan);
  return out;
}

void refuse_not_finite(const FileBytes& file, const PointText& points, const TextLine& line) {
  const auto fields = split_fields(line.text, points.separator);
  for (std::size_t i = 0; i < fields.size() && i < points.roles.size(); ++i) {
    if (points.roles[i] == Role::skip) continue;
    if (!std::isfinite(parse_number(fields[i]).value))
      throw FileError(file.path(), line.number,
                      fmt::format("{}: {} is not a finite number", column_title(i, points.roles[i]),
                                  in_quotes(fields[i])));
  }
  throw FileError(file.path(), line.number, "a number is not finite");
}

}  // namespace knotfit
