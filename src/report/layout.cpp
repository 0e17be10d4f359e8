#include "report/layout.h"

#include <algorithm>
#include <cmath>

#include "report/legend.h"
#include "report/parameter_plane.h"
namespace knotfit::report {
namespace {

// Arranges the panels and the legend in a box; sizes in em where not said otherwise.
class Arrangement {
 public:
  Arrangement(const Canvas& canvas, const Content& content, Layout& layout, const Box& box)
      : canvas_(canvas),
        content_(content),
        l_(layout),
        box_(box),
        em_(layout.em),
        aspect_(plane_aspect(content)) {}

  void choose() {
    if (!l_.full)
      small();
    else if (box_.width - legend_side() - plane_column() - 2 * gap() >= 1.4 * box_.height)
      three_columns();
    else if (box_.width >= 1.15 * box_.height)
      two_columns();
    else
      rows();
  }

 private:
  double legend_height(double width) const { return report::legend_height(canvas_, content_, width, em_); }
  double heading() const { return 1.9 * em_; }
  double gap() const { return 2 * em_; }
  // What the plane's axes take beside it and under it.
  double beside() const { return 5.2 * em_; }
  double under() const { return 2.9 * em_; }
  double plane_height(double width) const { return std::max(width - beside(), em_) / aspect_ + under(); }

  void put_surface(double x, double y, double width, double height) {
    l_.surface_heading = {x, y, width, heading()};
    l_.surface = {x, y + heading(), width, height - heading()};
  }
  void put_plane(double x, double y, double width, double height) {
    l_.plane_heading = {x, y, width, heading()};
    l_.plane = {x, y + heading(), width, height - heading()};
  }

  // The surface, the legend where it fits, the plane beside on wide pages.
  void small() {
    double height = box_.height;
    const double legend = legend_height(box_.width);
    if (height > legend + 9 * em_ && box_.width > 16 * em_) {
      l_.legend = {box_.x, box_.bottom() - legend, box_.width, legend};
      height -= legend + 0.8 * em_;
    }
    const bool wide = box_.width > 1.8 * height;
    if (wide) l_.plane = {box_.right() - height, box_.y, height, height};
    l_.surface = {box_.x, box_.y, box_.width - (wide ? height + em_ : 0), height};
  }

  double legend_side() const { return std::max(0.24 * box_.width, 22 * em_); }
  // Width of a plane as high as the box.
  double plane_column() const {
    return std::max(box_.height - heading() - under(), em_) * aspect_ + beside();
  }

  void three_columns() {
    const double side = legend_side(), plane = plane_column();
    l_.legend = {box_.right() - side, box_.y + heading() + 1.5 * em_, side, legend_height(side)};
    put_plane(l_.legend.x - gap() - plane, box_.y, plane, box_.height);
    put_surface(box_.x, box_.y, l_.plane.x - gap() - box_.x, box_.height);
  }

  // The plane over the legend, as wide as the height allows.
  void two_columns() {
    const double apart = 1.1 * em_;
    const double least = std::min(0.40 * box_.width, 27 * em_);
    double width = 0.40 * box_.width;
    while (width > least && heading() + plane_height(width) + apart + legend_height(width) > box_.height)
      width *= 0.98;
    width = std::max(width, least);
    const double legend = legend_height(width);
    const double plane =
        std::min(plane_height(width), std::max(box_.height - heading() - legend - apart, em_));
    const double x = box_.right() - width;
    put_plane(x, box_.y, width, heading() + plane);
    l_.legend = {x, l_.plane.bottom() + apart, width, legend};
    put_surface(box_.x, box_.y, box_.width - width - gap(), box_.height);
  }

  // The surface on top, below it the plane with the legend at its side, or under it. Neither panel
  // grows higher than its drawing can use.
  void rows() {
    const double side = legend_side();
    const bool at_side = box_.width - side - gap() > 24 * em_ && box_.height < 1.75 * box_.width;
    const double width = at_side ? box_.width - side - gap() : box_.width;
    const double legend = legend_height(at_side ? side : box_.width);
    const double apart = 1.4 * em_;
    const double rest = box_.height - 2 * heading() - gap() - (at_side ? 0 : apart + legend);
    const double plane = std::min(plane_height(width), 0.48 * rest);
    const double surface = std::min(rest - plane, 0.80 * box_.width);
    put_surface(box_.x, box_.y, box_.width, heading() + surface);
    put_plane(box_.x, l_.surface.bottom() + gap(), width, heading() + plane);
    l_.legend = at_side ? Box{box_.right() - side, l_.plane.y + std::max(0.0, (plane - under() - legend) / 2),
                              side, legend}
                        : Box{box_.x, l_.plane.bottom() + apart, box_.width, legend};
  }

  const Canvas& canvas_;
  const Content& content_;
  Layout& l_;
  Box box_;
  double em_, aspect_;
};

}  // namespace

double body_size(double width, double height) {
  return std::max(7.0, 17 * std::sqrt(std::min(width / 1600, height / 900)));
}

bool full_page(double width, double height, double em) {
  return height > 1.2 * width ? width >= 34 * em : width >= 50 * em && height >= 30 * em;
}

Layout lay_out(const Canvas& canvas, const Content& content) {
  Layout l;
  const double width = canvas.width(), height = canvas.height();
  const double em = l.em = body_size(width, height), margin = 1.7 * em;
  const double inside = width - 2 * margin;
  l.full = full_page(width, height, em);

  double top = (l.full ? 1.4 : 0.8) * em, bottom = height - (l.full ? 1.2 : 0.8) * em;
  if (!content.input->title.empty()) {
    l.title = {margin, top, inside, 1.5 * em};
    top += 2.0 * em;
  }
  if (l.full && !content.input->subtitle.empty()) {
    l.subtitle = canvas.wrapped(content.input->subtitle, inside, 0.95 * em, 2);
    const double tall = 1.35 * em * static_cast<double>(l.subtitle.size());
    l.subtitle_box = {margin, top + 0.3 * em, inside, tall};
    top += tall;
  }
  if (l.full) {
    const double tall = facts_height(canvas, facts_of(content), inside, em);
    l.facts = {margin, bottom - tall, inside, tall};
    bottom -= tall + 1.7 * em;
    top += 0.9 * em;
  }
  Arrangement(canvas, content, l, {margin, top, inside, std::max(bottom - top, 1.0)}).choose();
  return l;
}

}  // namespace knotfit::report
