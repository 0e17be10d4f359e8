#include "correct/final_parameters.h"

#include "correct/parameter_guard.h"
namespace knotfit::correction {
namespace {

using Faces = std::span<const std::array<std::int32_t, 3>>;

double area(std::span<const double> uv, const std::array<std::int32_t, 3>& t) {
  const double *a = &uv[2 * t[0]], *b = &uv[2 * t[1]], *c = &uv[2 * t[2]];
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// Vertices of triangles that are turned over go to the mean of their neighbours, and more of those around them the
/// longer it takes. \return whether every triangle that lay right in `first` does
bool untangle(Faces faces, std::span<const Slide> slide, const std::vector<double>& first,
              std::vector<double>& uv) {
  constexpr int most_passes = 120, passes_a_ring = 6;
  constexpr double least = 1e-14;
  std::vector<char> marked(slide.size(), 0);
  for (int pass = 0;; ++pass) {
    bool right = true;
    for (const auto& t : faces) {
      if (area(uv, t) > least || !(area(first, t) > 0)) continue;
      right = false;
      for (const std::int32_t k : t) marked[k] = 1;
    }
    if (right || pass == most_passes) return right;
    if (pass % passes_a_ring == passes_a_ring - 1) {
      std::vector<char> wider = marked;
      for (const auto& t : faces)
        if (marked[t[0]] || marked[t[1]] || marked[t[2]])
          for (const std::int32_t k : t) wider[k] = 1;
      marked = std::move(wider);
    }
    std::vector<double> sum(uv.size(), 0.0), count(slide.size(), 0.0);
    for (const auto& t : faces)
      for (int c = 0; c < 3; ++c)
        if (const std::int32_t k = t[c]; marked[k])
          for (const std::int32_t j : {t[(c + 1) % 3], t[(c + 2) % 3]}) {
            count[k] += 1;
            for (int d = 0; d < 2; ++d) sum[2 * k + d] += uv[2 * j + d];
          }
    for (std::size_t k = 0; k < slide.size(); ++k) {
      if (!marked[k] || count[k] == 0) continue;
      if (slide[k] == Slide::free || slide[k] == Slide::along_u) uv[2 * k] = sum[2 * k] / count[k];
      if (slide[k] == Slide::free || slide[k] == Slide::along_v) uv[2 * k + 1] = sum[2 * k + 1] / count[k];
    }
  }
}

}  // namespace

std::vector<double> final_parameters(Faces faces, const std::vector<Vec3>& position,
                                     std::span<const Slide> slide, const std::vector<double>& first,
                                     std::vector<double> corrected, const Surface& surface) {
  constexpr int rounds = 16;  // face: folded 0.63 % after 4, 0.36 % after 8, 0.28 % after 16, 0.30 % after 32
  ParameterGuard guard(faces, static_cast<Index>(position.size()));
  const CellPolynomials cells(surface);
  const FootPointOptions steps{3, cells.u().mean_length(), cells.v().mean_length()};
  std::vector<double> from = corrected;
  if (!untangle(faces, slide, first, from)) from = first;
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
