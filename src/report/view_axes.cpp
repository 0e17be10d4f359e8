#include "report/view_axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "report/content.h"
#include "report/number_text.h"
namespace knotfit::report {
namespace {

struct Axis {
  Vec3 from, to;     // in the scene
  double low, high;  // values there
  std::string name, unit;
};

// Ticks outward from the drawing's middle; a text that would touch an earlier one is left out.
void draw_axis(Canvas& canvas, const Camera& camera, const Axis& axis, Vec2 middle, double em, int most,
               std::vector<Box>& taken) {
  const double size = 0.82 * em, tick = 0.38 * em;
  const ScreenPoint a = camera.project(axis.from), b = camera.project(axis.to);
  const Vec2 along{b.x - a.x, b.y - a.y};
  const double l = length(along);
  if (!(l > 2 * em)) return;
  Vec2 out{-along.y / l, along.x / l};
  const Vec2 half{(a.x + b.x) / 2 - middle.x, (a.y + b.y) / 2 - middle.y};
  if (out.x * half.x + out.y * half.y < 0) out = {-out.x, -out.y};
  const Ticks ticks = make_ticks(axis.low, axis.high, std::clamp(static_cast<int>(l / (4.5 * em)), 2, most));
  const TextStyle style{.size = size,
                        .paint = {kQuiet},
                        .horizontal = std::abs(out.x) < 0.35 ? Align::middle
                                      : out.x < 0            ? Align::end
                                                             : Align::start,
                        .vertical = std::abs(out.x) > 0.9 ? Align::middle : Align::end};
  auto place = [&](Vec2 at, const std::string& text) {
    const double w = canvas.text_width(text, size), pad = 0.25 * em;
    const double x = style.horizontal == Align::middle ? at.x - w / 2
                     : style.horizontal == Align::end  ? at.x - w
                                                       : at.x;
    const double y = style.vertical == Align::middle ? at.y - 0.4 * size : at.y;
    const Box box{x - pad, y - pad, w + 2 * pad, 0.85 * size + 2 * pad};
    for (const Box& other : taken)
      if (other.overlaps(box)) return false;
    if (box.x < 0 || box.right() > canvas.width() || box.bottom() > canvas.height()) return false;
    taken.push_back(box);
    canvas.text(at, text, style);
    return true;
  };
  double widest = 0;
  std::vector<Vec2> lines;
  for (std::size_t k = 0; k < ticks.at.size(); ++k) {
    const double t = axis.high > axis.low ? (ticks.at[k] - axis.low) / (axis.high - axis.low) : 0.5;
    const ScreenPoint p = camera.project(axis.from + t * (axis.to - axis.from));
    const Vec2 at{p.x, p.y};
    lines.insert(lines.end(), {at, at + tick * out});
    place(at + (tick + 0.22 * em) * out, ticks.text[k]);
    widest = std::max(widest, canvas.text_width(ticks.text[k], size));
  }
  canvas.segments(lines, em / 17, {kInk, 0.7});
  // The name beyond the ticks' texts, as far as they reach outward.
  const double reach = std::abs(out.x) * widest + std::abs(out.y) * 0.9 * size;
  const Vec2 mid{(a.x + b.x) / 2, (a.y + b.y) / 2};
  const std::string name = ticks.name(axis.name, axis.unit);
  if (std::abs(out.x) > 0.9) {  // upright axis: its name on top
    const Vec2 top = a.y < b.y ? Vec2{a.x, a.y} : Vec2{b.x, b.y};
    const double x = std::max(top.x + tick * out.x, 0.5 * em + canvas.text_width(name, size));
    canvas.text({x, top.y - 1.0 * em}, name, {.size = size, .paint = {kInk}, .horizontal = Align::end});
    return;
  }
  for (double further : {0.45, 1.2, 2.0})
    if (place(mid + (tick + further * em + reach) * out, name)) return;
}

}  // namespace

void draw_back_frame(Canvas& canvas, const SurfaceSamples& s, const Camera& camera, double base, double em) {
  const Vec3 low = s.scene_low(), high = s.scene_high();
  auto line = [&](Vec3 from, Vec3 to) {
    const ScreenPoint a = camera.project(from), b = camera.project(to);
    const std::array<Vec2, 2> ends{Vec2{a.x, a.y}, Vec2{b.x, b.y}};
    canvas.polyline(ends, em / 17, {kInk, 0.35});
  };
  line({high.x, low.y, base}, {high.x, high.y, base});
  line({low.x, high.y, base}, {high.x, high.y, base});
  if (s.scale.z > 0) line({low.x, high.y, base}, {low.x, high.y, high.z});
}

void draw_frame(Canvas& canvas, const SurfaceSamples& s, const Camera& camera, double base, double em,
                const std::string& unit) {
  const Vec3 low = s.scene_low(), high = s.scene_high();
  const ScreenPoint c = camera.project({(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2});
  for (const Vec3& end : {Vec3{high.x, low.y, base}, Vec3{low.x, high.y, base}}) {
    const ScreenPoint a = camera.project({low.x, low.y, base}), b = camera.project(end);
    const std::array<Vec2, 2> ends{Vec2{a.x, a.y}, Vec2{b.x, b.y}};
    canvas.polyline(ends, em / 17, {kInk, 0.35});
  }
  std::vector<Box> taken;
  draw_axis(canvas, camera, {{low.x, low.y, base}, {high.x, low.y, base}, s.low.x, s.high.x, s.name_x, ""},
            {c.x, c.y}, em, 6, taken);
  draw_axis(canvas, camera, {{low.x, low.y, base}, {low.x, high.y, base}, s.low.y, s.high.y, s.name_y, ""},
            {c.x, c.y}, em, 5, taken);
  if (s.scale.z > 0)
    draw_axis(canvas, camera, {{low.x, high.y, low.z}, {low.x, high.y, high.z}, s.low.z, s.high.z, "z", unit},
              {c.x, c.y}, em, 4, taken);
}

void draw_triad(Canvas& canvas, const Camera& camera, Vec2 at, double em) {
  const double reach = 1.7 * em;
  std::vector<Box> taken;
  const std::array<std::pair<Vec3, const char*>, 3> axes{
      {{{1, 0, 0}, "x"}, {{0, 1, 0}, "y"}, {{0, 0, 1}, "z"}}};
  for (const auto& [axis, name] : axes) {
    const Vec2 d{dot(axis, camera.right), -dot(axis, camera.up)};
    const std::array<Vec2, 2> ends{at, at + reach * d};
    canvas.polyline(ends, 1.4 * em / 17, {kInk, 0.8});
    // Two axes may point the same way on the page: the second name moves outward.
    for (double further : {0.5, 1.4, 2.3}) {
      if (length(d) < 0.2) break;
      const Vec2 p = ends[1] + (further * em / length(d)) * d;
      const Box box{p.x - 0.35 * em, p.y - 0.45 * em, 0.7 * em, 0.9 * em};
      if (std::any_of(taken.begin(), taken.end(), [&](const Box& other) { return other.overlaps(box); }))
        continue;
      taken.push_back(box);
      canvas.text(
          p, name,
          {.size = 0.82 * em, .paint = {kInk}, .horizontal = Align::middle, .vertical = Align::middle});
      break;
    }
  }
}

void draw_worst_mark(Canvas& canvas, Vec2 at, double em) {
  canvas.ring(at, 0.42 * em, 0.26 * em, {{1, 1, 1}, 0.9});
  canvas.ring(at, 0.42 * em, 0.11 * em, {kInk});
}

void draw_fold_mark(Canvas& canvas, Vec2 at, double radius, double em) {
  canvas.ring(at, std::max(radius, 0.3 * em), 0.26 * em, {{1, 1, 1}, 0.9});
  canvas.ring(at, std::max(radius, 0.3 * em), 0.13 * em, {kFold});
}

}  // namespace knotfit::report
