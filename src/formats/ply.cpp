// PLY: a mesh, or points where there are no faces.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formats/columns.h"
#include "formats/mesh_builder.h"
#include "formats/missing.h"
#include "formats/ply_rows.h"
#include "formats/readers.h"
#include "formats/text_lines.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

Role ply_role(const PlyProperty& p) {
  if (p.list) return Role::skip;
  const std::string name = lower_case(p.name);
  if (name == "texture_u") return Role::u;
  if (name == "texture_v") return Role::v;
  // role_of also takes units and quotes away, which property names do not have.
  for (const char* known : {"x", "y", "z", "u", "v", "s", "t", "w", "weight", "nx", "ny", "nz"})
    if (name == known) return role_of(name);
  return Role::skip;
}

/// Roles of the properties; of two that mean the same the first counts.
std::vector<Role> roles_of(const PlyElement& element) {
  std::vector<Role> roles;
  for (const PlyProperty& p : element.properties) {
    const Role role = ply_role(p);
    roles.push_back(std::find(roles.begin(), roles.end(), role) == roles.end() ? role : Role::skip);
  }
  return roles;
}

bool has(const std::vector<Role>& roles, Role role) {
  return std::find(roles.begin(), roles.end(), role) != roles.end();
}

const PlyElement* find(const PlyHeader& header, std::string_view name) {
  for (const PlyElement& e : header.elements)
    if (e.name == name) return &e;
  return nullptr;
}

class PlyReader {
 public:
  PlyReader(const FileBytes& file, const ReadOptions& options)
      : file_(file), options_(options), header_(parse_ply_header(file)), builder_(file, 0) {
    vertex_ = find(header_, "vertex");
    if (vertex_ == nullptr) throw FileError(file.path(), "the header has no element \"vertex\"");
    face_ = find(header_, "face");
    if (face_ != nullptr && face_->count == 0) face_ = nullptr;
    if (face_ == nullptr && find(header_, "tristrips") != nullptr)
      throw FileError(file.path(), "holds triangle strips, which are not read; save it with faces");
    roles_ = roles_of(*vertex_);
    for (const Role role : {Role::x, Role::y, Role::z})
      if (!has(roles_, role))
        throw FileError(file.path(), fmt::format("the vertices have no property {}", role_name(role)));
    parameters_ = has(roles_, Role::u) && has(roles_, Role::v);
    if (vertex_->count == 0) throw FileError(file.path(), "the header claims 0 vertices");
  }

  SourceData read() {
    rows_ = ply_rows(file_, header_);
    for (const PlyElement& element : header_.elements) {
      rows_->begin_element(element);
      if (&element == vertex_)
        read_vertices();
      else if (&element == face_)
        read_faces();
      else
        skip(element);
    }
    std::vector<std::string> notes;
    if (std::string after = rows_->end_file(); !after.empty()) notes.push_back(std::move(after));
    return face_ != nullptr ? mesh(std::move(notes)) : points(std::move(notes));
  }

 private:
  SourceData mesh(std::vector<std::string> notes) {
    Mesh mesh = builder_.finish();
    const std::vector<std::string> said = builder_.notes();
    notes.insert(notes.end(), said.begin(), said.end());
    return {.path = file_.path(), .format = "ply", .content = std::move(mesh), .notes = std::move(notes)};
  }

  SourceData points(std::vector<std::string> notes) {
    drop_points(points_, missing_);
    const Index left_out = static_cast<Index>(missing_.size()) + drop_far_nodata(points_, options_.nodata);
    if (points_.z.empty()) throw FileError(file_.path(), "every point has the nodata value");
    if (left_out > 0) notes.push_back(left_out_note(left_out, *options_.nodata));
    SourceData data{.path = file_.path(), .format = "ply", .content = std::move(points_)};
    data.notes = std::move(notes);
    data.columns = told();
    data.columns_from = "header";
    data.left_out = left_out;
    return data;
  }

  /// What each property of a point was taken for.
  std::vector<std::string> told() const {
    const bool normals = has(roles_, Role::nx) && has(roles_, Role::ny) && has(roles_, Role::nz);
    std::vector<std::string> names;
    for (std::size_t k = 0; k < roles_.size(); ++k) {
      const Role role = roles_[k];
      const bool used = role == Role::u || role == Role::v ? parameters_ : role >= Role::nx ? normals : true;
      names.push_back(told_name(used ? role : Role::skip, vertex_->properties[k].name));
    }
    return names;
  }

  bool text() const { return header_.encoding == PlyEncoding::ascii; }

  void skip_property(const PlyProperty& p) { rows_->skip(p.type, p.list ? rows_->next_count(p) : 1); }

  void skip(const PlyElement& element) {
    if (element.properties.empty()) return;
    for (Index row = 0; row < element.count; ++row) {
      rows_->begin_row(row);
      for (const PlyProperty& p : element.properties) skip_property(p);
      rows_->end_row();
    }
  }

  void read_vertices() {
    const auto n = static_cast<std::size_t>(vertex_->count);
    check_claim(file_, vertex_->count, "vertices", 0, 0);
    if (face_ != nullptr) {
      builder_.reserve(vertex_->count, 0, text());
    } else {
      for (const Role role : roles_)
        if (role != Role::skip) column_of(points_, role)->reserve(n);
      if (text()) points_.line.reserve(n);
    }
    for (Index row = 0; row < vertex_->count; ++row) {
      double value[kRoles + 1] = {};
      rows_->begin_row(row);
      for (std::size_t k = 0; k < roles_.size(); ++k) {
        if (roles_[k] == Role::skip)
          skip_property(vertex_->properties[k]);
        else
          value[static_cast<int>(roles_[k])] = rows_->next(vertex_->properties[k].type);
      }
      rows_->end_row();
      take_vertex(value, row);
    }
    // s without t, or points with a weight alone, are no parameters.
    if (!parameters_) points_.u.clear(), points_.v.clear();
    drop_partial_normals(points_);
  }

  void take_vertex(double* value, Index row) {
    const Index line = rows_->line();
    clear_unknown_normal(value);
    const auto matters = [this](Role role) {  // of a mesh the places alone: its parameters may be left aside
      return role == Role::x || role == Role::y || role == Role::z ||
             (face_ == nullptr && role != Role::skip);
    };
    bool finite = true;
    for (const Role role : roles_)
      finite = finite && (!matters(role) || std::isfinite(value[static_cast<int>(role)]));
    const bool misses = face_ == nullptr && misses_value(value[2], finite, options_.nodata);
    if (misses) missing_.push_back(row);
    for (const Role role : roles_)
      if (!misses && matters(role) && !std::isfinite(value[static_cast<int>(role)]))
        builder_.fail(line,
                      fmt::format("vertex {} (counted from 0): {} is not finite{}{}", row, role_name(role),
                                  face_ == nullptr ? "; " : "", face_ == nullptr ? leave_out_hint() : ""));
    if (face_ != nullptr) {
      builder_.add_vertex(value, line);
      if (parameters_)
        builder_.add_parameters(value[static_cast<int>(Role::u)], value[static_cast<int>(Role::v)]);
      return;
    }
    for (const Role role : roles_)
      if (role != Role::skip) column_of(points_, role)->push_back(value[static_cast<int>(role)]);
    if (line > 0 || options_.nodata) points_.line.push_back(line > 0 ? line : row + 1);
  }

  void read_faces() {
    const auto& properties = face_->properties;
    const auto named = [](std::initializer_list<std::string_view> names) {
      return [names](const PlyProperty& p) {
        return p.list && std::find(names.begin(), names.end(), p.name) != names.end();
      };
    };
    const auto corners =
        std::find_if(properties.begin(), properties.end(), named({"vertex_indices", "vertex_index"}));
    const auto wedge = std::find_if(properties.begin(), properties.end(), named({"texcoord"}));
    if (corners == properties.end())
      throw FileError(file_.path(), "the faces have no list property vertex_indices or vertex_index");
    check_claim(file_, face_->count, "faces", 0, 0);
    builder_.reserve(0, rows_->triangles(*face_, *corners, vertex_->count), text());
    std::vector<std::int32_t> face;
    std::vector<double> uv;
    for (Index row = 0; row < face_->count; ++row) {
      rows_->begin_row(row);
      uv.clear();
      for (auto p = properties.begin(); p != properties.end(); ++p) {
        if (p == corners) {
          const Index count = rows_->next_count(*p);
          builder_.check_corners(count, vertex_->count, rows_->line());
          face.clear();
          for (Index k = 0; k < count; ++k)
            face.push_back(builder_.corner(rows_->next(p->type), vertex_->count, rows_->line()));
        } else if (p == wedge && !parameters_) {
          const Index count = rows_->next_count(*p);
          for (Index k = 0; k < count; ++k) uv.push_back(rows_->next(p->type));
        } else {
          skip_property(*p);
        }
      }
      rows_->end_row();
      builder_.add_face(face, rows_->line(), vertex_->count);
      if (uv.size() == 2 * face.size())
        for (std::size_t k = 0; k < face.size(); ++k)
          if (std::isfinite(uv[2 * k]) && std::isfinite(uv[2 * k + 1]))
            builder_.set_corner_parameters(face[k], uv[2 * k], uv[2 * k + 1]);
    }
  }

  const FileBytes& file_;
  const ReadOptions& options_;
  PlyHeader header_;
  const PlyElement* vertex_ = nullptr;
  const PlyElement* face_ = nullptr;
  std::vector<Role> roles_;
  bool parameters_ = false;
  std::unique_ptr<PlyRows> rows_;
  MeshBuilder builder_;
  PointTable points_;
  std::vector<Index> missing_;  // of the points
};

}  // namespace

SourceData read_ply(const FileBytes& file, const ReadOptions& options) {
  return PlyReader(file, options).read();
}

}  // namespace knotfit
