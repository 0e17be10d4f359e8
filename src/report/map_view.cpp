#include "report/map_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "report/content.h"
#include "report/number_text.h"
#include "report/panel_view.h"
#include "report/pixels.h"
#include "report/surface_shading.h"
#include "report/view_axes.h"
namespace knotfit::report {
namespace {

constexpr const char* kCornerNames[4] = {"(0,0)", "(1,0)", "(1,1)", "(0,1)"};
constexpr double kCornerPlaces[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};

// Smooth light from the vertices' normals; the side turned away is darker.
Image shade_mesh(const MapContent& content, const PanelView& view) {
  const ViewScene& s = content.scene;
  const Camera& camera = view.camera();
  const std::vector<ScreenPoint>& corners = view.corners();
  const auto pixel = [&](int x, int y) -> std::optional<Rgb> {
    const std::int32_t id = view.buffer().triangle(x, y);
    if (id < 0) return std::nullopt;
    const Triangle& t = s.triangles[id];
    const std::array<double, 3> w = weights_at(corners[t[0]], corners[t[1]], corners[t[2]], x + 0.5, y + 0.5);
    const Vec3 face =
        unit_or(cross(s.position[t[1]] - s.position[t[0]], s.position[t[2]] - s.position[t[0]]), {0, 0, 1});
    const Vec3 eye = unit_or(camera.distance * camera.toward - s.position[t[0]], camera.toward);
    Vec3 normal;
    for (int k = 0; k < 3; ++k) normal = normal + w[k] * s.normal[t[k]];
    normal = unit_or(normal, face);
    if (dot(normal, face) < 0) normal = -1.0 * normal;
    const bool behind = dot(face, eye) < 0;
    if (behind) normal = -1.0 * normal;
    const Rgb colour = content.colour(id);
    const double b = brightness(normal, camera) * (behind ? 0.72 : 1);
    return Rgb{std::min(1.0, colour.r * b), std::min(1.0, colour.g * b), std::min(1.0, colour.b * b)};
  };
  const int finer = view.finer();
  return averaged_pixels(view.buffer().width() / finer, view.buffer().height() / finer, finer, pixel);
}

double line_width(const MapContent& content, std::size_t line, double crowd, double unit) {
  return content.border(line) ? 1.7 * unit : unit * (0.55 + 0.45 * crowd);
}
Paint line_paint(const MapContent& content, std::size_t line, double crowd) {
  return {kInk, content.border(line) ? 0.95 : 0.25 + 0.45 * crowd};
}

void draw_lines(Canvas& canvas, const MapContent& content, const Viewport& view, double size, double em) {
  const double crowd = crowding(0.6 * size, static_cast<std::size_t>(content.input->parts));
  for (const bool borders : {false, true})
    for (std::size_t k = 0; k < content.lines.size(); ++k) {
      if (content.border(k) != borders) continue;
      for (const std::vector<Vec2>& run : visible_runs(content.lines[k], view))
        canvas.polyline(run, line_width(content, k, crowd, em / 17), line_paint(content, k, crowd));
    }
}

}  // namespace

void draw_corner(Canvas& canvas, Vec2 at, const std::string& name, double em) {
  canvas.disc(at, 0.42 * em, {{1, 1, 1}});
  canvas.disc(at, 0.3 * em, {kInk});
  if (name.empty()) return;
  const double size = 0.9 * em, width = canvas.text_width(name, size, true);
  const double x =
      std::clamp(at.x + 0.6 * em, 0.2 * em, std::max(0.2 * em, canvas.width() - width - 0.2 * em));
  canvas.text({x, at.y - 0.55 * em}, name, {.size = size, .bold = true, .paint = {kInk}, .halo = 0.3 * em});
}

std::string draw_mesh_view(Canvas& canvas, const MapContent& content, const Box& panel, double em) {
  const ViewScene& s = content.scene;
  const Box inner{panel.x + 1.6 * em, panel.y + 1.6 * em, panel.width - 3.2 * em, panel.height - 3.2 * em};
  std::vector<Vec3> drawn;
  for (const Triangle& t : s.triangles)
    for (const std::int32_t k : t) drawn.push_back(s.position[k]);
  const PanelView view(canvas, choose_view(s), panel, inner, s.position, s.triangles, drawn);
  canvas.image(view.image_box(), shade_mesh(content, view));
  draw_lines(canvas, content, view.viewport(), std::min(panel.width, panel.height), em);
  draw_triad(canvas, view.camera(), view.emptiest_corner(2.6 * em), em);
  for (int k = 0; k < 4; ++k) {
    if (content.input->corners[k] < 0) continue;
    const ScreenPoint p = view.camera().project(s.position[content.input->corners[k]]);
    if (view.viewport().visible(p)) draw_corner(canvas, {p.x, p.y}, kCornerNames[k], em);
  }
  const Vec3 size = (1 / content.scale) * (s.high - s.low);
  return fmt::format("{} × {} × {} in x, y, z", number_text(size.x), number_text(size.y),
                     number_text(size.z));
}

Box draw_map_plane(Canvas& canvas, const MapContent& content, const Box& panel, double em) {
  const double beside = 2.6 * em, under = 2.6 * em, above = 1.4 * em, small = 0.82 * em;
  const double width = std::max(panel.width - 2 * beside, 1.0);
  const double height = std::max(panel.height - under - above, 1.0);
  const double w = std::min(width, height * content.plane_aspect), h = w / content.plane_aspect;
  const Box box{panel.x + beside + (width - w) / 2, panel.y + above, w, h};

  // Every pixel shows the face there; later faces never lie over earlier ones unless the map folds.
  constexpr int kFiner = 2;
  const double resolution = std::min(canvas.resolution(), std::sqrt(4e6 / (w * h)));
  const int columns = std::max(1, static_cast<int>(std::lround(w * resolution)));
  const int rows = std::max(1, static_cast<int>(std::lround(h * resolution)));
  const std::vector<double>& uv = *content.input->uv;
  std::vector<ScreenPoint> corners(uv.size() / 2);
  for (std::size_t k = 0; k < corners.size(); ++k)
    corners[k] = {uv[2 * k] * columns * kFiner, (1 - uv[2 * k + 1]) * rows * kFiner, 1};
  const ZBuffer buffer(columns * kFiner, rows * kFiner, corners, content.scene.triangles);
  canvas.image(box, averaged_pixels(columns, rows, kFiner, [&](int x, int y) -> std::optional<Rgb> {
                 const std::int32_t id = buffer.triangle(x, y);
                 return id < 0 ? std::nullopt : std::optional<Rgb>(content.colour(id));
               }));

  const int parts = content.input->parts;
  const double crowd = std::clamp(std::min(w, h) / (1.3 * em * parts), 0.3, 1.0);
  const auto at = [&](double u, double v) { return Vec2{box.x + u * w, box.bottom() - v * h}; };
  for (int k = 1; k < parts; ++k) {
    const double x = static_cast<double>(k) / parts;
    for (const auto& ends : {std::array{at(x, 0), at(x, 1)}, std::array{at(0, x), at(1, x)}})
      canvas.segments(ends, em / 17 * (0.5 + 0.4 * crowd), {kInk, 0.13 + 0.37 * crowd});
  }
  canvas.stroke(box, 1.4 * em / 17, {kInk, 0.95});
  for (int k = 0; k < 4; ++k)
    if (content.input->corners[k] >= 0) {
      draw_corner(canvas, at(kCornerPlaces[k][0], kCornerPlaces[k][1]), "", em);
      const bool low = kCornerPlaces[k][1] == 0, left = kCornerPlaces[k][0] == 0;
      canvas.text({left ? box.x : box.right(), low ? box.bottom() + 0.6 * em : box.y - 0.6 * em},
                  kCornerNames[k],
                  {.size = small,
                   .paint = {kQuiet},
                   .horizontal = left ? Align::end : Align::start,
                   .vertical = low ? Align::end : Align::start});
    }
  canvas.text({box.centre().x, box.bottom() + 0.75 * em}, "u",
              {.size = small, .paint = {kInk}, .horizontal = Align::middle, .vertical = Align::end});
  canvas.text({box.x - 0.9 * em, box.centre().y}, "v",
              {.size = small, .paint = {kInk}, .horizontal = Align::middle, .vertical = Align::middle});
  return box;
}

}  // namespace knotfit::report
