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

/// Neighbours weigh by the triangles they share with the vertex.
std::array<double, 2> mean_of_neighbours(Faces faces, const Stars& stars, std::span<const double> uv,
                                         std::int32_t k) {
  std::array<double, 2> mean{};
  double count = 0;
  for (const std::size_t i : stars.of(k))
    for (const std::int32_t j : faces[i])
      if (j != k) {
        count += 1;
        for (int d = 0; d < 2; ++d) mean[d] += uv[2 * j + d];
      }
  return {mean[0] / count, mean[1] / count};
}

/// What lies right in `first` and not in `uv`.
bool turned(const std::array<std::int32_t, 3>& t, const std::vector<double>& first,
            const std::vector<double>& uv) {
  constexpr double least = 1e-14;
  return area(uv, t) <= least && area(first, t) > 0;
}

/// The vertices at most `rings` edges from a triangle.
std::vector<std::int32_t> around(Faces faces, const Stars& stars, std::size_t triangle, int rings) {
  std::vector<std::int32_t> found(faces[triangle].begin(), faces[triangle].end());
  for (int ring = 0; ring < rings; ++ring) {
    const std::vector<std::int32_t> inner = found;
    for (const std::int32_t k : inner)
      for (const std::size_t i : stars.of(k)) found.insert(found.end(), faces[i].begin(), faces[i].end());
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
  }
  return found;
}

/// Lays a patch around each turned triangle anew, its vertices at the means of their neighbours [Tutte63]: within an
/// outline that is convex enough none is turned over. Small patches first; one is taken where it leaves fewer turned.
bool lay_anew(Faces faces, const Stars& stars, std::span<const Slide> slide, const std::vector<double>& first,
              std::vector<double>& uv) {
  constexpr int most_rings = 64, sweeps = 400;
  constexpr std::size_t most_moves = 40'000'000;  // two seconds
  std::size_t moves = 0, left = 1;
  for (int rings = 1; rings <= most_rings && left > 0; rings *= 2) {
    left = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (!turned(faces[f], first, uv)) continue;
      ++left;
      const std::vector<std::int32_t> patch = around(faces, stars, f, rings);
      moves += sweeps * patch.size();
      if (moves > most_moves) return false;
      const auto bad = [&] {
        int count = 0;
        for (const std::int32_t k : patch)
          for (const std::size_t i : stars.of(k)) count += turned(faces[i], first, uv);
        return count;
      };
      const int before = bad();
      std::vector<double> kept;
      for (const std::int32_t k : patch) kept.insert(kept.end(), {uv[2 * k], uv[2 * k + 1]});
      for (int sweep = 0; sweep < sweeps; ++sweep)
        for (const std::int32_t k : patch) {
          const std::array<double, 2> mean = mean_of_neighbours(faces, stars, uv, k);
          if (slide[k] == Slide::free || slide[k] == Slide::along_u) uv[2 * k] = mean[0];
          if (slide[k] == Slide::free || slide[k] == Slide::along_v) uv[2 * k + 1] = mean[1];
        }
      if (bad() < before) {
        left -= !turned(faces[f], first, uv);
        continue;
      }
      for (std::size_t n = 0; n < patch.size(); ++n) std::copy_n(&kept[2 * n], 2, &uv[2 * patch[n]]);
    }
  }
  return left == 0;
}

}  // namespace

bool untangle(Faces faces, std::span<const Slide> slide, const std::vector<double>& first,
              std::vector<double>& uv) {
  constexpr int most_passes = 200;
  constexpr double ways[] = {1, 0.5, 0.25, 1.5};
  const Stars stars(faces, slide.size());
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
      if (turned(t, first, uv)) {
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
      const std::array<double, 2> mean = mean_of_neighbours(faces, stars, uv, k);
      const double here[2] = {uv[2 * k], uv[2 * k + 1]};
      double best[2] = {here[0], here[1]}, most = smallest(k);
      for (const double way : ways) {
        if (slide[k] != Slide::along_v) uv[2 * k] = std::clamp(here[0] + way * (mean[0] - here[0]), 0.0, 1.0);
        if (slide[k] != Slide::along_u)
          uv[2 * k + 1] = std::clamp(here[1] + way * (mean[1] - here[1]), 0.0, 1.0);
        if (const double size = smallest(k); size > most) {
          most = size;
          best[0] = uv[2 * k], best[1] = uv[2 * k + 1];
          moved = true;
        }
      }
      uv[2 * k] = best[0], uv[2 * k + 1] = best[1];
    }
    if (!moved && pass % 4 == 3) break;
  }
  return lay_anew(faces, stars, slide, first, uv);
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
