// Triangles of a scene seen in a panel of the page.
#pragma once
#include <span>
#include <vector>

#include "report/canvas.h"
#include "report/hidden_lines.h"
#include "report/z_buffer.h"
namespace knotfit::report {

class PanelView {
 public:
  /// \param camera     moved and zoomed so that `in_view` falls into `inner`
  /// \param panel      what the image covers; \param inner  the part of it that the scene may take
  /// \param in_view    points of the scene; those of the triangles where it is empty
  PanelView(const Canvas& canvas, const Camera& camera, const Box& panel, const Box& inner,
            std::span<const Vec3> position, std::span<const Triangle> triangles,
            std::span<const Vec3> in_view);

  const Camera& camera() const { return camera_; }
  const ZBuffer& buffer() const { return buffer_; }
  /// The positions in pixels of the buffer.
  const std::vector<ScreenPoint>& corners() const { return corners_; }
  int finer() const { return finer_; }             ///< pixels of the buffer a pixel of the image
  double pixels() const { return pixels_; }        ///< of the buffer a page unit
  const Box& image_box() const { return image_; }  ///< where an image of buffer size over finer goes
  Viewport viewport() const { return {camera_, buffer_, {panel_.x, panel_.y}, pixels_}; }
  /// Middle of the corner of the panel that the scene covers least, the lower left first.
  /// \param half  half the size of what is to stand there
  Vec2 emptiest_corner(double half) const;

 private:
  Camera camera_;
  Box panel_, image_;
  int finer_ = 2;
  double pixels_ = 1;
  std::vector<ScreenPoint> corners_;
  ZBuffer buffer_;
};

/// Lines get thinner and fainter where they come close to each other: 0.3 to 1.
double crowding(double panel_size, std::size_t lines);

}  // namespace knotfit::report
