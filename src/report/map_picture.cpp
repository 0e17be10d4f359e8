#include "knotfit/map_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "knotfit/exceptions.h"
#include "report/compose.h"
#include "report/content.h"
#include "report/layout.h"
#include "report/map_view.h"
#include "report/pixels.h"
namespace knotfit {
namespace {

using namespace report;

// A power of 2 as a reader writes it: 1/8, 1, 8.
std::string power_text(int exponent) {
  return exponent < 0 ? "1/" + std::to_string(1 << -exponent) : std::to_string(1 << exponent);
}

constexpr double kBarHeight = 4.3, kEntry = 1.65, kMark = 1.6, kText = 0.85;  // in em

double map_legend_height(const MapContent& c, double em) {
  return (kBarHeight + kEntry * (2 + c.turned + c.virtual_faces)) * em;
}

void draw_scale(Canvas& canvas, const MapContent& c, const Box& box, double em) {
  const double inset = 1.4 * em;
  const Box bar{box.x + inset, box.y + 1.65 * em, box.width - 2 * inset, 0.85 * em};
  canvas.text(
      {box.x, box.y},
      canvas.shortened("stretch: lengths on the mesh over lengths in the plane", box.width, 0.9 * em, true),
      {.size = 0.9 * em, .bold = true, .paint = {kInk}, .vertical = Align::end});
  const int width = std::clamp(static_cast<int>(bar.width * canvas.resolution()), 1, 4000);
  Image image(width, 1);
  for (int k = 0; k < width; ++k) image.at(k, 0) = premultiplied(diverging(2 * (k + 0.5) / width - 1));
  canvas.image(bar, image, false);
  canvas.stroke(bar, em / 17, {kInk, 0.8});
  const int most = static_cast<int>(std::lround(std::log2(c.range)));
  std::vector<Vec2> marks;
  const double step = bar.width / (2 * most);
  const int every = std::max(1, static_cast<int>(std::ceil(2.6 * em / step)));
  for (int k = -most; k <= most; ++k) {
    const double x = bar.x + (k + most) * step;
    marks.insert(marks.end(), {{x, bar.bottom()}, {x, bar.bottom() + 0.3 * em}});
    if (k % every != 0) continue;
    std::string text = power_text(k);
    if (c.clipped && std::abs(k) == most) text.insert(0, k < 0 ? "≤ " : "≥ ");
    canvas.text({x, bar.bottom() + 0.55 * em}, text,
                {.size = 0.82 * em, .paint = {kQuiet}, .horizontal = Align::middle, .vertical = Align::end});
  }
  canvas.segments(marks, em / 17, {kInk, 0.8});
}

void draw_map_legend(Canvas& canvas, const MapContent& c, const Box& box, double em) {
  draw_scale(canvas, c, box, em);
  double middle = box.y + (kBarHeight + 0.5 * kEntry) * em;
  const auto entry = [&](const std::string& text, const auto& mark) {
    mark(Box{box.x, middle - 0.5 * em, kMark * em, em});
    const double x = box.x + (kMark + 0.5) * em;
    canvas.text({x, middle}, canvas.shortened(text, box.right() - x, kText * em),
                {.size = kText * em, .paint = {kInk}, .vertical = Align::middle});
    middle += kEntry * em;
  };
  entry(fmt::format("lines u = k/{0} and v = k/{0}", c.input->parts), [&](const Box& b) {
    const std::array<Vec2, 2> ends{Vec2{b.x, b.centre().y}, Vec2{b.right(), b.centre().y}};
    canvas.segments(ends, 1.1 * em / 17, {kInk, 0.7});
  });
  entry("corners of the square", [&](const Box& b) { draw_corner(canvas, b.centre(), "", em); });
  if (c.turned) entry("triangle turned over or flat", [&](const Box& b) { canvas.fill(b, {kTurned}); });
  if (c.virtual_faces) entry("closes a hole, no data", [&](const Box& b) { canvas.fill(b, {kNoData}); });
}

struct Page {
  double em = 17;
  bool full = true;
  std::vector<std::string> subtitle;
  Box title, subtitle_box, mesh_heading, mesh, plane_heading, plane, legend, facts;
};

Page lay_out(const Canvas& canvas, const MapContent& c) {
  Page p;
  const double width = canvas.width(), height = canvas.height(), em = p.em = body_size(width, height);
  const double margin = 1.7 * em, inside = width - 2 * margin, heading = 1.9 * em, gap = 2 * em;
  p.full = full_page(width, height, em);
  double top = (p.full ? 1.4 : 0.8) * em, bottom = height - (p.full ? 1.2 : 0.8) * em;
  if (!c.input->title.empty()) {
    p.title = {margin, top, inside, 1.5 * em};
    top += 2 * em;
  }
  if (!p.full) {
    p.mesh = {margin, top, inside, std::max(bottom - top, 1.0)};
    return p;
  }
  if (!c.input->subtitle.empty()) {
    p.subtitle = canvas.wrapped(c.input->subtitle, inside, 0.95 * em, 2);
    const double tall = 1.35 * em * static_cast<double>(p.subtitle.size());
    p.subtitle_box = {margin, top + 0.3 * em, inside, tall};
    top += tall;
  }
  const double facts = facts_height(canvas, facts_of(c), inside, em);
  p.facts = {margin, bottom - facts, inside, facts};
  bottom -= facts + 1.7 * em;
  top += 0.9 * em;
  const double tall = std::max(bottom - top, 1.0), legend = map_legend_height(c, em);
  if (width >= 1.15 * height) {
    const double right = std::clamp(0.36 * inside, 18 * em, 34 * em), left = inside - right - gap;
    const double plane = std::max(tall - heading - gap - legend, 1.0);
    p.mesh_heading = {margin, top, left, heading};
    p.mesh = {margin, top + heading, left, tall - heading};
    p.plane_heading = {margin + left + gap, top, right, heading};
    p.plane = {p.plane_heading.x, top + heading, right, plane};
    p.legend = {p.plane_heading.x, bottom - legend, right, legend};
    return p;
  }
  const double both = std::max(tall - 2 * heading - gap - 1.4 * em - legend, 2.0), mesh = 0.6 * both;
  p.mesh_heading = {margin, top, inside, heading};
  p.mesh = {margin, top + heading, inside, mesh};
  p.plane_heading = {margin, p.mesh.bottom() + gap, inside, heading};
  p.plane = {margin, p.plane_heading.bottom(), inside, both - mesh};
  p.legend = {margin, bottom - legend, std::min(inside, 40 * em), legend};
  return p;
}

void draw(Canvas& canvas, const MapContent& c) {
  const Page p = lay_out(canvas, c);
  const double em = p.em;
  const std::string drawn = draw_mesh_view(canvas, c, p.mesh, em);
  if (!c.input->title.empty())
    canvas.text({p.title.x, p.title.y}, canvas.shortened(c.input->title, p.title.width, 1.4 * em, true),
                {.size = 1.4 * em, .bold = true, .paint = {kInk}, .vertical = Align::end});
  for (std::size_t k = 0; k < p.subtitle.size(); ++k)
    canvas.text({p.subtitle_box.x, p.subtitle_box.y + 1.35 * em * static_cast<double>(k)}, p.subtitle[k],
                {.size = 0.95 * em, .paint = {kQuiet}, .vertical = Align::end});
  if (!p.full) return;
  draw_map_plane(canvas, c, p.plane, em);
  draw_map_legend(canvas, c, p.legend, em);
  draw_heading(canvas, p.mesh_heading, "Parameter lines on the mesh", drawn, em);
  const bool true_to_scale = c.plane_aspect == c.quality.aspect;
  draw_heading(canvas, p.plane_heading, "Parameter plane",
               true_to_scale ? fmt::format("as {:.3g} : 1", c.quality.aspect) : "", em);
  draw_facts(canvas, facts_of(c), p.facts, em);
}

}  // namespace

std::string draw_map_picture(const MapPictureInput& input, const std::string& extension,
                             const PictureOptions& options) {
  const Format format = picture_format(extension);
  check_page(options.width, options.height);
  const MapContent content = prepare(input);
  Canvas canvas(format, options.width, options.height);
  canvas.document_title(input.title);
  draw(canvas, content);
  return canvas.finish();
}

}  // namespace knotfit
