#include "formats/columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formats/number.h"
#include "formats/text_lines.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

constexpr std::array<std::string_view, kRoles> kNames = {"x", "y", "z", "u", "v", "w", "nx", "ny", "nz"};

Index count(std::span<const Role> roles, Role role) {
  return std::count(roles.begin(), roles.end(), role);
}

/// "x" of "x [mm]".
std::string_view plain_name(std::string_view name) {
  return trimmed(name.substr(0, name.find_first_of("([")));
}

}  // namespace

std::string_view role_name(Role role) {
  return role == Role::skip ? "-" : kNames[static_cast<std::size_t>(role)];
}

Role role_of(std::string_view name) {
  const std::string lower = lower_case(plain_name(name));
  for (int r = 0; r < kRoles; ++r)
    if (lower == kNames[static_cast<std::size_t>(r)]) return static_cast<Role>(r);
  if (lower == "s") return Role::u;
  if (lower == "t") return Role::v;
  if (lower == "weight") return Role::w;
  if (lower == "normal_x" || lower == "normalx") return Role::nx;
  if (lower == "normal_y" || lower == "normaly") return Role::ny;
  if (lower == "normal_z" || lower == "normalz") return Role::nz;
  return Role::skip;
}

std::string_view attribute_of(std::string_view name) {
  // Of each list the first is the name in reports.
  constexpr std::string_view kAttributes[] = {
      "r red diffuse_red",
      "g green diffuse_green",
      "b blue diffuse_blue",
      "a alpha",
      "rgb rgba rgbcolor",
      "intensity i int reflectance reflectivity amplitude scalar_intensity",
      "time t timestamp gps_time gpstime",
      "class classification label",
      "return return_number returnnumber number_of_returns numberofreturns",
      "curvature",
      "index id idx nr no point_id"};
  const std::string wanted = " " + lower_case(plain_name(name)) + " ";
  if (wanted.find(' ', 1) + 1 != wanted.size() || wanted.size() < 3) return {};
  for (const std::string_view list : kAttributes)
    if (fmt::format(" {} ", list).find(wanted) != std::string::npos) return list.substr(0, list.find(' '));
  return {};
}

std::string told_name(Role role, std::string_view name) {
  if (role != Role::skip) return std::string(role_name(role));
  const std::string_view attribute = attribute_of(name);
  return std::string(attribute.empty() ? "-" : attribute);
}

Columns columns_of_header(std::span<const std::string_view> names) {
  const auto has = [&](std::string_view wanted) {
    return std::any_of(names.begin(), names.end(),
                       [&](std::string_view name) { return lower_case(plain_name(name)) == wanted; });
  };
  Columns columns;
  for (const std::string_view name : names) {
    const std::string lower = lower_case(plain_name(name));
    Role role = role_of(name);
    if (lower == "t" && (has("v") || !(has("s") || has("u")))) role = Role::skip;
    if (lower == "s" && !has("t") && !has("v")) role = Role::skip;
    columns.roles.push_back(role);
    columns.told.push_back(role == Role::skip && lower == "s" ? "s" : told_name(role, name));
  }
  return columns;
}

Columns columns_of_option(std::span<const std::string> names, bool places) {
  const std::vector<std::string_view> views(names.begin(), names.end());
  Columns columns = columns_of_header(views);
  for (std::size_t k = 0; k < views.size(); ++k)
    if (columns.told[k] == "-" && trimmed(views[k]) != "-")
      throw InvalidInput(
          fmt::format("unknown column {}: columns are x, y, z, u, v, w, nx, ny, nz; r, g, b, intensity, time "
                      "and others of a header are left out, and so is -",
                      in_quotes(views[k])));
  if (const std::string why = objection(columns.roles, places); !why.empty())
    throw InvalidInput(fmt::format("the columns {} make no points: {}", fmt::join(names, ","), why));
  return columns;
}

std::string objection(std::span<const Role> roles, bool places) {
  for (int r = 0; r < kRoles; ++r)
    if (count(roles, static_cast<Role>(r)) > 1)
      return fmt::format("{} is there more than once", role_name(static_cast<Role>(r)));
  const auto has = [&](Role role) { return count(roles, role) == 1; };
  if (!has(Role::z) && !places) return "there is no column z";
  if (has(Role::x) != has(Role::y))
    return fmt::format("{} is there without {}", has(Role::x) ? "x" : "y", has(Role::x) ? "y" : "x");
  if (has(Role::u) != has(Role::v))
    return fmt::format("{} is there without {}", has(Role::u) ? "u" : "v", has(Role::u) ? "v" : "u");
  if (!has(Role::x) && !has(Role::u)) return "there are neither x, y nor u, v";
  return {};
}

bool only_xyz(std::span<const Role> roles) {
  return std::all_of(roles.begin(), roles.end(), [](Role r) { return r <= Role::z || r == Role::skip; }) &&
         count(roles, Role::x) == 1 && count(roles, Role::y) == 1 && count(roles, Role::z) == 1;
}

std::vector<double>* column_of(PointTable& table, Role role) {
  const std::array<std::vector<double>*, kRoles> columns = {
      &table.x, &table.y, &table.z, &table.u, &table.v, &table.weight, &table.nx, &table.ny, &table.nz};
  return role == Role::skip ? nullptr : columns[static_cast<std::size_t>(role)];
}

void clear_unknown_normal(double* value) {
  double* normal = value + static_cast<int>(Role::nx);
  if (!std::isfinite(normal[0]) || !std::isfinite(normal[1]) || !std::isfinite(normal[2]))
    std::fill_n(normal, 3, 0.0);
}

void drop_partial_normals(PointTable& table) {
  if (table.nx.empty() || table.ny.empty() || table.nz.empty())
    table.nx.clear(), table.ny.clear(), table.nz.clear();
}

}  // namespace knotfit
