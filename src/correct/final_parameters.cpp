#include "correct/final_parameters.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "correct/parameter_guard.h"
#include "data/orientation.h"
#include "data/vertex_stars.h"
namespace knotfit::correction {
namespace {

using Faces = std::span<const std::array<std::int32_t, 3>>;

/// Part of the way from `here` to `there`, where the vertex may slide.
void go(Slide slide, const double* here, const double* there, double way, double* uv) {
  for (int d = 0; d < 2; ++d)
    if (slide != (d == 0 ? Slide::along_v : Slide::along_u))
      uv[d] = std::clamp(here[d] + way * (there[d] - here[d]), 0.0, 1.0);
}

/// A neighbour counts as often as it shares a triangle with the vertex.
std::array<double, 2> mean_of_neighbours(Faces faces, const VertexStars& stars, std::span<const double> uv,
                                         std::int32_t k) {
  std::array<double, 2> mean{};
  double count = 0;
  for (const std::int32_t i : stars.of(k))
    for (const std::int32_t j : faces[i])
      if (j != k) {
        count += 1;
        for (int d = 0; d < 2; ++d) mean[d] += uv[2 * j + d];
      }
  return {mean[0] / count, mean[1] / count};
}

/// Whether a triangle lies right in `first` and not in `uv`.
bool turned(const std::array<std::int32_t, 3>& t, const std::vector<double>& first,
            const std::vector<double>& uv) {
  constexpr double least = 1e-14;
  return twice_area(uv, t) <= least && twice_area(first, t) > 0;
}

/// The vertices at most `rings` edges from a triangle.
std::vector<std::int32_t> around(Faces faces, const VertexStars& stars, std::size_t triangle, int rings,
                                 std::vector<char>& met) {
  std::vector<std::int32_t> found(faces[triangle].begin(), faces[triangle].end());
  for (const std::int32_t k : found) met[k] = 1;
  for (std::size_t from = 0, ring = 0; ring < static_cast<std::size_t>(rings); ++ring) {
    const std::size_t to = found.size();
    for (; from < to; ++from)
      for (const std::int32_t i : stars.of(found[from]))
        for (const std::int32_t k : faces[i])
          if (!std::exchange(met[k], 1)) found.push_back(k);
  }
  for (const std::int32_t k : found) met[k] = 0;
  std::sort(found.begin(), found.end());
  return found;
}

/// Vertices around a turned triangle and what each is the mean of.
struct Patch {
  std::vector<std::int32_t> vertices;
  std::vector<std::pair<std::int32_t, double>> weights;  ///< neighbours, those of a vertex add up to 1
  std::vector<std::size_t> end;                          ///< of each vertex's weights
};

/// Adds the weights with which a vertex's place in `first` is the mean of its neighbours': mean value coordinates
/// [Floater03], and along a side of the square those of the two next to it.
void add_weights(Faces faces, const VertexStars& stars, std::span<const Slide> slide,
                 const std::vector<double>& first, std::int32_t k, Patch& patch) {
  const std::size_t begin = patch.weights.size();
  const auto add_along = [&](std::size_t d) {
    for (const std::int32_t i : stars.of(k))
      for (const std::int32_t j : faces[i])
        if (const double apart = std::abs(first[2 * j + d] - first[2 * k + d]);
            apart > 0 && first[2 * j + 1 - d] == first[2 * k + 1 - d])
          patch.weights.push_back({j, 1 / apart});
  };
  if (slide[k] == Slide::along_u) add_along(0);
  if (slide[k] == Slide::along_v) add_along(1);
  if (slide[k] == Slide::free)
    for (const std::int32_t i : stars.of(k)) {
      const auto& t = faces[i];
      const std::size_t n = t[0] == k ? 0 : t[1] == k ? 1 : 2;
      const std::int32_t a = t[(n + 1) % 3], b = t[(n + 2) % 3];
      const double au = first[2 * a] - first[2 * k], av = first[2 * a + 1] - first[2 * k + 1],
                   bu = first[2 * b] - first[2 * k], bv = first[2 * b + 1] - first[2 * k + 1];
      const double la = std::hypot(au, av), lb = std::hypot(bu, bv), turn = au * bv - av * bu;
      if (!(turn > 0)) continue;
      const double half = turn / (la * lb + au * bu + av * bv);  // tangent of half the angle at k
      patch.weights.push_back({a, half / la});
      patch.weights.push_back({b, half / lb});
    }
  double sum = 0;
  for (std::size_t at = begin; at < patch.weights.size(); ++at) sum += patch.weights[at].second;
  for (std::size_t at = begin; at < patch.weights.size(); ++at) patch.weights[at].second /= sum;
  patch.end.push_back(patch.weights.size());
}

constexpr int most_sweeps(int rings) {
  return 20 + 10 * rings;
}

/// Moves the vertices to the means that their weights ask for, by successive over-relaxation. \return false where that
/// diverges
bool relax(const Patch& patch, std::span<const Slide> slide, int rings, std::vector<double>& uv) {
  constexpr double settled = 1e-9, lost = 10, most_relaxation = 1.8;
  const double relaxation = std::min(most_relaxation, 2 / (1 + std::sin(std::numbers::pi / (2 * rings + 2))));
  for (int sweep = 0; sweep < most_sweeps(rings); ++sweep) {
    double largest = 0;
    std::size_t at = 0;
    for (std::size_t n = 0; n < patch.vertices.size(); ++n) {
      if (at == patch.end[n]) continue;
      double mean[2] = {0, 0};
      for (; at < patch.end[n]; ++at)
        for (int d = 0; d < 2; ++d) mean[d] += patch.weights[at].second * uv[2 * patch.weights[at].first + d];
      const std::int32_t k = patch.vertices[n];
      for (int d = 0; d < 2; ++d) {
        if (slide[k] == (d == 0 ? Slide::along_v : Slide::along_u)) continue;
        const double step = relaxation * (mean[d] - uv[2 * k + d]);
        uv[2 * k + d] = std::clamp(uv[2 * k + d] + step, 0.0, 1.0);
        largest = std::max(largest, std::abs(step));
      }
    }
    if (!(largest < lost)) return false;
    if (largest < settled) break;
  }
  return true;
}

/// Lays a patch around each turned triangle anew: as it is in `first`, but for its outline. Tries small patches first, and
/// takes one that leaves fewer triangles turned.
bool lay_anew(Faces faces, const VertexStars& stars, std::span<const Slide> slide,
              const std::vector<double>& first, std::vector<double>& uv) {
  constexpr int most_rings = 64;
  constexpr std::size_t most_moves = 30'000'000;  // half a second
  std::size_t moves = 0, left = 1;
  std::vector<char> met(slide.size(), 0);
  for (int rings = 1; rings <= most_rings && left > 0; rings *= 2) {
    left = 0;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      if (!turned(faces[f], first, uv)) continue;
      ++left;
      Patch patch{around(faces, stars, f, rings, met), {}, {}};
      std::vector<double> kept;
      for (const std::int32_t k : patch.vertices) {
        add_weights(faces, stars, slide, first, k, patch);
        kept.insert(kept.end(), {uv[2 * k], uv[2 * k + 1]});
      }
      const auto bad = [&] {
        int count = 0;
        for (const std::int32_t k : patch.vertices)
          for (const std::int32_t i : stars.of(k)) count += turned(faces[i], first, uv);
        return count;
      };
      const int before = bad();
      if (relax(patch, slide, rings, uv) && bad() < before) {
        left -= !turned(faces[f], first, uv);
      } else {
        for (std::size_t n = 0; n < patch.vertices.size(); ++n)
          std::copy_n(&kept[2 * n], 2, &uv[2 * patch.vertices[n]]);
      }
      moves += static_cast<std::size_t>(most_sweeps(rings)) * patch.vertices.size();
      if (moves > most_moves) return false;
    }
  }
  return left == 0;
}

}  // namespace

bool untangle(Faces faces, std::span<const Slide> slide, const std::vector<double>& first,
              std::vector<double>& uv) {
  constexpr int most_passes = 200;
  constexpr double ways[] = {1, 0.5, 0.25, 1.5};
  const VertexStars stars(faces, static_cast<Index>(slide.size()));
  // The smallest area of a vertex's triangles, by their areas in `first`.
  auto smallest = [&](std::int32_t k) {
    double result = INFINITY;
    for (const std::int32_t i : stars.of(k))
      if (const double unit = twice_area(first, faces[i]); unit > 0)
        result = std::min(result, twice_area(uv, faces[i]) / unit);
    return result;
  };
  for (int pass = 0; pass < most_passes; ++pass) {
    std::vector<std::int32_t> vertices;
    for (const auto& t : faces)
      if (turned(t, first, uv)) {
        vertices.insert(vertices.end(), t.begin(), t.end());
        // A triangle that its own vertices do not turn back pulls at those around them.
        if (pass % 4 == 3)
          for (const std::int32_t k : t)
            for (const std::int32_t i : stars.of(k))
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
        go(slide[k], here, mean.data(), way, &uv[2 * k]);
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
  constexpr int rounds =
      16;  // measured on the face: folded 0.63 % after 4, 0.36 after 8, 0.28 after 16, 0.30 after 32
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

Index approach_feet(Faces faces, const std::vector<Vec3>& position, std::span<const Slide> slide,
                    std::span<const double> feet, std::span<const double> distance, const Surface& surface,
                    std::vector<double>& uv) {
  constexpr int most_sweeps = 60;
  constexpr double far = 3;            // times the distance, or its RMS
  constexpr double least_area = 1e-3;  // of what a triangle had
  constexpr double ways[] = {1, 0.5, 0.25, 0.1};
  const CellPolynomials cells(surface);
  const VertexStars stars(faces, static_cast<Index>(position.size()));
  const auto error = [&](std::size_t k) {
    return length(cells.jet(uv[2 * k], uv[2 * k + 1]).s - position[k]);
  };
  double square = 0;
  Index data = 0;
  for (const double d : distance)
    if (!std::isnan(d)) square += d * d, ++data;
  const double rms = data > 0 ? std::sqrt(square / static_cast<double>(data)) : 0;
  std::vector<std::int32_t> lagging;
  for (std::size_t k = 0; k < position.size(); ++k)
    if (slide[k] != Slide::fixed && !std::isnan(feet[2 * k]) &&
        error(k) > far * std::max(std::abs(distance[k]), rms))
      lagging.push_back(static_cast<std::int32_t>(k));
  std::vector<double> least(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f) least[f] = least_area * twice_area(uv, faces[f]);
  std::vector<char> moved(position.size(), 0);
  for (int sweep = 0; sweep < most_sweeps && !lagging.empty(); ++sweep) {
    bool any = false;
    std::vector<std::int32_t> left;
    for (const std::int32_t k : lagging) {
      const double here[2] = {uv[2 * k], uv[2 * k + 1]}, before = error(static_cast<std::size_t>(k));
      bool there = false;
      for (const double way : ways) {
        go(slide[k], here, &feet[2 * k], way, &uv[2 * k]);
        const auto star = stars.of(k);
        // A triangle that is turned over already sets no limit.
        const bool sound = std::all_of(star.begin(), star.end(), [&](std::int32_t f) {
          return !(least[f] > 0) || twice_area(uv, faces[f]) >= least[f];
        });
        if (sound && error(static_cast<std::size_t>(k)) < before) {
          any = true;
          moved[k] = 1;
          there = way == 1;
          break;
        }
        uv[2 * k] = here[0], uv[2 * k + 1] = here[1];
      }
      if (!there) left.push_back(k);
    }
    lagging = std::move(left);
    if (!any) break;
  }
  return std::count(moved.begin(), moved.end(), 1);
}

}  // namespace knotfit::correction
