#include "report/canvas.h"

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "knotfit/exceptions.h"
namespace knotfit::report {
namespace {

constexpr double kCapHeight = 0.73;  // of DejaVu Sans, in its size

cairo_status_t append(void* out, const unsigned char* data, unsigned int length) {
  try {
    static_cast<std::string*>(out)->append(reinterpret_cast<const char*>(data), length);
    return CAIRO_STATUS_SUCCESS;
  } catch (...) {
    return CAIRO_STATUS_NO_MEMORY;
  }
}

void check(cairo_status_t status, int width, int height) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw InvalidInput(fmt::format("a picture of {} x {} cannot be drawn ({}); ask for a smaller one", width,
                                   height, cairo_status_to_string(status)));
}

// Cairo numbers the images of an SVG by a counter of the process; count from 1 in each file.
std::string with_own_numbers(const std::string& svg) {
  std::string out;
  out.reserve(svg.size());
  std::map<std::string, int> number;
  std::size_t done = 0;
  for (std::size_t at = svg.find_first_of("\"#"); at != std::string::npos;
       at = svg.find_first_of("\"#", at + 1)) {
    for (const char* word : {"surface", "image"}) {
      const std::size_t first = at + 1 + std::char_traits<char>::length(word);
      if (svg.compare(at + 1, first - at - 1, word) != 0) continue;
      std::size_t last = first;
      while (last < svg.size() && svg[last] >= '0' && svg[last] <= '9') ++last;
      if (last == first) continue;
      const std::string id = svg.substr(first, last - first);
      const int own = number.emplace(id, static_cast<int>(number.size()) + 1).first->second;
      out.append(svg, done, first - done);
      out += std::to_string(own);
      done = last;
    }
  }
  return out.append(svg, done, std::string::npos);
}

}  // namespace

struct Canvas::State {
  std::string bytes;
  cairo_surface_t* surface = nullptr;
  cairo_t* context = nullptr;
  ~State() {
    if (context) cairo_destroy(context);
    if (surface) cairo_surface_destroy(surface);
  }
  void source(const Paint& p) { cairo_set_source_rgba(context, p.colour.r, p.colour.g, p.colour.b, p.alpha); }
  void font(double size, bool bold) const {
    cairo_select_font_face(context, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                           bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(context, size);
  }
  void path(std::span<const Vec2> points) {
    cairo_new_path(context);
    for (const Vec2& p : points) cairo_line_to(context, p.x, p.y);
  }
};

std::uint32_t premultiplied(const Rgb& c, double alpha) {
  auto byte = [](double x) { return static_cast<std::uint32_t>(std::lround(255 * std::clamp(x, 0.0, 1.0))); };
  return byte(alpha) << 24 | byte(c.r * alpha) << 16 | byte(c.g * alpha) << 8 | byte(c.b * alpha);
}

Format picture_format(const std::string& extension) {
  if (extension == ".png") return Format::png;
  if (extension == ".svg") return Format::svg;
  if (extension == ".pdf") return Format::pdf;
  throw InvalidInput(fmt::format("\"{}\" is no extension of a picture: .png, .svg and .pdf are", extension));
}

void check_page(int width, int height) {
  const std::pair<const char*, int> sizes[] = {{"width", width}, {"height", height}};
  for (const auto& [name, size] : sizes)
    if (size < 200 || size > 20000)
      throw InvalidInput(fmt::format("a picture's {} of {} is outside 200 to 20000", name, size));
}

Canvas::Canvas(Format format, int width, int height)
    : state_(std::make_unique<State>()), format_(format), width_(width), height_(height) {
  State& s = *state_;
  switch (format) {
    case Format::png:
      s.surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
      break;
    case Format::svg:
      s.surface = cairo_svg_surface_create_for_stream(append, &s.bytes, width, height);
      break;
    case Format::pdf:
      s.surface = cairo_pdf_surface_create_for_stream(append, &s.bytes, width, height);
      // No date: the same input gives the same bytes.
      cairo_pdf_surface_set_metadata(s.surface, CAIRO_PDF_METADATA_CREATE_DATE, "");
      cairo_pdf_surface_set_metadata(s.surface, CAIRO_PDF_METADATA_CREATOR, "knotfit");
      break;
  }
  check(cairo_surface_status(s.surface), width, height);
  s.context = cairo_create(s.surface);
  cairo_font_options_t* options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);  // widths are those measured
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(s.context, options);
  cairo_font_options_destroy(options);
  cairo_set_line_join(s.context, CAIRO_LINE_JOIN_ROUND);
  fill({0, 0, static_cast<double>(width), static_cast<double>(height)}, {{1, 1, 1}, 1});
}

Canvas::~Canvas() = default;

void Canvas::document_title(const std::string& title) {
  if (format_ == Format::pdf && !title.empty())
    cairo_pdf_surface_set_metadata(state_->surface, CAIRO_PDF_METADATA_TITLE, printable(title).c_str());
}

void Canvas::fill(const Box& box, const Paint& paint) {
  state_->source(paint);
  cairo_rectangle(state_->context, box.x, box.y, box.width, box.height);
  cairo_fill(state_->context);
}

void Canvas::stroke(const Box& box, double line_width, const Paint& paint) {
  state_->source(paint);
  cairo_set_line_width(state_->context, line_width);
  cairo_rectangle(state_->context, box.x, box.y, box.width, box.height);
  cairo_stroke(state_->context);
}

void Canvas::polyline(std::span<const Vec2> points, double line_width, const Paint& paint, bool closed) {
  if (points.size() < 2) return;
  state_->source(paint);
  cairo_set_line_width(state_->context, line_width);
  cairo_set_line_cap(state_->context, CAIRO_LINE_CAP_ROUND);
  state_->path(points);
  if (closed) cairo_close_path(state_->context);
  cairo_stroke(state_->context);
  cairo_set_line_cap(state_->context, CAIRO_LINE_CAP_BUTT);
}

void Canvas::segments(std::span<const Vec2> ends, double line_width, const Paint& paint) {
  if (ends.size() < 2) return;
  state_->source(paint);
  cairo_set_line_width(state_->context, line_width);
  cairo_new_path(state_->context);
  for (std::size_t k = 0; k + 1 < ends.size(); k += 2) {
    cairo_move_to(state_->context, ends[k].x, ends[k].y);
    cairo_line_to(state_->context, ends[k + 1].x, ends[k + 1].y);
  }
  cairo_stroke(state_->context);
}

void Canvas::polygon(std::span<const Vec2> points, const Paint& paint) {
  state_->source(paint);
  state_->path(points);
  cairo_close_path(state_->context);
  cairo_fill(state_->context);
}

void Canvas::disc(Vec2 centre, double radius, const Paint& paint) {
  state_->source(paint);
  cairo_new_path(state_->context);
  cairo_arc(state_->context, centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
  cairo_fill(state_->context);
}

void Canvas::ring(Vec2 centre, double radius, double line_width, const Paint& paint) {
  state_->source(paint);
  cairo_set_line_width(state_->context, line_width);
  cairo_new_path(state_->context);
  cairo_arc(state_->context, centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
  cairo_close_path(state_->context);
  cairo_stroke(state_->context);
}

void Canvas::image(const Box& box, const Image& image, bool smooth) {
  if (image.width <= 0 || image.height <= 0) return;
  cairo_surface_t* pixels = cairo_image_surface_create(CAIRO_FORMAT_ARGB32, image.width, image.height);
  if (cairo_surface_status(pixels) != CAIRO_STATUS_SUCCESS) {
    const cairo_status_t status = cairo_surface_status(pixels);
    cairo_surface_destroy(pixels);
    check(status, width_, height_);
  }
  cairo_surface_flush(pixels);
  unsigned char* data = cairo_image_surface_get_data(pixels);
  const int stride = cairo_image_surface_get_stride(pixels);
  for (int y = 0; y < image.height; ++y)
    std::copy_n(image.pixels.data() + static_cast<std::size_t>(y) * image.width, image.width,
                reinterpret_cast<std::uint32_t*>(data + static_cast<std::size_t>(y) * stride));
  cairo_surface_mark_dirty(pixels);
  cairo_t* c = state_->context;
  cairo_save(c);
  cairo_translate(c, box.x, box.y);
  cairo_scale(c, box.width / image.width, box.height / image.height);
  cairo_set_source_surface(c, pixels, 0, 0);
  cairo_pattern_set_filter(cairo_get_source(c), smooth ? CAIRO_FILTER_GOOD : CAIRO_FILTER_NEAREST);
  cairo_paint(c);
  cairo_restore(c);
  cairo_surface_destroy(pixels);
}

void Canvas::text(Vec2 at, const std::string& raw, const TextStyle& style) {
  const std::string text = printable(raw);
  if (text.empty()) return;
  cairo_t* c = state_->context;
  state_->font(style.size, style.bold);
  cairo_text_extents_t extents;
  cairo_text_extents(c, text.c_str(), &extents);
  const double shift = style.horizontal == Align::start    ? 0
                       : style.horizontal == Align::middle ? -extents.x_advance / 2
                                                           : -extents.x_advance;
  const double drop = style.vertical == Align::start    ? 0
                      : style.vertical == Align::middle ? kCapHeight * style.size / 2
                                                        : kCapHeight * style.size;
  cairo_save(c);
  cairo_translate(c, at.x, at.y);
  cairo_rotate(c, style.angle);
  cairo_new_path(c);
  if (style.halo > 0) {
    cairo_move_to(c, shift, drop);
    cairo_text_path(c, text.c_str());
    cairo_set_source_rgba(c, 1, 1, 1, 0.85);
    cairo_set_line_width(c, 2 * style.halo);
    cairo_stroke(c);
  }
  state_->source(style.paint);
  cairo_move_to(c, shift, drop);
  cairo_show_text(c, text.c_str());
  cairo_restore(c);
  if (style.angle == 0)
    text_boxes_.push_back(
        {at.x + shift + extents.x_bearing, at.y + drop + extents.y_bearing, extents.width, extents.height});
}

double Canvas::text_width(const std::string& text, double size, bool bold) const {
  state_->font(size, bold);
  cairo_text_extents_t extents;
  cairo_text_extents(state_->context, printable(text).c_str(), &extents);
  return extents.x_advance;
}

std::string Canvas::shortened(const std::string& raw, double width, double size, bool bold) const {
  std::string text = printable(raw);
  if (text_width(text, size, bold) <= width) return text;
  // Cut points between characters; the width grows with the length.
  std::vector<std::size_t> cuts;
  for (std::size_t k = 0; k < text.size(); ++k)
    if ((static_cast<unsigned char>(text[k]) & 0xC0) != 0x80) cuts.push_back(k);
  std::size_t low = 0, high = cuts.size();
  while (low + 1 < high) {
    const std::size_t middle = (low + high) / 2;
    (text_width(text.substr(0, cuts[middle]) + "…", size, bold) <= width ? low : high) = middle;
  }
  std::string kept = text.substr(0, cuts.empty() ? 0 : cuts[low]);
  while (!kept.empty() && (kept.back() == ' ' || kept.back() == ',')) kept.pop_back();
  return kept.empty() ? std::string() : kept + "…";
}

std::vector<std::string> Canvas::wrapped(const std::string& raw, double width, double size, int lines) const {
  std::vector<std::string> out;
  std::string rest = printable(raw);
  while (!rest.empty() && lines > 0) {
    if (static_cast<int>(out.size()) + 1 == lines || text_width(rest, size) <= width) {
      out.push_back(shortened(rest, width, size));
      break;
    }
    std::size_t cut = std::string::npos;
    for (std::size_t space = rest.find(' '); space != std::string::npos; space = rest.find(' ', space + 1)) {
      if (text_width(rest.substr(0, space), size) > width) break;
      cut = space;
    }
    if (cut == std::string::npos || cut == 0) {
      out.push_back(shortened(rest, width, size));
      break;
    }
    out.push_back(rest.substr(0, cut));
    rest = rest.substr(cut + 1);
  }
  return out;
}

std::string Canvas::finish() {
  State& s = *state_;
  check(cairo_status(s.context), width_, height_);
  if (format_ == Format::png) {
    cairo_surface_flush(s.surface);
    check(cairo_surface_write_to_png_stream(s.surface, append, &s.bytes), width_, height_);
    return std::move(s.bytes);
  }
  cairo_show_page(s.context);
  cairo_surface_finish(s.surface);
  check(cairo_surface_status(s.surface), width_, height_);
  return format_ == Format::svg ? with_own_numbers(s.bytes) : std::move(s.bytes);
}

std::string printable(const std::string& text) {
  std::string out;
  for (std::size_t k = 0; k < text.size();) {
    const unsigned char lead = static_cast<unsigned char>(text[k]);
    const std::size_t size = lead < 0x80       ? 1
                             : lead >> 5 == 6  ? 2
                             : lead >> 4 == 14 ? 3
                             : lead >> 3 == 30 ? 4
                                               : 0;
    if (size == 1) {
      out += lead < 0x20 || lead == 0x7F ? ' ' : text[k];
      ++k;
      continue;
    }
    bool valid = size > 0 && k + size <= text.size();
    std::uint32_t code = valid ? lead & (0xFFu >> (size + 1)) : 0;
    for (std::size_t j = 1; valid && j < size; ++j) {
      const unsigned char next = static_cast<unsigned char>(text[k + j]);
      valid = (next & 0xC0) == 0x80;
      code = code << 6 | (next & 0x3Fu);
    }
    // Overlong forms, surrogates and what lies beyond Unicode [RFC 3629].
    constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    valid = valid && code >= least[size] && code <= 0x10FFFF && !(code >= 0xD800 && code <= 0xDFFF);
    if (valid)
      out.append(text, k, size);
    else
      out += '?';
    k += valid ? size : 1;
  }
  return out;
}

}  // namespace knotfit::report
