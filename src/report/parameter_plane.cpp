#include "report/parameter_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/parallel.h"
#include "knotfit/evaluate.h"
#include "report/number_text.h"
#include "report/view_axes.h"
namespace knotfit::report {
namespace {

constexpr Index kDiscs = 3000;                 // more points than this become pixels
constexpr Rgb kPointColour{0.35, 0.38, 0.44};  // where there are no errors
constexpr double kMostPixels = 16e6;

// The domain's rectangle: v grows upward.
struct Plane {
  Box box;
  Domain domain;
  Vec2 at(double u, double v) const {
    return {box.x + domain.to_unit_u(u) * box.width, box.bottom() - domain.to_unit_v(v) * box.height};
  }
};

Plane place(const Content& content, const Box& panel, double left, double below) {
  const double width = std::max(panel.width - left, 1.0), height = std::max(panel.height - below, 1.0);
  const double aspect = plane_aspect(content);
  const double w = std::min(width, height * aspect), h = w / aspect;
  return {{panel.x + left + (width - w) / 2, panel.y + (height - h) / 2, w, h}, content.domain};
}

double point_radius(const Plane& plane, Index n, double em) {
  const double area = plane.box.width * plane.box.height / static_cast<double>(std::max<Index>(n, 1));
  return std::clamp(0.42 * std::sqrt(area), 0.04 * em, 0.26 * em);
}

Rgb point_colour(const Content& content, Index k) {
  return content.colouring == Colouring::error ? content.scale.colour(content.input->signed_errors[k])
                                               : kPointColour;
}

double severity(const Content& content, Index k) {
  return content.colouring == Colouring::error ? std::abs(content.input->signed_errors[k]) : 0;
}

void draw_discs(Canvas& canvas, const Content& content, const Plane& plane, double em) {
  std::vector<Index> order(static_cast<std::size_t>(content.point_count));
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return severity(content, a) < severity(content, b); });
  const double radius = point_radius(plane, content.point_count, em);
  for (Index k : order) {
    const Vec2 p = plane.at(content.points().u(k), content.points().v(k));
    canvas.disc(p, radius, {point_colour(content, k)});
    // An outline keeps pale points visible on white.
    if (radius > 0.18 * em) canvas.ring(p, radius, 0.035 * em, {kInk, 0.45});
  }
}

// Every pixel shows the worst of the points that cover it.
Image point_pixels(const Content& content, const Plane& plane, int width, int height, double radius) {
  constexpr int kFiner = 2;
  const int w = kFiner * width, h = kFiner * height;
  std::vector<float> worst(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), -1.0f);
  std::vector<std::int32_t> owner(worst.size(), -1);
  const double fine = w / plane.box.width, r = std::max(radius * fine, 0.5);
  for (Index k = 0; k < content.point_count; ++k) {
    const Vec2 p = plane.at(content.points().u(k), content.points().v(k));
    const double x = (p.x - plane.box.x) * fine, y = (p.y - plane.box.y) * fine;
    if (!(x > -r && x < w + r && y > -r && y < h + r)) continue;
    const auto bad = static_cast<float>(severity(content, k) / std::max(content.scale.largest, 1e-300));
    const int x0 = std::clamp(static_cast<int>(std::floor(x - r + 0.5)), 0, w - 1);
    const int x1 = std::clamp(static_cast<int>(std::ceil(x + r - 0.5)) - 1, x0, w - 1);
    const int y0 = std::clamp(static_cast<int>(std::floor(y - r + 0.5)), 0, h - 1);
    const int y1 = std::clamp(static_cast<int>(std::ceil(y + r - 0.5)) - 1, y0, h - 1);
    for (int py = y0; py <= y1; ++py)
      for (int px = x0; px <= x1; ++px) {
        if (r > 1.5 && std::hypot(px + 0.5 - x, py + 0.5 - y) > r) continue;
        const std::size_t at = static_cast<std::size_t>(py) * w + px;
        if (bad > worst[at]) {
          worst[at] = bad;
          owner[at] = static_cast<std::int32_t>(k);
        }
      }
  }
  Image image(width, height);
  parallel_for(height, [&](Index row) {
    for (int x = 0; x < width; ++x) {
      Rgb sum;
      int hits = 0;
      for (int dy = 0; dy < kFiner; ++dy)
        for (int dx = 0; dx < kFiner; ++dx) {
          const std::int32_t k = owner[static_cast<std::size_t>(row * kFiner + dy) * w + x * kFiner + dx];
          if (k < 0) continue;
          const Rgb c = point_colour(content, k);
          sum = {sum.r + c.r, sum.g + c.g, sum.b + c.b};
          ++hits;
        }
      if (hits > 0)
        image.at(x, static_cast<int>(row)) = premultiplied({sum.r / hits, sum.g / hits, sum.b / hits},
                                                           static_cast<double>(hits) / (kFiner * kFiner));
    }
  });
  return image;
}

void draw_points(Canvas& canvas, const Content& content, const Plane& plane, double em) {
  if (content.point_count <= kDiscs) {
    draw_discs(canvas, content, plane, em);
    return;
  }
  const double resolution =
      std::min(canvas.resolution(), std::sqrt(kMostPixels / 4 / (plane.box.width * plane.box.height)));
  const int width = std::max(1, static_cast<int>(std::lround(plane.box.width * resolution)));
  const int height = std::max(1, static_cast<int>(std::lround(plane.box.height * resolution)));
  canvas.image(plane.box,
               point_pixels(content, plane, width, height, point_radius(plane, content.point_count, em)));
}

// A surface alone: its heights, or its plain colour.
void draw_heights(Canvas& canvas, const Content& content, const Plane& plane) {
  if (content.colouring != Colouring::height) {
    canvas.fill(plane.box, {mix(kMaterial, {1, 1, 1}, 0.5)});
    return;
  }
  const Domain& d = content.domain;
  const int width = std::clamp(static_cast<int>(plane.box.width), 1, 1500);
  const int height = std::clamp(static_cast<int>(plane.box.height), 1, 1500);
  std::vector<double> u(static_cast<std::size_t>(width)), v(static_cast<std::size_t>(height));
  for (int k = 0; k < width; ++k) u[k] = d.u0 + (k + 0.5) / width * (d.u1 - d.u0);
  for (int k = 0; k < height; ++k) v[k] = d.v0 + (k + 0.5) / height * (d.v1 - d.v0);
  const Surface& surface = *content.input->surface;
  const std::vector<double> values = evaluate_grid(surface, u, v);
  const int dimension = surface.dimension();
  Image image(width, height);
  for (int x = 0; x < width; ++x)
    for (int y = 0; y < height; ++y) {
      const double z =
          values[(static_cast<std::size_t>(x) * height + y) * dimension + (dimension == 1 ? 0 : 2)];
      image.at(x, height - 1 - y) = premultiplied(content.colour_at(u[x], v[y], z).value_or(kNoData));
    }
  canvas.image(plane.box, image);
}

void draw_knot_lines(Canvas& canvas, const Content& content, const Plane& plane, double em) {
  const SurfaceSamples& s = content.samples;
  const double unit = em / 17;
  const Box& b = plane.box;
  for (bool in_u : {true, false}) {
    const std::vector<int>& multiplicity = in_u ? s.multiplicity_u : s.multiplicity_v;
    const double apart = (in_u ? b.width : b.height) / static_cast<double>(multiplicity.size());
    const double crowd = std::clamp(apart / (1.3 * em), 0.3, 1.0);
    for (std::size_t k = 1; k + 1 < multiplicity.size(); ++k) {
      const Vec2 p = in_u ? plane.at(s.u[s.knots_u[k]], content.domain.v0)
                          : plane.at(content.domain.u0, s.v[s.knots_v[k]]);
      const std::array<Vec2, 2> ends = in_u ? std::array<Vec2, 2>{Vec2{p.x, b.y}, Vec2{p.x, b.bottom()}}
                                            : std::array<Vec2, 2>{Vec2{b.x, p.y}, Vec2{b.right(), p.y}};
      canvas.segments(ends, unit * (0.5 + 0.4 * crowd) * (1 + 0.6 * (multiplicity[k] - 1)),
                      {kInk, 0.13 + 0.37 * crowd});
    }
  }
}

// Hatch lines are cut where the region ends: no clip path, small files.
// Grey with stripes, as on the surface.
void draw_openings(Canvas& canvas, const Content& content, const Plane& plane, double em) {
  if (content.openings.empty()) return;
  const Domain& d = content.domain;
  const double scale = std::min(2.0, std::sqrt(kMostPixels / (plane.box.width * plane.box.height)));
  const int width = std::max(1, static_cast<int>(plane.box.width * scale)),
            height = std::max(1, static_cast<int>(plane.box.height * scale));
  Image image(width, height);
  const double apart = 0.6 * em * scale;
  parallel_for(height, [&](Index row) {
    const double v = d.v1 - (static_cast<double>(row) + 0.5) / height * (d.v1 - d.v0);
    for (int x = 0; x < width; ++x) {
      if (!content.openings.inside(d.u0 + (x + 0.5) / width * (d.u1 - d.u0), v)) continue;
      const double along = (static_cast<double>(x) - static_cast<double>(row)) / apart;
      const bool stripe = along - std::floor(along) < 0.3;
      image.at(x, static_cast<int>(row)) = premultiplied(stripe ? mix(kNoData, {1, 1, 1}, 0.65) : kNoData);
    }
  });
  canvas.image(plane.box, image);
}

void draw_thin(Canvas& canvas, const Content& content, const Plane& plane, double em) {
  if (content.thin.empty()) return;
  const Box& b = plane.box;
  const Domain& d = content.domain;
  auto thin = [&](double x, double y) {
    return content.thin.ratio(d.u0 + (x - b.x) / b.width * (d.u1 - d.u0),
                              d.v0 + (b.bottom() - y) / b.height * (d.v1 - d.v0)) < 1;
  };
  std::vector<Vec2> hatch;
  const double apart = 0.42 * em * std::numbers::sqrt2, step = std::max(0.06 * em, 0.5);
  for (double c = b.x + b.y + apart / 2; c < b.right() + b.bottom(); c += apart) {
    // x + y = c inside the box
    const double from = std::max(b.x, c - b.bottom()), to = std::min(b.right(), c - b.y);
    double start = NAN;
    for (double x = from; x <= to; x += step) {
      const bool inside = thin(x, c - x);
      if (inside && std::isnan(start)) start = x;
      if (!std::isnan(start) && (!inside || x + step > to)) {
        const double end = inside ? to : x;
        hatch.insert(hatch.end(), {{start, c - start}, {end, c - end}});
        start = NAN;
      }
    }
  }
  canvas.segments(hatch, 0.17 * em, {{1, 1, 1}, 0.75});
  canvas.segments(hatch, 0.075 * em, {kInk, 0.85});
  std::vector<Vec2> outline = content.thin.outline();
  for (Vec2& p : outline) p = {b.x + p.x * b.width, b.bottom() - p.y * b.height};
  canvas.segments(outline, 0.075 * em, {kInk, 0.85});
}

}  // namespace

double plane_aspect(const Content& content) {
  if (content.input->surface->dimension() != 1 || !content.input->points) return 1;
  const double x = std::abs(content.map.u1 - content.map.u0) * (content.domain.u1 - content.domain.u0);
  const double y = std::abs(content.map.v1 - content.map.v0) * (content.domain.v1 - content.domain.v0);
  const double aspect = x / y;
  // Other units in x and y, or a strip: a square is easier to read.
  return aspect >= 0.5 && aspect <= 2 ? aspect : 1;
}

Box draw_parameter_plane(Canvas& canvas, const Content& content, const Box& panel, double em, bool axes) {
  const double size = 0.82 * em, tick = 0.34 * em;
  const Domain& d = content.domain;
  auto ordered = [](double a, double b) { return std::pair(std::min(a, b), std::max(a, b)); };
  // Oblique parameters have no axis of the user's.
  const ParameterMap map = content.map.sheared() ? ParameterMap{} : content.map;
  const auto [x0, x1] = ordered(map.from_u(d.u0), map.from_u(d.u1));
  const auto [y0, y1] = ordered(map.from_v(d.v0), map.from_v(d.v1));
  const double guess = std::min(panel.width, panel.height);
  const Ticks in_x = make_ticks(x0, x1, std::clamp(static_cast<int>(guess / (4.6 * em)), 2, 6));
  const Ticks in_y = make_ticks(y0, y1, std::clamp(static_cast<int>(guess / (3.2 * em)), 2, 6));
  double widest = 0;
  for (const std::string& t : in_y.text) widest = std::max(widest, canvas.text_width(t, size));
  const Plane plane =
      axes ? place(content, panel, widest + tick + 2.0 * em, 2.9 * em) : place(content, panel, 0, 0);
  const Box& b = plane.box;

  if (content.point_count > 0) {
    canvas.fill(b, {{1, 1, 1}});
    draw_openings(canvas, content, plane, em);
    draw_points(canvas, content, plane, em);
  } else {
    draw_heights(canvas, content, plane);
    draw_openings(canvas, content, plane, em);
  }
  draw_knot_lines(canvas, content, plane, em);
  draw_thin(canvas, content, plane, em);
  for (const FoldPlace& fold : content.input->fold_places)
    draw_fold_mark(canvas, plane.at(fold.u, fold.v),
                   std::sqrt(fold.share * b.width * b.height / std::numbers::pi), em);
  canvas.stroke(b, 1.2 * em / 17, {kInk, 0.85});
  if (content.worst >= 0 && content.max > 0)
    draw_worst_mark(canvas,
                    plane.at(std::clamp(content.points().u(content.worst), d.u0, d.u1),
                             std::clamp(content.points().v(content.worst), d.v0, d.v1)),
                    em);
  if (!axes) return b;

  std::vector<Vec2> marks;
  double free_x = -INFINITY;
  for (std::size_t k = 0; k < in_x.at.size(); ++k) {
    const double x = plane.at(map.to_u(in_x.at[k]), d.v0).x;
    const double half = canvas.text_width(in_x.text[k], size) / 2;
    marks.insert(marks.end(), {{x, b.bottom()}, {x, b.bottom() + tick}});
    if (x - half < free_x) continue;
    canvas.text({x, b.bottom() + tick + 0.3 * em}, in_x.text[k],
                {.size = size, .paint = {kQuiet}, .horizontal = Align::middle, .vertical = Align::end});
    free_x = x + half + 0.5 * em;
  }
  double free_y = INFINITY;
  for (std::size_t k = 0; k < in_y.at.size(); ++k) {
    const double y = plane.at(d.u0, map.to_v(in_y.at[k])).y;
    marks.insert(marks.end(), {{b.x, y}, {b.x - tick, y}});
    if (y > free_y) continue;
    canvas.text({b.x - tick - 0.25 * em, y}, in_y.text[k],
                {.size = size, .paint = {kQuiet}, .horizontal = Align::end, .vertical = Align::middle});
    free_y = y - 1.1 * em;
  }
  canvas.segments(marks, em / 17, {kInk, 0.8});
  canvas.text({b.centre().x, b.bottom() + tick + 1.35 * em},
              canvas.shortened(in_x.name(map.name_u), b.width, size),
              {.size = size, .paint = {kInk}, .horizontal = Align::middle, .vertical = Align::end});
  canvas.text({b.x - tick - widest - 0.75 * em, b.centre().y},
              canvas.shortened(in_y.name(map.name_v), b.height, size),
              {.size = size, .paint = {kInk}, .horizontal = Align::middle, .angle = -std::numbers::pi / 2});
  return b;
}

}  // namespace knotfit::report
