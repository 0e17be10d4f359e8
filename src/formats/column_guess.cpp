#include "formats/column_guess.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "knotfit/remedy.h"
namespace knotfit {
namespace {

/// What columns after x, y, z may be, some at a time.
enum class Group { intensity, other, parameters, weight, colour, normals };

std::size_t width(Group group) {
  if (group == Group::colour || group == Group::normals) return 3;
  return group == Group::parameters ? 2 : 1;
}

using Layout = std::vector<Group>;

/// Of a number of columns after x, y, z; of two whose used columns are the same the first is told.
std::vector<Layout> layouts_of(Index columns) {
  using enum Group;
  switch (columns) {
    case 3:
      return {{}};
    case 4:
      return {{intensity}};
    case 5:
      return {{parameters}, {other, other}};
    case 6:
      return {{parameters, weight}, {colour}, {normals}};
    case 7:
      return {{intensity, colour},
              {colour, intensity},
              {parameters, weight, intensity},
              {normals, other},
              {intensity, normals}};
    case 8:
      return {{parameters, colour}, {parameters, normals}, {normals, other, other}, {colour, other, other}};
    case 9:
      return {
          {colour, normals}, {normals, colour}, {parameters, weight, normals}, {parameters, weight, colour}};
    case 10:
      return {{intensity, colour, normals},
              {colour, normals, other},
              {normals, colour, other},
              {colour, intensity, normals}};
    default:
      return {};
  }
}

bool are_colours(const ColumnValues& values, std::size_t at) {
  bool whole = true, unit = true, bytes = true;
  for (std::size_t c = at; c < at + 3; ++c) {
    whole = whole && values.whole(c) && values.within(c, 0, 65535);
    unit = unit && values.within(c, 0, 1);
    bytes = bytes && values.within(c, 0, 255);
  }
  // Numbers up to 255 that are not whole: among more columns they could be anything.
  const bool broken =
      values.columns() == 6 || !(values.whole(at) || values.whole(at + 1) || values.whole(at + 2));
  return whole || unit || (bytes && broken && values.most(at) > 1 && values.most(at + 1) > 1);
}

bool are_parameters(const ColumnValues& values, std::size_t at, bool any) {
  bool flags = values.rows() > 4, slight = true;
  for (std::size_t c = at; c < at + 2; ++c) {
    if (values.rows() > 2 && values.constant(c)) return false;
    flags = flags && values.whole(c) && values.within(c, 0, 1);
    // Of five columns a little beyond [0,1] is a fault of parameters, which is told later by its line.
    const double beyond = values.columns() == 5 ? 0.5 : 0;
    slight = slight && values.within(c, -beyond, 1 + beyond);
  }
  return !flags && (any || slight);
}

bool allowed(const ColumnValues& values, Group group, std::size_t at, bool any_parameters) {
  switch (group) {
    case Group::parameters:
      return are_parameters(values, at, any_parameters);
    case Group::weight:
      return values.within(at, 1e-300, 1e300);
    case Group::colour:
      return are_colours(values, at);
    case Group::normals:
      return values.unit_vectors(at);
    default:
      return true;
  }
}

void append(Columns& columns, Group group) {
  const auto add = [&](std::initializer_list<Role> roles) {
    for (const Role role : roles) {
      columns.roles.push_back(role);
      columns.told.emplace_back(role_name(role));
    }
  };
  const auto leave = [&](std::initializer_list<const char*> names) {
    for (const char* name : names) {
      columns.roles.push_back(Role::skip);
      columns.told.emplace_back(name);
    }
  };
  switch (group) {
    case Group::parameters:
      return add({Role::u, Role::v});
    case Group::weight:
      return add({Role::w});
    case Group::normals:
      return add({Role::nx, Role::ny, Role::nz});
    case Group::colour:
      return leave({"r", "g", "b"});
    case Group::intensity:
      return leave({"intensity"});
    case Group::other:
      return leave({"-"});
  }
}

Columns columns_of(const Layout& layout) {
  Columns columns;
  for (const Role role : {Role::x, Role::y, Role::z}) {
    columns.roles.push_back(role);
    columns.told.emplace_back(role_name(role));
  }
  for (const Group group : layout) append(columns, group);
  return columns;
}

std::string option_of(const Columns& columns) {
  return remedy_text(Remedy::columns, fmt::format("{}", fmt::join(columns.told, ",")));
}

/// Every reading, as options; of those that use the same columns one.
std::string spelt_out(const std::vector<Columns>& readings, const std::string& last) {
  std::vector<std::string> options;
  std::vector<std::vector<Role>> seen;
  for (const Columns& c : readings) {
    if (std::find(seen.begin(), seen.end(), c.roles) != seen.end()) continue;
    seen.push_back(c.roles);
    options.push_back(option_of(c));
  }
  if (!last.empty()) options.push_back(remedy_text(Remedy::columns, last));
  std::string text;
  for (std::size_t k = 0; k < options.size(); ++k)
    text += (k == 0 ? "" : k + 1 == options.size() ? " or " : ", ") + options[k];
  return text;
}

}  // namespace

void ColumnValues::take(std::span<const double> row) {
  for (std::size_t c = 0; c < of_.size(); ++c) {
    Column& column = of_[c];
    const double x = row[c];
    if (c + 2 < of_.size()) {
      const double norm = std::hypot(x, row[c + 1], row[c + 2]);
      if (norm > 0) {  // not of a vector that misses a number
        column.unit = column.unit && std::abs(norm - 1) <= 0.02;
        ++column.vectors;
      }
    }
    column.counts = column.counts && (rows_ == 0 || x == column.last + 1);
    column.last = x;
    if (!std::isfinite(x)) continue;
    column.whole = column.whole && x == std::floor(x);
    column.least = column.seen ? std::min(column.least, x) : x;
    column.most = column.seen ? std::max(column.most, x) : x;
    column.seen = true;
  }
  ++rows_;
}

bool ColumnValues::within(std::size_t column, double least, double most) const {
  return !of_[column].seen || (of_[column].least >= least && of_[column].most <= most);
}

GuessedColumns guess_columns(const ColumnValues& values, bool any_parameters) {
  const Index k = values.columns();
  const std::vector<Layout> layouts = layouts_of(k);
  if (layouts.empty())
    return {{},
            fmt::format("{} column{} and no header line (without one 3 are x,y,z; up to 10 may hold "
                        "parameters, colours and normals too); name the columns with {}",
                        k, k == 1 ? "" : "s", remedy_text(Remedy::columns))};
  std::vector<Columns> all, fitting;
  bool normals = false;
  for (const Layout& layout : layouts) {
    all.push_back(columns_of(layout));
    std::size_t at = 3;
    bool fits = true;
    for (const Group group : layout) {
      fits = fits && allowed(values, group, at, any_parameters);
      at += width(group);
    }
    // Two columns that can be parameters are no two others.
    if (k == 5 && layout.front() == Group::other && !fitting.empty()) fits = false;
    if (!fits) continue;
    // Unit vectors in every row are normals: nothing else is by chance.
    const bool has = std::find(layout.begin(), layout.end(), Group::normals) != layout.end();
    if (has && !normals) fitting.clear();
    normals = normals || has;
    if (has || !normals) fitting.push_back(all.back());
  }
  const bool one = !fitting.empty() && std::all_of(fitting.begin(), fitting.end(), [&](const Columns& c) {
    return c.roles == fitting.front().roles;
  });
  const bool numbered = k > 3 && values.counts(0);
  if (one && !numbered) return {fitting.front(), {}};
  std::string last;
  if (numbered) {
    last = "-,x,y,z";
    for (Index c = 4; c < k; ++c) last += ",-";
  } else if (fitting.empty()) {
    last = "x,y,z";
    for (Index c = 3; c < k; ++c) last += ",-";
  }
  return {{},
          fmt::format("{} columns and no header line, and the values {}: say {}", k,
                      fitting.empty() ? "fit no known reading"
                      : numbered      ? "of the first may be a coordinate or the points' numbers"
                                      : "allow more than one reading",
                      spelt_out(fitting.empty() ? all : fitting, last))};
}

}  // namespace knotfit
