// Meshes and tessellated surfaces as OBJ and PLY.
#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>
#include <ostream>
#include <string>

#include "formats/number.h"
#include "knotfit/exceptions.h"
#include "knotfit/mesh_io.h"
namespace knotfit {
namespace {

/// Text handed on in pieces.
class Pieces {
 public:
  explicit Pieces(std::ostream& out) : out_(out) {}
  ~Pieces() { flush(); }
  Pieces(const Pieces&) = delete;
  Pieces& operator=(const Pieces&) = delete;
  std::string& text() {
    if (text_.size() > 1 << 16) flush();
    return text_;
  }
  void numbers(const char* keyword, const double* values, int count) {
    std::string& line = text();
    line += keyword;
    for (int k = 0; k < count; ++k) {
      line += ' ';
      append_number(line, values[k]);
    }
    line += '\n';
  }
  template <class T>
  void bytes(T value) {
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    text().append(raw, sizeof(T));
  }

 private:
  void flush() {
    out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
  }
  std::ostream& out_;
  std::string text_;
};

constexpr const char* kByteOrder =
    std::endian::native == std::endian::big ? "binary_big_endian" : "binary_little_endian";

/// The two triangles of each cell of the grid, in the order that gives the surface's normal.
template <class Take>
void each_triangle(const Tessellation& t, const Take& take) {
  const auto columns = static_cast<std::int32_t>(t.v.size());
  for (std::int32_t i = 0; i + 1 < static_cast<std::int32_t>(t.u.size()); ++i)
    for (std::int32_t j = 0; j + 1 < columns; ++j) {
      const std::int32_t a = i * columns + j, b = a + columns;
      take(a, b, b + 1);
      take(a, b + 1, a + 1);
    }
}

void put_face(Pieces& out, std::int32_t a, std::int32_t b, std::int32_t c) {
  out.bytes(std::uint8_t{3});
  for (const std::int32_t corner : {a, b, c}) out.bytes(corner);
}

/// Vertices of faces that are not virtual, renumbered, and those faces.
struct RealPart {
  std::vector<Index> vertices;
  std::vector<std::array<std::int32_t, 3>> faces;
};

RealPart real_part(const Mesh& mesh) {
  if (!mesh.uv.empty() && mesh.uv.size() != static_cast<std::size_t>(2 * mesh.vertex_count()))
    throw InvalidInput(fmt::format("{} parameters for {} vertices", mesh.uv.size() / 2, mesh.vertex_count()));
  // A vertex that closes a hole has no face but virtual ones; one that nothing uses is data all the same.
  std::vector<char> real(static_cast<std::size_t>(mesh.vertex_count()), 0), hidden(real.size(), 0);
  RealPart out;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const bool data = mesh.virtual_face.empty() || !mesh.virtual_face[f];
    for (const std::int32_t v : mesh.faces[f]) (data ? real : hidden)[v] = 1;
    if (data) out.faces.push_back(mesh.faces[f]);
  }
  std::vector<std::int32_t> place(real.size(), -1);
  for (std::size_t v = 0; v < real.size(); ++v) {
    if (!real[v] && hidden[v]) continue;
    place[v] = static_cast<std::int32_t>(out.vertices.size());
    out.vertices.push_back(static_cast<Index>(v));
  }
  for (auto& c : out.faces)
    for (std::int32_t& v : c) v = place[v];
  return out;
}

}  // namespace

void write_obj(std::ostream& out, const Tessellation& t) {
  Pieces pieces(out);
  pieces.text() += fmt::format("# knotfit: surface, {} x {} points\n", t.u.size(), t.v.size());
  for (Index k = 0; k < t.size(); ++k) pieces.numbers("v", t.points.data() + 3 * k, 3);
  for (const double u : t.u)
    for (const double v : t.v) {
      const std::array<double, 2> uv = t.map.from_uv(u, v);
      pieces.numbers("vt", uv.data(), 2);
    }
  for (Index k = 0; k < t.size(); ++k) pieces.numbers("vn", t.normals.data() + 3 * k, 3);
  each_triangle(t, [&](std::int32_t a, std::int32_t b, std::int32_t c) {
    fmt::format_to(std::back_inserter(pieces.text()), "f {0}/{0}/{0} {1}/{1}/{1} {2}/{2}/{2}\n", a + 1, b + 1,
                   c + 1);
  });
}

void write_ply(std::ostream& out, const Tessellation& t) {
  Pieces pieces(out);
  std::string header =
      fmt::format("ply\nformat {} 1.0\ncomment knotfit: surface, {} x {} points\nelement vertex {}\n",
                  kByteOrder, t.u.size(), t.v.size(), t.size());
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "s", "t"})
    header += fmt::format("property double {}\n", name);
  if (!t.error.empty()) header += "property double error\n";
  header += "property double mean_curvature\nproperty double gaussian_curvature\n";
  header += fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                        2 * (t.u.size() - 1) * (t.v.size() - 1));
  pieces.text() += header;
  for (std::size_t i = 0; i < t.u.size(); ++i)
    for (std::size_t j = 0; j < t.v.size(); ++j) {
      const std::size_t k = i * t.v.size() + j;
      for (int d = 0; d < 3; ++d) pieces.bytes(t.points[3 * k + d]);
      for (int d = 0; d < 3; ++d) pieces.bytes(t.normals[3 * k + d]);
      for (const double a : t.map.from_uv(t.u[i], t.v[j])) pieces.bytes(a);
      if (!t.error.empty()) pieces.bytes(t.error[k]);
      pieces.bytes(t.mean_curvature[k]);
      pieces.bytes(t.gaussian_curvature[k]);
    }
  each_triangle(t, [&](std::int32_t a, std::int32_t b, std::int32_t c) { put_face(pieces, a, b, c); });
}

void write_obj(std::ostream& out, const Mesh& mesh) {
  const RealPart part = real_part(mesh);
  Pieces pieces(out);
  pieces.text() +=
      fmt::format("# knotfit: mesh, {} vertices, {} faces\n", part.vertices.size(), part.faces.size());
  for (const Index v : part.vertices) pieces.numbers("v", mesh.vertex(v), 3);
  if (!mesh.uv.empty())
    for (const Index v : part.vertices) pieces.numbers("vt", mesh.uv.data() + 2 * v, 2);
  for (const auto& c : part.faces)
    fmt::format_to(std::back_inserter(pieces.text()),
                   fmt::runtime(mesh.uv.empty() ? "f {} {} {}\n" : "f {0}/{0} {1}/{1} {2}/{2}\n"), c[0] + 1,
                   c[1] + 1, c[2] + 1);
}

void write_ply(std::ostream& out, const Mesh& mesh) {
  const RealPart part = real_part(mesh);
  Pieces pieces(out);
  pieces.text() += fmt::format(
      "ply\nformat {} 1.0\ncomment knotfit: mesh\nelement vertex {}\nproperty double x\nproperty double y\n"
      "property double z\n{}element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      kByteOrder, part.vertices.size(), mesh.uv.empty() ? "" : "property double s\nproperty double t\n",
      part.faces.size());
  for (const Index v : part.vertices) {
    for (int d = 0; d < 3; ++d) pieces.bytes(mesh.vertex(v)[d]);
    if (mesh.uv.empty()) continue;
    pieces.bytes(mesh.uv[2 * v]);
    pieces.bytes(mesh.uv[2 * v + 1]);
  }
  for (const auto& c : part.faces) put_face(pieces, c[0], c[1], c[2]);
}

}  // namespace knotfit
