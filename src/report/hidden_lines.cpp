#include "report/hidden_lines.h"

#include <algorithm>
#include <cmath>
namespace knotfit::report {
namespace {

// From each point on to the farthest one so that all between stay near the chord.
std::vector<Vec2> simplified(const std::vector<Vec2>& run) {
  constexpr double kOff = 0.06;          // page units
  constexpr std::size_t kFarthest = 48;  // points ahead: the search stays short
  std::vector<Vec2> out;
  for (std::size_t k = 0; k < run.size();) {
    out.push_back(run[k]);
    if (k + 1 >= run.size()) break;
    std::size_t end = k + 1;
    for (std::size_t next = k + 2; next < run.size() && next < k + kFarthest; ++next) {
      const Vec2 chord = run[next] - run[k];
      const double l = std::max(length(chord), 1e-12);
      bool straight = true;
      for (std::size_t m = k + 1; m < next && straight; ++m) {
        const Vec2 d = run[m] - run[k];
        straight = std::abs(chord.x * d.y - chord.y * d.x) / l < kOff;
      }
      if (!straight) break;
      end = next;
    }
    k = end;
  }
  return out;
}

}  // namespace

std::vector<std::vector<Vec2>> visible_runs(std::span<const Vec3> line, const Viewport& view) {
  std::vector<std::vector<Vec2>> runs;
  std::vector<Vec2> run;
  auto end_run = [&] {
    if (run.size() > 1) runs.push_back(simplified(run));
    run.clear();
  };
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const ScreenPoint a = view.camera.project(line[k]), b = view.camera.project(line[k + 1]);
    const double pixels = view.pixels * std::hypot(b.x - a.x, b.y - a.y);
    const int steps = std::clamp(static_cast<int>(std::ceil(pixels / 2)), 1, 4000);
    for (int step = k == 0 ? 0 : 1; step <= steps; ++step) {
      const double t = static_cast<double>(step) / steps;
      // Nearness, like the page's coordinates, is linear along the projected segment.
      const ScreenPoint p{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y),
                          a.nearness + t * (b.nearness - a.nearness)};
      if (view.visible(p))
        run.push_back({p.x, p.y});
      else
        end_run();
    }
  }
  end_run();
  return runs;
}

}  // namespace knotfit::report
