#include "report/surface_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "knotfit/evaluate.h"
#include "report/number_text.h"
#include "report/panel_view.h"
#include "report/surface_shading.h"
#include "report/view_axes.h"
namespace knotfit::report {
namespace {

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

std::string caption(const SurfaceSamples& s, bool reflections) {
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
  if (reflections) out += "; reflection lines of lamps 10° apart";
  if (s.cut) out += "; parts far outside the data left out";
  return out;
}

}  // namespace

std::string draw_surface_view(Canvas& canvas, const Content& content, const Box& panel, double em,
                              bool axes) {
  const SurfaceSamples& s = content.samples;
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
  const PanelView view(canvas, choose_view(s), panel, inner, mesh.position, mesh.triangles, drawn);
  const Camera& camera = view.camera();

  if (framed) draw_back_frame(canvas, s, camera, base, em);
  const Image image =
      shade(content, mesh, view.buffer(), view.corners(), camera, view.finer(), 0.42 * em * view.pixels());
  canvas.image(view.image_box(), image);
  draw_knot_lines(canvas, view.viewport(), s, std::min(panel.width, panel.height), em);
  if (framed)
    draw_frame(canvas, s, camera, base, em, content.input->unit);
  else if (axes)
    draw_triad(canvas, camera, view.emptiest_corner(2.6 * em), em);

  if (content.worst >= 0 && content.max > 0) {
    const double u = std::clamp(content.points().u(content.worst), content.domain.u0, content.domain.u1);
    const double v = std::clamp(content.points().v(content.worst), content.domain.v0, content.domain.v1);
    const Surface& surface = *content.input->surface;
    std::vector<double> p(static_cast<std::size_t>(surface.dimension()));
    evaluate(surface, u, v, p);
    const auto [x, y] = content.map.from_uv(u, v);
    const Vec3 at = surface.dimension() == 1 ? Vec3{x, y, p[0]} : Vec3{p[0], p[1], p[2]};
    const ScreenPoint q = camera.project(s.to_scene(at));
    const bool in_panel = q.x > panel.x && q.x < panel.right() && q.y > panel.y && q.y < panel.bottom();
    if (in_panel && view.viewport().visible(q)) draw_worst_mark(canvas, {q.x, q.y}, em);
  }
  return caption(s, content.input->reflections);
}

}  // namespace knotfit::report
