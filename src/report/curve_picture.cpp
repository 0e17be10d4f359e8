#include "knotfit/curve_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "knotfit/exceptions.h"
#include "report/canvas.h"
#include "report/content.h"
#include "report/number_text.h"
namespace knotfit {
namespace {

using namespace report;

/// Which two coordinates are drawn: of a space curve those of largest extent.
struct View {
  int across = 0, up = 1;
  bool over_t = false;  ///< one component
};

View view_of(const Curve& curve) {
  const int d = curve.dimension();
  if (d == 1) return {0, 0, true};
  std::vector<double> extent(d);
  for (int e = 0; e < d; ++e) {
    double low = INFINITY, high = -INFINITY;
    for (Index i = 0; i < curve.size(); ++i) {
      low = std::min(low, curve.control_points()[i * d + e]);
      high = std::max(high, curve.control_points()[i * d + e]);
    }
    extent[e] = high - low;
  }
  std::vector<int> order(d);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return extent[a] > extent[b]; });
  return {std::min(order[0], order[1]), std::max(order[0], order[1]), false};
}

struct Frame2 {
  double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
  void take(Vec2 p) {
    x0 = std::min(x0, p.x);
    x1 = std::max(x1, p.x);
    y0 = std::min(y0, p.y);
    y1 = std::max(y1, p.y);
  }
};

void check(const CurvePictureInput& input) {
  if (!input.curve || input.curve->control_points().empty())
    throw InvalidInput("a picture needs a curve, and none was given");
  const std::size_t n = input.t.size(), d = static_cast<std::size_t>(input.curve->dimension());
  if (input.points.size() != n * d)
    throw InvalidInput(
        fmt::format("{} numbers are no {} points of {} coordinates", input.points.size(), n, d));
  if (!input.errors.empty() && input.errors.size() != n)
    throw InvalidInput(fmt::format("{} errors for {} points", input.errors.size(), n));
  for (const auto* list : {&input.points, &input.t, &input.errors})
    for (double x : *list)
      if (!std::isfinite(x)) throw InvalidInput("a number that is not finite cannot be drawn");
}

}  // namespace

std::string draw_curve_picture(const CurvePictureInput& input, const std::string& extension,
                               const PictureOptions& options) {
  const Format format = picture_format(extension);
  check_page(options.width, options.height);
  check(input);
  const Curve& curve = *input.curve;
  const int d = curve.dimension();
  const View view = view_of(curve);
  const auto seen = [&](double t, const double* p) {
    return view.over_t ? Vec2{input.x0 + t * (input.x1 - input.x0), p[0]} : Vec2{p[view.across], p[view.up]};
  };

  std::vector<double> t;
  const std::vector<double> breaks = curve.knots().breaks();
  for (std::size_t s = 0; s + 1 < breaks.size(); ++s)
    for (int k = 0; k < 40; ++k) t.push_back(breaks[s] + (breaks[s + 1] - breaks[s]) * k / 40.0);
  t.push_back(breaks.back());
  const std::vector<double> values = evaluate(curve, t), at_breaks = evaluate(curve, breaks);
  std::vector<Vec2> path, polygon, knots, points;
  for (std::size_t k = 0; k < t.size(); ++k) path.push_back(seen(t[k], values.data() + k * d));
  for (std::size_t k = 0; k < breaks.size(); ++k) knots.push_back(seen(breaks[k], at_breaks.data() + k * d));
  const std::vector<double> greville = curve.knots().greville();
  for (Index i = 0; i < curve.size(); ++i)
    polygon.push_back(seen(greville[i], curve.control_points().data() + i * d));
  for (std::size_t k = 0; k < input.t.size(); ++k)
    points.push_back(seen(input.t[k], input.points.data() + k * d));

  Frame2 frame;
  for (const auto* list : {&path, &points, &polygon})
    for (Vec2 p : *list) frame.take(p);
  Canvas canvas(format, options.width, options.height);
  canvas.document_title(input.title);
  const double w = options.width, h = options.height, em = std::clamp(h / 45.0, 8.0, 40.0);
  canvas.fill({0, 0, w, h}, {{1, 1, 1}});
  canvas.text({1.5 * em, 2.4 * em}, canvas.shortened(input.title, w - 3 * em, 1.3 * em, true),
              {.size = 1.3 * em, .bold = true, .paint = {kInk}});
  canvas.text({1.5 * em, 3.9 * em}, canvas.shortened(input.subtitle, w - 3 * em, 0.9 * em),
              {.size = 0.9 * em, .paint = {kQuiet}});
  const Box box{3 * em, 5.5 * em, w - 6 * em, h - 9.5 * em};
  double sx = frame.x1 > frame.x0 ? box.width / (frame.x1 - frame.x0) : 0;
  double sy = frame.y1 > frame.y0 ? box.height / (frame.y1 - frame.y0) : 0;
  if (!view.over_t) {  // one scale for both
    if (sx == 0) sx = sy;
    if (sy == 0) sy = sx;
    sx = sy = std::min(sx, sy);
  }
  const auto on_page = [&](Vec2 p) {
    return Vec2{box.centre().x + (p.x - (frame.x0 + frame.x1) / 2) * sx,
                box.centre().y - (p.y - (frame.y0 + frame.y1) / 2) * sy};
  };
  for (auto* list : {&path, &polygon, &knots, &points})
    for (Vec2& p : *list) p = on_page(p);

  canvas.polyline(polygon, 0.05 * em, {kQuiet, 0.6});
  for (Vec2 p : polygon) canvas.ring(p, 0.22 * em, 0.06 * em, {kQuiet, 0.9});
  const double largest = input.errors.empty()
                             ? 0
                             : std::max(*std::max_element(input.errors.begin(), input.errors.end()), 1e-300);
  for (std::size_t k = 0; k < points.size(); ++k)
    canvas.disc(points[k], 0.16 * em,
                {input.errors.empty() ? kQuiet : diverging(std::clamp(input.errors[k] / largest, 0.0, 1.0))});
  canvas.polyline(path, 0.11 * em, {kInk, 0.9});
  for (Vec2 p : knots) canvas.fill({p.x - 0.2 * em, p.y - 0.2 * em, 0.4 * em, 0.4 * em}, {{0.1, 0.35, 0.75}});

  std::string key =
      fmt::format("squares: knots ({}); rings: control points ({})", breaks.size(), curve.size());
  if (!points.empty()) key += fmt::format("; dots: points ({})", points.size());
  if (largest > 1e-300) key += ", darkest at an error of " + number_text(largest);
  canvas.text({1.5 * em, h - 1.5 * em}, canvas.shortened(key, w - 3 * em, 0.9 * em),
              {.size = 0.9 * em, .paint = {kQuiet}});
  return canvas.finish();
}

}  // namespace knotfit
