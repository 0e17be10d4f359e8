// The parts of lines in space that the surface does not hide.
#pragma once
#include <span>
#include <vector>

#include "report/camera.h"
#include "report/z_buffer.h"
namespace knotfit::report {

/// Where a depth buffer lies on the page.
struct Viewport {
  const Camera& camera;
  const ZBuffer& buffer;
  Vec2 corner;        ///< the buffer's upper left corner on the page
  double pixels = 1;  ///< of the buffer a page unit

  /// Half a per cent of the scene's radius behind the surface is still on it.
  static constexpr double kSlack = 5e-5;
  bool visible(const ScreenPoint& p) const {
    return buffer.visible({(p.x - corner.x) * pixels, (p.y - corner.y) * pixels, p.nearness}, kSlack);
  }
};

/// The visible runs of a polyline, on the page; points that lie on a straight line are left out.
std::vector<std::vector<Vec2>> visible_runs(std::span<const Vec3> line, const Viewport& view);

}  // namespace knotfit::report
