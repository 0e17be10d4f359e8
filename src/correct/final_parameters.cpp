#include "correct/final_parameters.h"

#include <algorithm>
#include <cmath>

#include "correct/parameter_guard.h"
namespace knotfit::correction {
namespace {

using Faces = std::span<const std::array<std::int32_t, 3>>;

double area(std::span<const double> uv, const std::array<std::int32_t, 3>& t) {
  const double *a = &uv[2 * t[0]], *b = &uv[2 * t[1]], *c = &uv[2 * t[2]];
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// The triangles at each vertex.
class Stars {
 public:
  Stars(Faces faces, std::size_t vertices) : begin_(vertices + 1, 0), triangle_(3 * faces.size()) {
    for (const auto& t : faces)
      for (const std::int32_t k : t) ++begin_[static_cast<std::size_t>(k) + 1];
    for (std::size_t k = 0; k < vertices; ++k) begin_[k + 1] += begin_[k];
    std::vector<std::size_t> at(begin_.begin(), begin_.end() - 1);
    for (std::size_t i = 0; i < faces.size(); ++i)
      for (const std::int32_t k : faces[i]) triangle_[at[static_cast<std::size_t>(k)]++] = i;
  }
  std::span<const std::size_t> of(std::int32_t k) const {
    const auto at = static_cast<std::size_t>(k);
    return {triangle_.data() + begin_[at], begin_[at + 1] - begin_[at]};
  }

 private:
  std::vector<std::size_t> begin_, triangle_;
};

}  // namespace

bool untangle(Faces faces, std::span<const Slide> slide, const std::vector<double>& first,
              std::vector<double>& uv) {
  constexpr int most_passes = 200;
  constexpr double least = 1e-14;
  constexpr double ways[] = {1, 0.5, 0.25, 1.5};
  const Stars stars(faces, slide.size());
  auto turned = [&](const std::array<std::int32_t, 3>& t) {
    return area(uv, t) <= least && area(first, t) > 0;
  };
  // The smallest area of a vertex's triangles, those of the map as units.
  auto smallest = [&](std::int32_t k) {
    double result = INFINITY;
    for (const std::size_t i : stars.of(k))
      if (const double unit = area(first, faces[i]); unit > 0)
        result = std::min(result, area(uv, faces[i]) / unit);
    return result;
  };
  for (int pass = 0; pass < most_passes; ++pass) {
    std::vector<std::int32_t> vertices;
    for (const auto& t : faces)
      if (turned(t)) {
        vertices.insert(vertices.end(), t.begin(), t.end());
        // One that cannot be turned back by its own vertices pulls at those around them.
        if (pass % 4 == 3)
          for (const std::int32_t k : t)
            for (const std::size_t i : stars.of(k))
              vertices.insert(vertices.end(), faces[i].begin(), faces[i].end());
      }
    if (vertices.empty()) return true;
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    bool moved = false;
    for (const std::int32_t k : vertices) {
      if (slide[k] == Slide::fixed) continue;
      double mean[2] = {0, 0}, count = 0;
      for (const std::size_t i : stars.of(k))
        for (const std::int32_t j : faces[i])
          if (j != k) {
            count += 1;
            for (int d = 0; d < 2; ++d) mean[d] += uv[2 * j + d];
          }
      const double here[2] = {uv[2 * k], uv[2 * k + 1]};
      double best[2] = {here[0], here[1]}, most = smallest(k);
      for (const double way : ways) {
        if (slide[k] != Slide::along_v)
          uv[2 * k] = std::clamp(here[0] + way * (mean[0] / count - here[0]), 0.0, 1.0);
        if (slide[k] != Slide::along_u)
          uv[2 * k + 1] = std::clamp(here[1] + way * (mean[1] / count - here[1]), 0.0, 1.0);
        if (const double size = smallest(k); size > most) {
          most = size;
          best[0] = uv[2 * k], best[1] = uv[2 * k + 1];
          moved = true;
        }
      }
      uv[2 * k] = best[0], uv[2 * k + 1] = best[1];
    }
    if (!moved && pass % 4 == 3) return false;
  }
  return false;
}

std::vector<double> final_parameters(Faces faces, const std::vector<Vec3>& position,
                                     std::span<const Slide> slide, std::vector<double> from,
                                     std::vector<double> corrected, const Surface& surface) {
  constexpr int rounds = 16;  // face: folded 0.63 % after 4, 0.36 % after 8, 0.28 % after 16, 0.30 % after 32
  ParameterGuard guard(faces, static_cast<Index>(position.size()));
  const CellPolynomials cells(surface);
  const FootPointOptions steps{3, cells.u().mean_length(), cells.v().mean_length()};
  for (int round = 0; round < rounds; ++round) {
    foot_points(cells, position, slide, steps, corrected);
    const Index held = guard.hold(from, corrected);
    if (held == 0) break;
    guard.relax(corrected, slide, 2);
    from = corrected;
  }
  return corrected;
}

}  // namespace knotfit::correction
