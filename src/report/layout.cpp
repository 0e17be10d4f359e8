#include "report/layout.h"

#include <algorithm>
#include <cmath>

#include "report/legend.h"
#include "report/parameter_plane.h"
namespace knotfit::report {
namespace {

// Text grows more slowly than the page: small pictures stay legible, large ones are not shouting.
double body_size(double width, double height) {
  return std::max(7.0, 17 * std::pow(std::min(width / 1600, height / 900), 0.5));
}

}  // namespace

Layout lay_out(const Canvas& canvas, const Content& content) {
  Layout l;
  const double width = canvas.width(), height = canvas.height();
  const double em = l.em = body_size(width, height), margin = 1.7 * em;
  const double inside = width - 2 * margin;
  const bool small = height > 1.2 * width
                         ? width < 34 * em
                         : width < 50 * em || height < 30 * em;  // no room for ticks and figures
  l.axes = l.headings = !small;

  double top = small ? 0.8 * em : 1.4 * em, bottom = height - (small ? 0.8 : 1.2) * em;
  if (!content.input->title.empty()) {
    l.title = {margin, top, inside, 1.5 * em};
    top += 2.0 * em;
  }
  if (!small && !content.input->subtitle.empty()) {
    l.subtitle = canvas.wrapped(content.input->subtitle, inside, 0.95 * em, 2);
    top += 1.35 * em * static_cast<double>(l.subtitle.size());
  }
  top += small ? 0 : 0.9 * em;
  if (!small) {
    const double tall = facts_height(canvas, facts_of(content), inside, em);
    l.facts = {margin, bottom - tall, inside, tall};
    bottom -= tall + 1.7 * em;
  }
  const double heading = l.headings ? 1.9 * em : 0, gap = 2 * em;
  const double room = std::max(bottom - top, 1.0);

  if (small) {
    // The surface, the colour bar where it fits, the plane beside on wide pages.
    const double legend = legend_height(canvas, content, inside, em);
    if (room > legend + 9 * em && inside > 16 * em) {
      l.legend = {margin, bottom - legend, inside, legend};
      bottom -= legend + 0.8 * em;
    }
    const double left = bottom - top;
    if (inside > 1.8 * left) {
      l.plane = {width - margin - left, top, left, left};
      l.surface = {margin, top, inside - left - em, left};
    } else {
      l.surface = {margin, top, inside, left};
    }
    return l;
  }

  // What the plane's axes take beside it.
  const double beside = 5.2 * em, under = 2.9 * em, aspect = plane_aspect(content);
  const double legend_side = std::max(0.24 * inside, 22 * em);
  if (inside >= 2.4 * room) {
    // Three columns.
    const double plane_width = (room - heading - under) * aspect + beside;
    const double legend = legend_height(canvas, content, legend_side, em);
    l.legend = {width - margin - legend_side, top + heading + 1.5 * em, legend_side, legend};
    l.plane_heading = {l.legend.x - gap - plane_width, top, plane_width, heading};
    l.plane = {l.plane_heading.x, top + heading, plane_width, room - heading};
    l.surface_heading = {margin, top, l.plane.x - gap - margin, heading};
    l.surface = {margin, top + heading, l.surface_heading.width, room - heading};
    return l;
  }
  if (inside >= 1.15 * room) {
    // Side by side: the plane over the legend.
    double plane_width = std::min(0.40 * inside, (room - heading - under) * aspect + beside);
    double legend = 0, plane_height = 0;
    for (int round = 0; round < 40; ++round) {
      legend = legend_height(canvas, content, plane_width, em);
      plane_height = (plane_width - beside) / aspect + under;
      if (heading + plane_height + 1.1 * em + legend <= room || plane_width < 18 * em) break;
      plane_width *= 0.97;
    }
    // A plane narrowed by a low page leaves its column wide enough for the legend.
    plane_width = std::max(plane_width, std::min(0.34 * inside, 27 * em));
    legend = legend_height(canvas, content, plane_width, em);
    plane_height = std::max(room - heading - legend - 1.1 * em, 1.0);
    plane_height = std::min(plane_height, (plane_width - beside) / aspect + under);
    const double x = width - margin - plane_width;
    l.plane_heading = {x, top, plane_width, heading};
    l.plane = {x, top + heading, plane_width, plane_height};
    l.legend = {x, l.plane.bottom() + 1.1 * em, plane_width, legend};
    l.surface_heading = {margin, top, inside - plane_width - gap, heading};
    l.surface = {margin, top + heading, inside - plane_width - gap, room - heading};
    return l;
  }
  // Tall: the surface on top, below it the plane with the legend at its side, or under it. Neither
  // panel grows higher than its drawing can use.
  const double surface_most = 0.80 * inside;
  const bool at_side = inside - legend_side - gap > 24 * em && room < 1.75 * inside;
  const double plane_width = at_side ? inside - legend_side - gap : inside;
  const double legend = legend_height(canvas, content, at_side ? legend_side : inside, em);
  const double between = at_side ? gap : gap + 1.4 * em + legend;
  const double rest = room - 2 * heading - between;
  const double plane_height = std::min((plane_width - beside) / aspect + under, 0.48 * rest);
  const double surface_height = std::min(rest - plane_height, surface_most);
  l.surface_heading = {margin, top, inside, heading};
  l.surface = {margin, top + heading, inside, surface_height};
  l.plane_heading = {margin, l.surface.bottom() + gap, plane_width, heading};
  l.plane = {margin, l.plane_heading.bottom(), plane_width, plane_height};
  l.legend = at_side
                 ? Box{width - margin - legend_side,
                       l.plane.y + std::max(0.0, (plane_height - under - legend) / 2), legend_side, legend}
                 : Box{margin, l.plane.bottom() + 1.4 * em, inside, legend};
  return l;
}

}  // namespace knotfit::report
