#include "report/legend.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "report/number_text.h"
#include "report/view_axes.h"
namespace knotfit::report {
namespace {

enum class Mark { knots, worst, thin, gap, fold };
struct Entry {
  Mark mark;
  std::string text;
};

std::string with_unit(const std::string& number, const std::string& unit) {
  return unit.empty() ? number : number + " " + unit;
}

std::vector<Entry> entries(const Content& c) {
  std::vector<Entry> out{{Mark::knots, "knot lines"}};
  if (c.worst >= 0 && c.max > 0) out.push_back({Mark::worst, "worst point"});
  if (!c.thin.empty()) out.push_back({Mark::thin, "data too thin to promise anything"});
  if (!c.input->fold_places.empty()) out.push_back({Mark::fold, "folds over the mesh"});
  if (c.gaps) out.push_back({Mark::gap, "no data"});
  return out;
}

constexpr double kMarkWidth = 1.6, kGap = 1.2, kRow = 1.65, kText = 0.85;  // in em

// Entries in rows no wider than the box: for each its x and row.
std::vector<std::pair<double, int>> flow(const Canvas& canvas, const std::vector<Entry>& list, double width,
                                         double em) {
  std::vector<std::pair<double, int>> out;
  double x = 0;
  int row = 0;
  for (const Entry& e : list) {
    const double w = kMarkWidth * em + 0.5 * em + canvas.text_width(e.text, kText * em);
    if (x > 0 && x + w > width) {
      x = 0;
      ++row;
    }
    out.emplace_back(x, row);
    x += w + kGap * em;
  }
  return out;
}

double marks_height(const Canvas& canvas, const Content& c, double width, double em) {
  return (flow(canvas, entries(c), width, em).back().second + 1) * kRow * em;
}

bool has_bar(const Content& c) {
  return c.colouring == Colouring::error || (c.colouring == Colouring::height && c.samples.scale.z > 0);
}

double bar_height(const Content& c, double em) {
  return c.colouring == Colouring::error && c.scale.tolerance > 0 ? 5.35 * em : 4.1 * em;
}

void draw_mark(Canvas& canvas, Mark mark, Vec2 at, double em) {
  const Box box{at.x, at.y - 0.5 * em, kMarkWidth * em, em};
  const double line = em / 17;
  auto hatch = [&](double slope, double width, const Paint& paint) {
    std::vector<Vec2> ends;
    for (double c = 0.3 * em; c < box.width + box.height; c += 0.42 * 1.414 * em) {
      const double from = std::max(0.0, c - box.height), to = std::min(box.width, c);
      auto y = [&](double x) { return slope > 0 ? box.y + (c - x) : box.bottom() - (c - x); };
      ends.insert(ends.end(), {{box.x + from, y(from)}, {box.x + to, y(to)}});
    }
    canvas.segments(ends, width, paint);
  };
  switch (mark) {
    case Mark::knots: {
      const std::array<Vec2, 2> ends{Vec2{box.x, at.y}, Vec2{box.right(), at.y}};
      canvas.segments(ends, 1.1 * line, {kInk, 0.7});
      break;
    }
    case Mark::worst:
      draw_worst_mark(canvas, {box.centre().x, at.y}, em);
      break;
    case Mark::fold:
      draw_fold_mark(canvas, box.centre(), 0, em);
      break;
    case Mark::thin:
      hatch(1, 0.075 * em, {kInk, 0.85});
      canvas.stroke(box, 0.075 * em, {kInk, 0.85});
      break;
    case Mark::gap:
      canvas.fill(box, {kNoData});
      hatch(-1, 0.13 * em, {{1, 1, 1}, 0.7});
      break;
  }
}

struct Bar {
  Box box;
  double low, high;
  double x(double value) const { return box.x + (value - low) / (high - low) * box.width; }
};

void draw_ticks(Canvas& canvas, const Bar& bar, const Ticks& ticks, double em) {
  const double size = 0.82 * em;
  std::vector<Vec2> marks;
  double free_x = -INFINITY;
  for (std::size_t k = 0; k < ticks.at.size(); ++k) {
    const double x = bar.x(ticks.at[k]), half = canvas.text_width(ticks.text[k], size) / 2;
    marks.insert(marks.end(), {{x, bar.box.bottom()}, {x, bar.box.bottom() + 0.3 * em}});
    if (x - half < free_x) continue;
    canvas.text({x, bar.box.bottom() + 0.55 * em}, ticks.text[k],
                {.size = size, .paint = {kQuiet}, .horizontal = Align::middle, .vertical = Align::end});
    free_x = x + half + 0.5 * em;
  }
  canvas.segments(marks, em / 17, {kInk, 0.8});
}

// Steps of a colour each: sharp edges at the tolerance, the same in every format.
template <class Colour>
void fill_bar(Canvas& canvas, const Bar& bar, const Canvas& page, const Colour& colour) {
  const int width = std::clamp(static_cast<int>(bar.box.width * page.resolution()), 1, 4000);
  Image image(width, 1);
  for (int k = 0; k < width; ++k)
    image.at(k, 0) = premultiplied(colour(bar.low + (k + 0.5) / width * (bar.high - bar.low)));
  canvas.image(bar.box, image, false);
}

void draw_bar(Canvas& canvas, const Content& c, const Box& box, double em) {
  const std::string& unit = c.input->unit;
  const bool error = c.colouring == Colouring::error;
  const bool band = error && c.scale.tolerance > 0;
  const double inset = 1.4 * em;  // room for the outer ticks' texts and the arrows
  Bar bar{{box.x + inset, box.y + (band ? 2.9 : 1.65) * em, box.width - 2 * inset, 0.85 * em}, 0, 1};
  std::string heading;
  Ticks ticks;
  const int most = std::clamp(static_cast<int>(bar.box.width / (3.6 * em)), 2, 7);
  if (error) {
    bar.low = c.scale.one_sided ? 0 : -c.scale.range;
    bar.high = c.scale.range;
    ticks = make_ticks(bar.low, bar.high, most);
    const bool in_space = c.input->surface->dimension() >= 3 && !c.scale.one_sided;
    heading = ticks.name(c.scale.one_sided ? "error |S − P|"
                         : in_space        ? "error, signed along the normal"
                                           : "error S − P",
                         unit);
    fill_bar(canvas, bar, canvas, [&](double e) { return c.scale.colour(e); });
  } else {
    bar.low = c.samples.low.z;
    bar.high = c.samples.high.z;
    ticks = make_ticks(bar.low, bar.high, most);
    heading = ticks.name("height z", unit);
    fill_bar(canvas, bar, canvas, [&](double z) { return *c.colour_at(0, 0, z); });
  }
  canvas.text({box.x, box.y}, canvas.shortened(heading, box.width, 0.9 * em, true),
              {.size = 0.9 * em, .bold = true, .paint = {kInk}, .vertical = Align::end});
  if (error && c.scale.clipped) {
    const double y0 = bar.box.y, y1 = bar.box.bottom(), reach = 0.7 * em;
    const std::array<Vec2, 3> right{Vec2{bar.box.right(), y0}, Vec2{bar.box.right() + reach, (y0 + y1) / 2},
                                    Vec2{bar.box.right(), y1}};
    canvas.polygon(right, {c.scale.colour(c.scale.range)});
    canvas.polyline(right, em / 17, {kInk, 0.8});
    if (!c.scale.one_sided) {
      const std::array<Vec2, 3> left{Vec2{bar.box.x, y0}, Vec2{bar.box.x - reach, (y0 + y1) / 2},
                                     Vec2{bar.box.x, y1}};
      canvas.polygon(left, {c.scale.colour(-c.scale.range)});
      canvas.polyline(left, em / 17, {kInk, 0.8});
    }
  }
  canvas.stroke(bar.box, em / 17, {kInk, 0.8});
  draw_ticks(canvas, bar, ticks, em);
  if (!band) return;
  // A bracket over the band, its text kept inside the box.
  const double from = bar.x(c.scale.one_sided ? 0 : -c.scale.tolerance), to = bar.x(c.scale.tolerance);
  const double top = bar.box.y - 0.42 * em, low = bar.box.y - 0.08 * em;
  const std::array<Vec2, 4> bracket{Vec2{from, low}, Vec2{from, top}, Vec2{to, top}, Vec2{to, low}};
  canvas.polyline(bracket, 1.2 * em / 17, {kInk, 0.9});
  const std::string text = (c.scale.one_sided ? "within tolerance " : "within tolerance ±") +
                           with_unit(short_number_text(c.scale.tolerance), unit);
  const double size = 0.78 * em;
  const std::string shown = canvas.shortened(text, box.width, size);
  const double half = canvas.text_width(shown, size) / 2;
  const double x = std::clamp((from + to) / 2, box.x + half, std::max(box.x + half, box.right() - half));
  canvas.text({x, top - 0.3 * em}, shown, {.size = size, .paint = {kInk}, .horizontal = Align::middle});
}

constexpr double kFactGap = 2.4, kFactRow = 2.5;  // in em

std::vector<std::pair<double, int>> flow_facts(const Canvas& canvas, const Facts& facts, double width,
                                               double em) {
  std::vector<std::pair<double, int>> out;
  double x = 0;
  int row = 0;
  for (const auto& [name, value] : facts) {
    const double w = std::max(canvas.text_width(name, 0.76 * em), canvas.text_width(value, em));
    if (x > 0 && x + w > width) {
      x = 0;
      ++row;
    }
    out.emplace_back(x, row);
    x += w + kFactGap * em;
  }
  return out;
}

}  // namespace

double legend_height(const Canvas& canvas, const Content& c, double width, double em) {
  return (has_bar(c) ? bar_height(c, em) + 0.35 * em : 0) + marks_height(canvas, c, width, em);
}

void draw_legend(Canvas& canvas, const Content& c, const Box& box, double em) {
  double y = box.y;
  if (has_bar(c)) {
    draw_bar(canvas, c, box, em);
    y += bar_height(c, em) + 0.35 * em;
  }
  const std::vector<Entry> list = entries(c);
  const auto places = flow(canvas, list, box.width, em);
  for (std::size_t k = 0; k < list.size(); ++k) {
    const double x = box.x + places[k].first, middle = y + (places[k].second + 0.5) * kRow * em;
    draw_mark(canvas, list[k].mark, {x, middle}, em);
    const double room = box.width - places[k].first - (kMarkWidth + 0.5) * em;
    canvas.text({x + (kMarkWidth + 0.5) * em, middle}, canvas.shortened(list[k].text, room, kText * em),
                {.size = kText * em, .paint = {kInk}, .vertical = Align::middle});
  }
}

Facts facts_of(const Content& c) {
  const Surface& s = *c.input->surface;
  const std::string& unit = c.input->unit;
  Facts facts{{"control points",
               fmt::format("{} × {} = {}", s.size_u(), s.size_v(), count_text(s.control_point_count()))},
              {"degree", fmt::format("{} × {}", s.degree_u(), s.degree_v())}};
  if (c.point_count > 0) facts.emplace_back("points", count_text(c.point_count));
  if (c.colouring == Colouring::error) {
    facts.emplace_back("RMS error", with_unit(number_text(c.rms), unit));
    facts.emplace_back("largest error", with_unit(number_text(c.max), unit));
  }
  if (c.input->tolerance > 0)
    facts.emplace_back("tolerance", with_unit(short_number_text(c.input->tolerance), unit));
  return facts;
}

double facts_height(const Canvas& canvas, const Facts& facts, double width, double em) {
  return (flow_facts(canvas, facts, width, em).back().second + 1) * kFactRow * em;
}

void draw_facts(Canvas& canvas, const Facts& facts, const Box& box, double em) {
  const auto places = flow_facts(canvas, facts, box.width, em);
  for (std::size_t k = 0; k < facts.size(); ++k) {
    const double x = box.x + places[k].first, y = box.y + places[k].second * kFactRow * em;
    const double room = box.width - places[k].first;
    canvas.text({x, y}, canvas.shortened(facts[k].first, room, 0.76 * em),
                {.size = 0.76 * em, .paint = {kQuiet}, .vertical = Align::end});
    canvas.text({x, y + 2.0 * em}, canvas.shortened(facts[k].second, room, em),
                {.size = em, .paint = {kInk}});
  }
}

}  // namespace knotfit::report
