#include "formats/columns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formats/number.h"
#include "formats/text_lines.h"
#include "knotfit/errors.h"
namespace knotfit {
namespace {

constexpr std::array<std::string_view, kRoles> kNames = {"x", "y", "z", "u", "v", "w", "nx", "ny", "nz"};

Index count(std::span<const Role> roles, Role role) {
  return std::count(roles.begin(), roles.end(), role);
}

}  // namespace

std::string_view role_name(Role role) {
  return role == Role::skip ? "-" : kNames[static_cast<std::size_t>(role)];
}

Role role_of(std::string_view name) {
  name = trimmed(name.substr(0, name.find_first_of("([")));  // "x [mm]"
  const std::string lower = lower_case(name);
  for (int r = 0; r < kRoles; ++r)
    if (lower == kNames[static_cast<std::size_t>(r)]) return static_cast<Role>(r);
  if (lower == "s") return Role::u;
  if (lower == "t") return Role::v;
  if (lower == "weight") return Role::w;
  if (lower == "normal_x") return Role::nx;
  if (lower == "normal_y") return Role::ny;
  if (lower == "normal_z") return Role::nz;
  return Role::skip;
}

std::vector<Role> roles_of_option(std::span<const std::string> names, bool places) {
  std::vector<Role> roles;
  for (const std::string& name : names) {
    const Role role = role_of(name);
    if (role == Role::skip && trimmed(name) != "-")
      throw InvalidInput(
          fmt::format("unknown column {}: columns are x, y, z, u, v, w, nx, ny, nz, and - for one to skip",
                      in_quotes(name)));
    roles.push_back(role);
  }
  if (const std::string why = objection(roles, places); !why.empty())
    throw InvalidInput(fmt::format("the columns {} make no points: {}", fmt::join(names, ","), why));
  return roles;
}

std::vector<Role> roles_of_count(Index columns) {
  std::vector<Role> roles = {Role::x, Role::y, Role::z};
  if (columns == 3) return roles;
  roles.insert(roles.end(), {Role::u, Role::v});
  if (columns == 5) return roles;
  roles.push_back(Role::w);
  if (columns == 6) return roles;
  return {};
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
