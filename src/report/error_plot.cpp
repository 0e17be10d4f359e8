#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "knotfit/comparison_picture.h"
#include "knotfit/exceptions.h"
#include "report/canvas.h"
#include "report/compose.h"
#include "report/content.h"
#include "report/number_text.h"
namespace knotfit {
namespace {

using namespace report;

/// Twelve hues of equal lightness and chroma, then darker ones: a mark tells those apart that look alike.
Rgb series_colour(std::size_t k) {
  const double hue = 2 * 3.14159265358979 * static_cast<double>((k * 5) % 12) / 12;
  const double light = k < 12 ? 0.58 : 0.42;
  return from_oklab({light, 0.14 * std::cos(hue), 0.14 * std::sin(hue)});
}

void draw_mark(Canvas& canvas, Vec2 at, std::size_t k, double r) {
  const Paint paint{series_colour(k)};
  switch (k % 4) {
    case 0:
      canvas.disc(at, r, paint);
      break;
    case 1:
      canvas.fill({at.x - 0.9 * r, at.y - 0.9 * r, 1.8 * r, 1.8 * r}, paint);
      break;
    case 2: {
      const std::array<Vec2, 3> t{Vec2{at.x, at.y - 1.2 * r}, Vec2{at.x + 1.1 * r, at.y + 0.8 * r},
                                  Vec2{at.x - 1.1 * r, at.y + 0.8 * r}};
      canvas.polygon(t, paint);
      break;
    }
    default: {
      const std::array<Vec2, 4> t{Vec2{at.x, at.y - 1.3 * r}, Vec2{at.x + 1.3 * r, at.y},
                                  Vec2{at.x, at.y + 1.3 * r}, Vec2{at.x - 1.3 * r, at.y}};
      canvas.polygon(t, paint);
    }
  }
}

struct Range {
  double low = INFINITY, high = -INFINITY;  // logarithms to base 10
  void take(double x) {
    low = std::min(low, std::log10(x));
    high = std::max(high, std::log10(x));
  }
  void widen(double least) {
    const double more = std::max(0.04 * (high - low), (least - (high - low)) / 2);
    low -= more;
    high += more;
  }
  double share(double x) const { return (std::log10(x) - low) / (high - low); }
};

}  // namespace

std::string draw_error_plot(const std::vector<ErrorSeries>& series, const std::string& title,
                            const std::string& quantity, const std::string& extension,
                            const PictureOptions& options) {
  const Format format = picture_format(extension);
  check_page(options.width, options.height);
  Range across, up;
  for (const ErrorSeries& s : series)
    for (const auto& [count, error] : s.points) {
      if (!(count > 0 && error > 0) || !std::isfinite(count) || !std::isfinite(error))
        throw InvalidInput(
            fmt::format("{}: {} control points with an error of {}; a logarithmic plot needs both "
                        "positive and finite",
                        s.name, count, error));
      across.take(count);
      up.take(error);
    }
  if (!std::isfinite(across.low)) throw InvalidInput("a plot of errors needs at least one point");
  across.widen(0.3);
  up.widen(0.3);

  Canvas canvas(format, options.width, options.height);
  canvas.document_title(title);
  const double em = std::clamp(options.height / 45.0, 8.0, 40.0), w = options.width, h = options.height;
  canvas.fill({0, 0, w, h}, {{1, 1, 1}});
  canvas.text({1.5 * em, 2.4 * em}, canvas.shortened(title, w - 3 * em, 1.3 * em, true),
              {.size = 1.3 * em, .bold = true, .paint = {kInk}});

  // The key stands in the order of the last errors, worst on top, as the lines end.
  std::vector<std::size_t> order;
  double widest = 0;
  std::vector<std::vector<std::pair<double, double>>> sorted;
  for (std::size_t k = 0; k < series.size(); ++k) {
    sorted.push_back(series[k].points);
    std::sort(sorted.back().begin(), sorted.back().end());
    if (sorted.back().empty()) continue;
    order.push_back(k);
    widest = std::max(widest, canvas.text_width(series[k].name, 0.9 * em));
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return sorted[a].back().second > sorted[b].back().second;
  });
  widest = std::min(widest, 0.3 * w);
  const Box box{6.5 * em, 4 * em, w - 6.5 * em - widest - 5 * em, h - 8.5 * em};
  const auto at = [&](double count, double error) {
    return Vec2{box.x + across.share(count) * box.width, box.bottom() - up.share(error) * box.height};
  };
  std::vector<Vec2> grid;
  for (double x : make_log_ticks(across.low, across.high)) {
    const double px = box.x + across.share(x) * box.width;
    grid.insert(grid.end(), {{px, box.y}, {px, box.bottom()}});
    canvas.text({px, box.bottom() + 0.5 * em}, short_number_text(x),
                {.size = 0.85 * em, .paint = {kQuiet}, .horizontal = Align::middle, .vertical = Align::end});
  }
  for (double y : make_log_ticks(up.low, up.high)) {
    const double py = box.bottom() - up.share(y) * box.height;
    grid.insert(grid.end(), {{box.x, py}, {box.right(), py}});
    canvas.text({box.x - 0.5 * em, py}, short_number_text(y),
                {.size = 0.85 * em, .paint = {kQuiet}, .horizontal = Align::end, .vertical = Align::middle});
  }
  canvas.segments(grid, 0.05 * em, {kQuiet, 0.3});
  canvas.stroke(box, 0.07 * em, {kInk, 0.8});
  canvas.text({box.centre().x, box.bottom() + 2.2 * em}, "control points",
              {.size = em, .paint = {kInk}, .horizontal = Align::middle, .vertical = Align::end});
  canvas.text({1.6 * em, box.centre().y}, quantity,
              {.size = em, .paint = {kInk}, .horizontal = Align::middle, .angle = -3.14159265358979 / 2});

  const double line = std::min(1.5 * em, box.height / static_cast<double>(order.size()));
  double key = box.y + 0.6 * line;
  for (std::size_t k : order) {
    std::vector<Vec2> path;
    for (const auto& [count, error] : sorted[k]) path.push_back(at(count, error));
    canvas.polyline(path, 0.12 * em, {series_colour(k), 0.85});
    for (const Vec2& p : path) draw_mark(canvas, p, k, 0.3 * em);
    const double x = box.right() + 1.2 * em;
    const std::array<Vec2, 2> sample{Vec2{x, key}, Vec2{x + 1.8 * em, key}};
    canvas.segments(sample, 0.12 * em, {series_colour(k), 0.85});
    draw_mark(canvas, {x + 0.9 * em, key}, k, 0.3 * em);
    const double size = std::min(0.9 * em, 0.8 * line);
    canvas.text({x + 2.3 * em, key}, canvas.shortened(series[k].name, widest, size),
                {.size = size, .paint = {kInk}, .vertical = Align::middle});
    key += line;
  }
  return canvas.finish();
}

}  // namespace knotfit
