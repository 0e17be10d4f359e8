#include "report/panel_view.h"

#include <algorithm>
#include <cmath>
#include <limits>
namespace knotfit::report {
namespace {

constexpr double kMostSamples = 24e6;  // depth samples of a picture, whatever its size

// Moves and zooms the camera so that all points fall into the box.
Camera fitted(Camera camera, std::span<const Vec3> points, const Box& box) {
  camera.zoom = 1;
  camera.origin = {};
  double x0 = INFINITY, x1 = -INFINITY, y0 = INFINITY, y1 = -INFINITY;
  for (const Vec3& p : points) {
    const ScreenPoint s = camera.project(p);
    x0 = std::min(x0, s.x);
    x1 = std::max(x1, s.x);
    y0 = std::min(y0, s.y);
    y1 = std::max(y1, s.y);
  }
  const double width = std::max(x1 - x0, 1e-9), height = std::max(y1 - y0, 1e-9);
  camera.zoom = std::min({box.width / width, box.height / height, std::max(box.width, box.height)});
  camera.origin = {box.centre().x - camera.zoom * (x0 + x1) / 2,
                   box.centre().y - camera.zoom * (y0 + y1) / 2};
  return camera;
}

int finer_for(const Box& panel, double resolution) {
  return panel.width * panel.height * resolution * resolution * 4 > kMostSamples ? 1 : 2;
}
double resolution_for(const Box& panel, double wished) {
  const int finer = finer_for(panel, wished);
  return std::min(wished, std::sqrt(kMostSamples / (finer * finer * panel.width * panel.height)));
}
int image_pixels(double length, double resolution) {
  return std::max(1, static_cast<int>(std::ceil(length * resolution)));
}

std::vector<ScreenPoint> project_all(const Camera& camera, std::span<const Vec3> position, const Box& panel,
                                     double pixels) {
  std::vector<ScreenPoint> corners(position.size());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const ScreenPoint p = camera.project(position[k]);
    corners[k] = {(p.x - panel.x) * pixels, (p.y - panel.y) * pixels, p.nearness};
  }
  return corners;
}

}  // namespace

PanelView::PanelView(const Canvas& canvas, const Camera& camera, const Box& panel, const Box& inner,
                     std::span<const Vec3> position, std::span<const Triangle> triangles,
                     std::span<const Vec3> in_view)
    : camera_(fitted(camera, in_view.empty() ? position : in_view, inner)),
      panel_(panel),
      finer_(finer_for(panel, canvas.resolution())),
      pixels_(resolution_for(panel, canvas.resolution()) * finer_),
      corners_(project_all(camera_, position, panel, pixels_)),
      buffer_(image_pixels(panel.width, pixels_ / finer_) * finer_,
              image_pixels(panel.height, pixels_ / finer_) * finer_, corners_, triangles) {
  image_ = {panel.x, panel.y, buffer_.width() / pixels_, buffer_.height() / pixels_};
}

Vec2 PanelView::emptiest_corner(double half) const {
  Vec2 best;
  int least = std::numeric_limits<int>::max();
  for (const Vec2 at :
       {Vec2{panel_.x + half, panel_.bottom() - half}, Vec2{panel_.right() - half, panel_.bottom() - half},
        Vec2{panel_.x + half, panel_.y + half}, Vec2{panel_.right() - half, panel_.y + half}}) {
    int covered = 0;
    for (int i = -8; i <= 8; ++i)
      for (int j = -8; j <= 8; ++j) {
        const int x = static_cast<int>((at.x + i * half / 8 - panel_.x) * pixels_);
        const int y = static_cast<int>((at.y + j * half / 8 - panel_.y) * pixels_);
        const bool inside = x >= 0 && y >= 0 && x < buffer_.width() && y < buffer_.height();
        covered += inside && buffer_.triangle(x, y) >= 0;
      }
    if (covered >= least) continue;
    least = covered;
    best = at;
  }
  return best;
}

double crowding(double panel_size, std::size_t lines) {
  return std::clamp(panel_size / (18.0 * static_cast<double>(std::max<std::size_t>(lines, 1))), 0.3, 1.0);
}

}  // namespace knotfit::report
