// What the columns of a table mean.
#pragma once
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "knotfit/index.h"
#include "knotfit/source_data.h"
namespace knotfit {

/// x y z u v w nx ny nz, or none of them.
enum class Role : int { x, y, z, u, v, w, nx, ny, nz, skip };
inline constexpr int kRoles = 9;

/// "x", "y", ... for messages.
std::string_view role_name(Role role);

/// The role of a name: letter case, quotes' blanks and a unit in brackets do not count; s and t
/// are u and v, "weight" is w, "normal_x" nx. \return skip where the name is unknown
Role role_of(std::string_view name);

/// What the columns of a file are.
struct Columns {
  std::vector<Role> roles;        ///< one a column
  std::vector<std::string> told;  ///< what each is called in reports: "x", "intensity"; "-": unknown
  bool empty() const { return roles.empty(); }
};

/// Columns by the names of a header. Colours, intensity, times and the like are known and left out. t is a time unless
/// s or u stands beside it, s something of its own unless t or v does.
Columns columns_of_header(std::span<const std::string_view> names);

/// Columns that a user named, by the names that a header may have; "-" leaves one out.
/// \throws InvalidInput  an unknown name, or a set of columns that makes no points
Columns columns_of_option(std::span<const std::string> names, bool places = false);

/// What a name that no role has stands for, and is left out: "r", "intensity", "time". Empty: an unknown name.
std::string_view attribute_of(std::string_view name);

/// What a column is called in reports: its role, else what attribute_of() its name says, "-" where that is nothing.
std::string told_name(Role role, std::string_view name);

/// Why these columns make no points, or empty where they do: z is needed, x and y go together,
/// u and v too, x,y or u,v must be there, and none twice.
/// \param places  points without z will do
std::string objection(std::span<const Role> roles, bool places = false);

/// Exactly x, y and z beside skipped columns.
bool only_xyz(std::span<const Role> roles);

/// The column of a table that takes a role; skip gives nullptr.
std::vector<double>* column_of(PointTable& table, Role role);

/// Of the values of a point, by role: a normal that is not finite is unknown, (0, 0, 0).
void clear_unknown_normal(double* value);
/// Normals that lack a column are none.
void drop_partial_normals(PointTable& table);

}  // namespace knotfit
