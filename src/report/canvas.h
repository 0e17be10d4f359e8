// Drawing in one code for PNG, SVG and PDF. The only place that knows Cairo.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "report/colour_map.h"
#include "report/vectors.h"
namespace knotfit::report {

enum class Format { png, svg, pdf };
/// \throws InvalidInput  not .png, .svg or .pdf
Format picture_format(const std::string& extension);
/// \throws InvalidInput  a width or height outside 200 to 20000
void check_page(int width, int height);

struct Paint {
  Rgb colour;
  double alpha = 1;
};

/// Pixels, 0xAARRGGBB with colours premultiplied by alpha, row after row from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint32_t> pixels;
  Image() = default;
  Image(int w, int h)
      : width(w), height(h), pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
  std::uint32_t& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * width + x]; }
};
std::uint32_t premultiplied(const Rgb& colour, double alpha = 1);

enum class Align { start, middle, end };

struct TextStyle {
  double size = 12;
  bool bold = false;
  Paint paint;
  Align horizontal = Align::start;
  /// start: y is the baseline; middle: the middle of capitals; end: their top.
  Align vertical = Align::start;
  double angle = 0;  ///< clockwise on the page, radians
  double halo = 0;   ///< width of a white outline
};

/// A page of width x height units (pixels of a PNG, points of an SVG or PDF), y down.
class Canvas {
 public:
  /// \throws InvalidInput  no memory for a PNG of this size
  Canvas(Format format, int width, int height);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  int width() const { return width_; }
  int height() const { return height_; }
  Format format() const { return format_; }
  /// Image pixels worth making a unit of the page.
  double resolution() const { return format_ == Format::png ? 1.0 : 1.5; }

  void document_title(const std::string& title);
  void fill(const Box& box, const Paint& paint);
  void stroke(const Box& box, double line_width, const Paint& paint);
  void polyline(std::span<const Vec2> points, double line_width, const Paint& paint, bool closed = false);
  /// Separate segments, points two by two, in one stroke: crossings do not add up.
  void segments(std::span<const Vec2> ends, double line_width, const Paint& paint);
  void polygon(std::span<const Vec2> points, const Paint& paint);
  void disc(Vec2 centre, double radius, const Paint& paint);
  void ring(Vec2 centre, double radius, double line_width, const Paint& paint);
  /// \param smooth  interpolates where pixels do not meet the page's
  void image(const Box& box, const Image& image, bool smooth = true);

  void text(Vec2 at, const std::string& text, const TextStyle& style);
  double text_width(const std::string& text, double size, bool bold = false) const;
  /// The text, cut with an ellipsis where it is wider than `width`.
  std::string shortened(const std::string& text, double width, double size, bool bold = false) const;
  /// The text in at most `lines` lines no wider than `width`, broken at spaces, the last shortened.
  std::vector<std::string> wrapped(const std::string& text, double width, double size, int lines) const;

  /// Boxes of all horizontal texts drawn so far, for checks that none overlap.
  const std::vector<Box>& text_boxes() const { return text_boxes_; }

  /// The file image; nothing can be drawn afterwards. The same drawing gives the same bytes.
  std::string finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
  Format format_;
  int width_, height_;
  std::vector<Box> text_boxes_;
};

/// Valid UTF-8 without control characters: Cairo refuses anything else.
std::string printable(const std::string& text);

}  // namespace knotfit::report
