#include "report/map_content.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "knotfit/exceptions.h"
#include "report/content.h"
#include "report/number_text.h"
namespace knotfit::report {
namespace {

constexpr double kLargestRange = 64;  // stretches beyond look alike

void check(const MapPictureInput& input) {
  if (input.mesh == nullptr || input.uv == nullptr)
    throw InvalidInput("a picture of a map needs a mesh and its parameters");
  if (input.parts < 1 || input.parts > 200)
    throw InvalidInput(fmt::format("{} parts between parameter lines: 1 to 200 are drawn", input.parts));
  for (const Index corner : input.corners)
    if (corner < -1 || corner >= input.mesh->vertex_count())
      throw InvalidInput(
          fmt::format("no vertex {} to mark as a corner: there are {}", corner, input.mesh->vertex_count()));
}

void place(MapContent& content) {
  const Mesh& mesh = *content.input->mesh;
  Vec3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  for (Index k = 0; k < mesh.vertex_count(); ++k) {
    const double* p = mesh.vertex(k);
    low = {std::min(low.x, p[0]), std::min(low.y, p[1]), std::min(low.z, p[2])};
    high = {std::max(high.x, p[0]), std::max(high.y, p[1]), std::max(high.z, p[2])};
  }
  const Vec3 size = high - low;
  content.centre = 0.5 * (low + high);
  content.scale = 1.2 / std::max({size.x, size.y, size.z, 1e-300});
  content.scene.low = content.scale * (low - content.centre);
  content.scene.high = content.scale * (high - content.centre);
}

// Normals weighted by angle: a long thin face does not turn them.
void fill_scene(MapContent& content) {
  const Mesh& mesh = *content.input->mesh;
  ViewScene& scene = content.scene;
  const auto n = static_cast<std::size_t>(mesh.vertex_count());
  for (std::size_t k = 0; k < n; ++k)
    scene.position.push_back(content.to_scene(mesh.vertex(static_cast<Index>(k))));
  scene.normal.assign(n, {});
  scene.area.assign(n, 0);
  scene.rim.assign(n, 0);
  const std::vector<double>& uv = *content.input->uv;
  for (std::size_t k = 0; k < n; ++k)
    scene.rim[k] = uv[2 * k] == 0 || uv[2 * k] == 1 || uv[2 * k + 1] == 0 || uv[2 * k + 1] == 1;
  scene.triangles = mesh.faces;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto& t = mesh.faces[f];
    const Vec3 cross_product =
        cross(scene.position[t[1]] - scene.position[t[0]], scene.position[t[2]] - scene.position[t[0]]);
    const Vec3 normal = unit_or(cross_product, {});
    for (int k = 0; k < 3; ++k) {
      const Vec3 a = scene.position[t[(k + 1) % 3]] - scene.position[t[k]];
      const Vec3 b = scene.position[t[(k + 2) % 3]] - scene.position[t[k]];
      const double angle = std::atan2(length(cross(a, b)), dot(a, b));
      scene.normal[t[k]] = scene.normal[t[k]] + angle * normal;
      if (!content.is_virtual(f)) scene.area[t[k]] += length(cross_product) / 6;
    }
  }
  for (Vec3& normal : scene.normal) normal = unit_or(normal, {});
}

// A range that all but one in a thousand faces keep to.
void choose_range(MapContent& content) {
  std::vector<double> ratio;
  for (const double s : content.stretch)
    if (std::isfinite(s) && s > 0) ratio.push_back(std::max(s, 1 / s));
  if (ratio.empty()) return;
  const std::size_t rank =
      std::min(ratio.size() - 1, static_cast<std::size_t>(0.999 * static_cast<double>(ratio.size())));
  std::nth_element(ratio.begin(), ratio.begin() + static_cast<std::ptrdiff_t>(rank), ratio.end());
  while (content.range < ratio[rank] && content.range < kLargestRange) content.range *= 2;
  content.clipped = *std::max_element(ratio.begin(), ratio.end()) > content.range;
}

}  // namespace

Rgb MapContent::colour(Index face) const {
  if (is_virtual(face)) return kNoData;
  const double s = stretch[face];
  return std::isnan(s) ? kTurned : diverging(std::log(s) / std::log(range));
}

bool MapContent::border(std::size_t line) const {
  const auto of_direction = static_cast<std::size_t>(input->parts) + 1;
  return line % of_direction == 0 || line % of_direction + 1 == of_direction;
}

MapContent prepare(const MapPictureInput& input) {
  check(input);
  MapContent content;
  content.input = &input;
  const Mesh& mesh = *input.mesh;
  content.quality = measure_map(mesh, *input.uv);
  content.stretch = face_stretches(mesh, *input.uv, content.quality.aspect);
  place(content);
  fill_scene(content);
  choose_range(content);
  for (Index f = 0; f < mesh.face_count(); ++f) {
    content.virtual_faces = content.virtual_faces || content.is_virtual(f);
    content.turned = content.turned || (std::isnan(content.stretch[f]) && !content.is_virtual(f));
  }
  for (const auto& line : parameter_lines(mesh, *input.uv, input.parts)) {
    content.lines.emplace_back();
    for (const auto& p : line) content.lines.back().push_back(content.to_scene(p.data()));
  }
  content.plane_aspect = std::clamp(content.quality.aspect, 0.4, 2.5);
  return content;
}

Facts facts_of(const MapContent& c) {
  Index faces = 0;
  for (Index f = 0; f < c.input->mesh->face_count(); ++f) faces += !c.is_virtual(f);
  const auto worst = std::minmax_element(c.stretch.begin(), c.stretch.end(), [](double a, double b) {
    return (std::isnan(a) ? 1 : a) < (std::isnan(b) ? 1 : b);
  });
  return {{"L2 stretch", number_text(c.quality.stretch, 4)},
          {"on its rectangle", number_text(c.quality.aspect_free_stretch, 4)},
          {"rectangle", number_text(c.quality.aspect, 3) + " : 1"},
          {"stretch of faces", number_text(*worst.first, 2) + " to " + number_text(*worst.second, 3)},
          {"worst angle", number_text(c.quality.worst_angle, 3) + "°"},
          {"flipped", count_text(c.quality.flipped)},
          {"triangles", count_text(faces)}};
}

}  // namespace knotfit::report
