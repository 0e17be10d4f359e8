#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "knotfit/comparison_picture.h"
#include "knotfit/exceptions.h"
#include "report/canvas.h"
#include "report/compose.h"
#include "report/content.h"
#include "report/error_field.h"
#include "report/number_text.h"
namespace knotfit {
namespace {

using namespace report;

/// White to dark red, as the diverging map's warm half.
Rgb error_colour(double share) {
  return diverging(std::clamp(share, 0.0, 1.0));
}

void draw_panel(Canvas& canvas, const Box& box, const ComparedSurface& compared,
                const ParameterizedPoints& points, double range) {
  const Surface& s = *compared.surface;
  const Domain domain{s.knots_u().first(), s.knots_u().last(), s.knots_v().first(), s.knots_v().last()};
  const ErrorField field(points, compared.errors, domain);
  const int width = std::clamp(static_cast<int>(box.width * canvas.resolution()), 16, 500);
  const int height = std::clamp(static_cast<int>(box.height * canvas.resolution()), 16, 500);
  Image image(width, height);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double u = domain.u0 + (x + 0.5) / width * (domain.u1 - domain.u0);
      const double v = domain.v1 - (y + 0.5) / height * (domain.v1 - domain.v0);
      const std::optional<double> e = field.at(u, v);
      image.at(x, y) = premultiplied(e ? error_colour(std::abs(*e) / range) : kNoData);
    }
  canvas.image(box, image, false);
  std::vector<Vec2> lines;
  for (double u : s.knots_u().breaks()) {
    const double x = box.x + domain.to_unit_u(u) * box.width;
    lines.insert(lines.end(), {{x, box.y}, {x, box.bottom()}});
  }
  for (double v : s.knots_v().breaks()) {
    const double y = box.bottom() - domain.to_unit_v(v) * box.height;
    lines.insert(lines.end(), {{box.x, y}, {box.right(), y}});
  }
  canvas.segments(lines, std::max(0.4, box.width / 600), {kInk, 0.55});
  canvas.stroke(box, std::max(0.6, box.width / 300), {kInk, 0.9});
}

/// Square panels with a heading each, in the columns that make them largest.
struct PanelGrid {
  int columns = 1;
  double side = 0;
};
PanelGrid panel_grid(std::size_t count, const Box& room, double heading, double gap) {
  PanelGrid best;
  for (int columns = 1; columns <= static_cast<int>(count); ++columns) {
    const double rows = std::ceil(static_cast<double>(count) / columns);
    const double side = std::min(room.width / columns - gap, room.height / rows - heading - gap);
    if (side > best.side) best = {columns, side};
  }
  best.side = std::max(4.0, best.side);
  return best;
}

}  // namespace

double error_range(const std::vector<ComparedSurface>& surfaces) {
  std::vector<double> all;
  for (const ComparedSurface& s : surfaces)
    for (double e : s.errors) {
      if (!std::isfinite(e)) throw InvalidInput(fmt::format("{}: an error is not finite", s.name));
      all.push_back(std::abs(e));
    }
  if (all.empty()) return 1;
  const auto at = all.begin() + static_cast<Index>(0.995 * static_cast<double>(all.size() - 1));
  std::nth_element(all.begin(), at, all.end());
  if (*at > 0) return *at;
  const double largest = *std::max_element(all.begin(), all.end());
  return largest > 0 ? largest : 1;
}

std::string draw_error_maps(const std::vector<ComparedSurface>& surfaces, const ParameterizedPoints& points,
                            double range, const std::string& title, const std::string& extension,
                            const PictureOptions& options) {
  const Format format = picture_format(extension);
  check_page(options.width, options.height);
  if (!(range > 0) || !std::isfinite(range))
    throw InvalidInput(fmt::format("a colour scale up to {}: it must be positive and finite", range));
  if (surfaces.empty()) throw InvalidInput("a picture of a comparison needs at least one surface");
  for (const ComparedSurface& s : surfaces) {
    if (s.surface == nullptr || s.surface->empty())
      throw InvalidInput(fmt::format("{}: there is no surface to draw", s.name));
    if (static_cast<Index>(s.errors.size()) != points.size())
      throw InvalidInput(fmt::format("{}: {} errors for {} points", s.name, s.errors.size(), points.size()));
  }
  error_range(surfaces);  // refuses errors that are not finite
  Canvas canvas(format, options.width, options.height);
  canvas.document_title(title);
  const double w = options.width, h = options.height, em = std::clamp(h / 55.0, 7.0, 40.0);
  canvas.fill({0, 0, w, h}, {{1, 1, 1}});
  canvas.text({1.2 * em, 2.2 * em}, canvas.shortened(title, w - 2.4 * em, 1.3 * em, true),
              {.size = 1.3 * em, .bold = true, .paint = {kInk}});
  // One colour bar for all.
  const Box bar{1.2 * em, 3.2 * em, std::min(22 * em, w - 12 * em), 0.9 * em};
  Image colours(256, 1);
  for (int x = 0; x < 256; ++x) colours.at(x, 0) = premultiplied(error_colour(x / 255.0));
  canvas.image(bar, colours, false);
  canvas.stroke(bar, 0.05 * em, {kInk, 0.8});
  canvas.text({bar.x, bar.bottom() + 0.4 * em}, "0",
              {.size = 0.8 * em, .paint = {kQuiet}, .vertical = Align::end});
  canvas.text({bar.right(), bar.bottom() + 0.4 * em}, number_text(range) + " and more",
              {.size = 0.8 * em, .paint = {kQuiet}, .horizontal = Align::end, .vertical = Align::end});
  const double beside = bar.right() + 1.2 * em;
  const auto hint = [&](const char* text, double y) {
    canvas.text({beside, y}, canvas.shortened(text, w - beside - 1.2 * em, 0.8 * em),
                {.size = 0.8 * em, .paint = {kQuiet}, .vertical = Align::middle});
  };
  hint("largest error of the points there; lines: knots", bar.centre().y);
  hint("u to the right, v upwards", bar.bottom() + 0.9 * em);

  const Box room{em, 6 * em, w - 2 * em, h - 7 * em};
  const double label = 2.5 * em, gap = 0.8 * em;
  const auto [columns, side] = panel_grid(surfaces.size(), room, label, gap);
  // No wider apart than they are wide: headings stand nearer to their own panel than to the next.
  const double across = std::min(room.width / columns, 1.25 * side + gap), left = 1.2 * em;
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    const std::size_t row = k / columns, column = k % columns;
    const double x = left + across * static_cast<double>(column);
    const double y = room.y + (side + label + gap) * static_cast<double>(row);
    canvas.text({x, y + em}, canvas.shortened(surfaces[k].name, side, 0.95 * em, true),
                {.size = 0.95 * em, .bold = true, .paint = {kInk}});
    canvas.text({x, y + 2.1 * em}, canvas.shortened(surfaces[k].remark, side, 0.8 * em),
                {.size = 0.8 * em, .paint = {kQuiet}});
    draw_panel(canvas, {x, y + label, side, side}, surfaces[k], points, range);
  }
  return canvas.finish();
}

}  // namespace knotfit
