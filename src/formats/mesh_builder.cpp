#include "formats/mesh_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr Index kMost = std::numeric_limits<std::int32_t>::max() / 3 - 1;
// Up to as many, faces without sense are left to the check of the mesh; more would fill the memory first, since
// a corner of one byte makes a triangle of sixteen.
constexpr Index kMany = 1000000;

}  // namespace

MeshBuilder::MeshBuilder(const FileBytes& file, Index counted_from) : file_(file) {
  mesh_.counted_from = counted_from;
}

void MeshBuilder::reserve(Index vertices, Index triangles, bool lines) {
  triangles = std::clamp<Index>(triangles, 0, kMost);
  mesh_.vertices.reserve(static_cast<std::size_t>(3 * vertices));
  mesh_.faces.reserve(static_cast<std::size_t>(triangles));
  if (!lines) return;
  mesh_.vertex_line.reserve(static_cast<std::size_t>(vertices));
  mesh_.face_line.reserve(static_cast<std::size_t>(triangles));
}

void MeshBuilder::fail(Index line, const std::string& message) const {
  if (line > 0) throw FileError(file_.path(), static_cast<long long>(line), message);
  throw FileError(file_.path(), message);
}

void MeshBuilder::add_vertex(const double* xyz, Index line) {
  for (int d = 0; d < 3; ++d)
    if (!std::isfinite(xyz[d]))
      fail(line, fmt::format("vertex {} (counted from {}): {} is not finite",
                             vertex_count() + mesh_.counted_from, mesh_.counted_from, "xyz"[d]));
  mesh_.vertices.insert(mesh_.vertices.end(), xyz, xyz + 3);
  if (line > 0) mesh_.vertex_line.push_back(line);
}

void MeshBuilder::check_corners(Index count, Index vertices, Index line) const {
  if (count > vertices)
    fail(line, fmt::format("face {} (counted from {}) has {} corners, but there are {} vertices",
                           faces_ + mesh_.counted_from, mesh_.counted_from, count, vertices));
}

void MeshBuilder::add_face(std::span<const std::int32_t> corners, Index line, Index vertices) {
  if (corners.size() < 3)
    fail(line, fmt::format("face {} (counted from {}) has {} corner{}; a face has three or more",
                           faces_ + mesh_.counted_from, mesh_.counted_from, corners.size(),
                           corners.size() == 1 ? "" : "s"));
  const std::size_t triangles = corners.size() - 2;
  if (mesh_.face_count() + static_cast<Index>(triangles) > kMost)
    fail(line, fmt::format("more than {} triangles", kMost));
  if (const Index total = mesh_.face_count() + static_cast<Index>(triangles);
      total > kMany &&
      static_cast<double>(total) > static_cast<double>(vertices) * static_cast<double>(vertices - 1) / 3)
    fail(line,
         fmt::format("face {} (counted from {}) is triangle {} on {} vertices: some edge has more than two "
                     "faces; such a mesh is no surface",
                     faces_ + mesh_.counted_from, mesh_.counted_from, total, vertices));
  if (triangles > 1 && mesh_.face_source.empty()) {
    mesh_.face_source.reserve(mesh_.faces.capacity());
    for (Index f = 0; f < faces_; ++f) mesh_.face_source.push_back(static_cast<std::int32_t>(f));
  }
  const bool sources = triangles > 1 || !mesh_.face_source.empty();
  for (std::size_t k = 0; k < triangles; ++k) {
    mesh_.faces.push_back({corners[0], corners[k + 1], corners[k + 2]});
    if (sources) mesh_.face_source.push_back(static_cast<std::int32_t>(faces_));
    if (line > 0) mesh_.face_line.push_back(line);
  }
  ++faces_;
}

void MeshBuilder::add_parameters(double u, double v) {
  mesh_.uv.push_back(u);
  mesh_.uv.push_back(v);
}

void MeshBuilder::set_corner_parameters(std::int32_t vertex, double u, double v) {
  if (!dropped_.empty()) return;
  const std::size_t at = 2 * static_cast<std::size_t>(vertex);
  if (corner_uv_.size() < at + 2) corner_uv_.resize(std::max(at + 2, 2 * mesh_.vertices.size() / 3), kNan);
  if (std::isnan(corner_uv_[at])) {
    corner_uv_[at] = u;
    corner_uv_[at + 1] = v;
  } else if (corner_uv_[at] != u || corner_uv_[at + 1] != v) {
    seam_.push_back(vertex);
  }
}

void MeshBuilder::drop_parameters(const std::string& why) {
  if (dropped_.empty()) dropped_ = why;
}

std::int32_t MeshBuilder::corner(double value, Index vertices, Index line) const {
  if (!(value >= 0 && value < static_cast<double>(vertices)) || value != std::floor(value)) {
    const auto from = static_cast<double>(mesh_.counted_from);
    fail(line, fmt::format("face {} (counted from {}) names vertex {}, but there are {} vertices, {} to {}",
                           faces_ + mesh_.counted_from, mesh_.counted_from, value + from, vertices,
                           mesh_.counted_from, vertices - 1 + mesh_.counted_from));
  }
  return static_cast<std::int32_t>(value);
}

PointTable MeshBuilder::points() {
  leave_parameters_aside("points'", "points");
  PointTable points;
  const auto n = static_cast<std::size_t>(mesh_.vertex_count());
  const auto column = [n](const std::vector<double>& from, std::size_t width, std::size_t d) {
    std::vector<double> out(n);
    for (std::size_t k = 0; k < n; ++k) out[k] = from[width * k + d];
    return out;
  };
  points.x = column(mesh_.vertices, 3, 0);
  points.y = column(mesh_.vertices, 3, 1);
  points.z = column(mesh_.vertices, 3, 2);
  if (mesh_.uv.size() == 2 * n) {
    points.u = column(mesh_.uv, 2, 0);
    points.v = column(mesh_.uv, 2, 1);
  }
  points.line = mesh_.vertex_line;
  return points;
}

void MeshBuilder::take_corner_parameters() {
  std::sort(seam_.begin(), seam_.end());
  const auto several = std::unique(seam_.begin(), seam_.end()) - seam_.begin();
  if (several > 0)
    return drop_parameters(
        fmt::format("{} such as vertex {} (counted from {}) {} several, a seam between charts",
                    several == 1 ? "one vertex" : fmt::format("{} vertices", several),
                    seam_[0] + mesh_.counted_from, mesh_.counted_from, several == 1 ? "has" : "have"));
  corner_uv_.resize(2 * mesh_.vertices.size() / 3, kNan);
  mesh_.uv = std::move(corner_uv_);
}

void MeshBuilder::leave_parameters_aside(std::string_view whose, std::string_view of_the) {
  std::vector<char> used(mesh_.vertices.size() / 3, mesh_.faces.empty());
  for (const auto& c : mesh_.faces)
    for (const std::int32_t v : c) used[v] = 1;
  Index bare = 0;
  for (std::size_t k = 0; k < mesh_.uv.size() / 2; ++k) {
    if (std::isfinite(mesh_.uv[2 * k]) && std::isfinite(mesh_.uv[2 * k + 1])) continue;
    bare += used[k];
    mesh_.uv[2 * k] = mesh_.uv[2 * k + 1] = 0;  // a vertex that no face uses: any will do
  }
  if (bare > 0)
    drop_parameters(
        fmt::format("{} of the {} {} none that is finite", bare, of_the, bare == 1 ? "has" : "have"));
  if (dropped_.empty()) return;
  mesh_.uv.clear();
  notes_.push_back(
      fmt::format("the {} parameters (texture coordinates) are left aside: {}", whose, dropped_));
}

Mesh MeshBuilder::finish() {
  if (mesh_.faces.empty()) throw FileError(file_.path(), "the mesh has no faces");
  if (mesh_.uv.empty() && !corner_uv_.empty() && dropped_.empty()) take_corner_parameters();
  leave_parameters_aside("mesh's", "vertices");
  return std::move(mesh_);
}

void check_claim(const FileBytes& file, Index count, const char* what, double least, std::size_t left) {
  // The last line of a text may lack its end.
  if (static_cast<double>(count) * least > static_cast<double>(left) + 1)
    throw FileError(
        file.path(),
        fmt::format("the header claims {} {}, which take {:.0f} bytes at least, but only {} bytes "
                    "follow it",
                    count, what, static_cast<double>(count) * least, left));
  if (count > kMost)
    throw FileError(file.path(),
                    fmt::format("{} {} are more than the {} that can be read", count, what, kMost));
}

std::string foreign_kind(std::string_view bytes) {
  using namespace std::string_view_literals;
  constexpr std::pair<std::string_view, const char*> kinds[] = {{"\x89PNG"sv, "a PNG image"},
                                                                {"\xFF\xD8\xFF"sv, "a JPEG image"},
                                                                {"GIF8"sv, "a GIF image"},
                                                                {"%PDF"sv, "a PDF document"},
                                                                {"PK\x03\x04"sv, "a ZIP archive"},
                                                                {"\x1F\x8B"sv, "a gzip file"},
                                                                {"\x93NUMPY"sv, "a NumPy array"},
                                                                {"LASF"sv, "a LAS point cloud"},
                                                                {"glTF"sv, "a glTF model"},
                                                                {"ply\n"sv, "a PLY file"},
                                                                {"ply\r"sv, "a PLY file"},
                                                                {"\x7F"
                                                                 "ELF"sv,
                                                                 "a program"},
                                                                {"ISO-10303-21"sv, "a STEP file"},
                                                                {"<?xml"sv, "an XML file"},
                                                                {"BM"sv, "a BMP image"}};
  for (const auto& [magic, kind] : kinds)
    if (bytes.starts_with(magic)) return kind;
  return "";
}

}  // namespace knotfit
