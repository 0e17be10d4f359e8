#include "report/surface_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "knotfit/evaluate.h"
#include "report/hidden_lines.h"
#include "report/number_text.h"
#include "report/surface_shading.h"
#include "report/view_axes.h"
namespace knotfit::report {
namespace {

constexpr double kMostSamples = 24e6;  // depth samples of a picture, whatever its size

// Moves and zooms the camera so that all points fall into the box.
void fit_into(Camera& camera, const std::vector<Vec3>& points, const Box& box) {
  camera.zoom = 1;
  camera.origin = {};
  double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
  for (const Vec3& p : points) {
    const ScreenPoint s = camera.project(p);
    x0 = std::min(x0, s.x);
    x1 = std::max(x1, s.x);
    y0 = std::min(y0, s.y);
    y1 = std::max(y1, s.y);
  }
  const double width = std::max(x1 - x0, 1e-9), height = std::max(y1 - y0, 1e-9);
  camera.zoom = std::min({box.width / width, box.height / height, std::max(box.width, box.height)});
  camera.origin = {box.centre().x - camera.zoom * (x0 + x1) / 2,
                   box.centre().y - camera.zoom * (y0 + y1) / 2};
}

// Lines get thinner and fainter where they come close to each other.
double crowding(double panel_size, std::size_t lines) {
  return std::clamp(panel_size / (18.0 * static_cast<double>(std::max<std::size_t>(lines, 1))), 0.3, 1.0);
}

void draw_knot_lines(Canvas& canvas, const Viewport& view, const SurfaceSamples& s, double size, double em) {
  const double unit = em / 17;
  auto draw = [&](bool along_v, std::size_t k, double width, double alpha) {
    std::vector<Vec3> line;
    auto end_line = [&] {
      for (const std::vector<Vec2>& run : visible_runs(line, view))
        canvas.polyline(run, width, {kInk, alpha});
      line.clear();
    };
    const Index fixed = along_v ? s.knots_u[k] : s.knots_v[k];
    for (Index m = 0; m < (along_v ? s.size_v() : s.size_u()); ++m) {
      if (const Index at = along_v ? s.at(fixed, m) : s.at(m, fixed); s.kept[at])
        line.push_back(s.position[at]);
      else
        end_line();
    }
    end_line();
  };
  for (bool along_v : {true, false}) {
    const std::vector<int>& multiplicity = along_v ? s.multiplicity_u : s.multiplicity_v;
    const std::size_t count = multiplicity.size();
    const double crowd = crowding(0.6 * size, count);
    for (std::size_t k = 1; k + 1 < count; ++k)
      draw(along_v, k, unit * (0.55 + 0.45 * crowd) * (1 + 0.6 * (multiplicity[k] - 1)), 0.14 + 0.46 * crowd);
    draw(along_v, 0, 1.3 * unit, 0.8);
    draw(along_v, count - 1, 1.3 * unit, 0.8);
  }
}

// Middle of the corner of the panel that the surface covers least, the lower left first.
Vec2 emptiest_corner(const Viewport& view, const Box& panel, double half) {
  Vec2 best;
  int least = std::numeric_limits<int>::max();
  for (const Vec2 at :
       {Vec2{panel.x + half, panel.bottom() - half}, Vec2{panel.right() - half, panel.bottom() - half},
        Vec2{panel.x + half, panel.y + half}, Vec2{panel.right() - half, panel.y + half}}) {
    int covered = 0;
    for (int i = -8; i <= 8; ++i)
      for (int j = -8; j <= 8; ++j) {
        const int x = static_cast<int>((at.x + i * half / 8 - view.corner.x) * view.pixels);
        const int y = static_cast<int>((at.y + j * half / 8 - view.corner.y) * view.pixels);
        const bool inside = x >= 0 && y >= 0 && x < view.buffer.width() && y < view.buffer.height();
        covered += inside && view.buffer.triangle(x, y) >= 0;
      }
    if (covered >= least) continue;
    least = covered;
    best = at;
  }
  return best;
}

std::string caption(const SurfaceSamples& s) {
  std::string out;
  if (!s.height_field) {
    const Vec3 size = s.high - s.low;
    auto extent = [](double scale, double length) { return number_text(scale > 0 ? length : 0); };
    out = fmt::format("{} × {} × {} in x, y, z", extent(s.scale.x, size.x), extent(s.scale.y, size.y),
                      extent(s.scale.z, size.z));
  } else if (s.scale.z == 0) {
    out = "all heights are equal";
  } else if (std::abs(s.exaggeration() - 1) < 1e-9) {
    out = fmt::format("heights true to scale with {} and {}", s.name_x, s.name_y);
  } else {
    out = fmt::format("heights drawn × {} against {} and {}", number_text(s.exaggeration(), 2), s.name_x,
                      s.name_y);
  }
  if (s.height_field && s.scale.x > 0 && s.scale.y > 0 && std::abs(s.scale.x - s.scale.y) > 1e-9 * s.scale.x)
    out += fmt::format(", {} × {}", s.name_y, number_text(s.scale.y / s.scale.x, 2));
  if (s.cut) out += "; parts far outside the data left out";
  return out;
}

}  // namespace

std::string draw_surface_view(Canvas& canvas, const Content& content, const Box& panel, double em,
                              bool axes) {
  const SurfaceSamples& s = content.samples;
  Camera camera = choose_view(s);
  const double base = s.scene_low().z - 0.07;
  const SurfaceMesh mesh = make_mesh(s, base);

  const bool framed = axes && s.height_field;
  Box inner = panel;
  if (framed) {
    const double side = 4.2 * em;
    inner = {panel.x + side, panel.y + 1.4 * em, panel.width - 1.3 * side, panel.height - 4.0 * em};
  } else {
    inner = {panel.x + em, panel.y + em, panel.width - 2 * em, panel.height - 2 * em};
  }
  std::vector<Vec3> drawn;
  for (const Triangle& t : mesh.triangles)
    for (std::int32_t k : t) drawn.push_back(mesh.position[k]);
  if (drawn.empty()) drawn = mesh.position;
  if (framed) drawn.push_back({s.scene_low().x, s.scene_high().y, s.scene_high().z});  // axis of heights
  fit_into(camera, drawn, inner);

  int finer = 2;
  double resolution = canvas.resolution();
  if (panel.width * panel.height * resolution * resolution * 4 > kMostSamples) finer = 1;
  resolution = std::min(resolution, std::sqrt(kMostSamples / (finer * finer * panel.width * panel.height)));
  const int width = std::max(1, static_cast<int>(std::ceil(panel.width * resolution)));
  const int height = std::max(1, static_cast<int>(std::ceil(panel.height * resolution)));
  const double pixels = resolution * finer;  // a page unit
  std::vector<ScreenPoint> corners(mesh.position.size());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    ScreenPoint p = camera.project(mesh.position[k]);
    corners[k] = {(p.x - panel.x) * pixels, (p.y - panel.y) * pixels, p.nearness};
  }
  const ZBuffer buffer(width * finer, height * finer, corners, mesh.triangles);

  if (framed) draw_back_frame(canvas, s, camera, base, em);
  const Image image = shade(content, mesh, buffer, corners, camera, finer, 0.42 * em * pixels);
  canvas.image({panel.x, panel.y, width / resolution, height / resolution}, image);

  const Viewport view{camera, buffer, {panel.x, panel.y}, pixels};
  draw_knot_lines(canvas, view, s, std::min(panel.width, panel.height), em);
  if (framed)
    draw_frame(canvas, s, camera, base, em, content.input->unit);
  else if (axes)
    draw_triad(canvas, camera, emptiest_corner(view, panel, 2.6 * em), em);

  if (content.worst >= 0 && content.max > 0) {
    const double u = std::clamp(content.points().u(content.worst), content.domain.u0, content.domain.u1);
    const double v = std::clamp(content.points().v(content.worst), content.domain.v0, content.domain.v1);
    const Surface& surface = *content.input->surface;
    std::vector<double> p(static_cast<std::size_t>(surface.dimension()));
    evaluate(surface, u, v, p);
    const Vec3 at = surface.dimension() == 1 ? Vec3{content.map.from_u(u), content.map.from_v(v), p[0]}
                                             : Vec3{p[0], p[1], p[2]};
    const ScreenPoint q = camera.project(s.to_scene(at));
    const bool in_panel = q.x > panel.x && q.x < panel.right() && q.y > panel.y && q.y < panel.bottom();
    if (in_panel && view.visible(q)) draw_worst_mark(canvas, {q.x, q.y}, em);
  }
  return caption(s);
}

}  // namespace knotfit::report
