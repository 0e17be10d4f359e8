#include "nearest/curve_feet.h"

#include <fmt/format.h>

#include "knotfit/exceptions.h"
#include "nearest/foot_points.h"
#include "spline/strip_surface.h"
namespace knotfit {
namespace {

constexpr FootPointOptions kSteps{.iterations = 20};

}  // namespace

std::vector<double> curve_feet(const Curve& curve, bool closed, std::span<const double> points,
                               std::span<double> t) {
  const int d = curve.dimension();
  if (d > 3) throw InvalidInput(fmt::format("foot points are of curves in space; this one is in R^{}", d));
  const CellPolynomials surface(strip_surface(curve, 3));
  const std::size_t n = t.size();
  std::vector<Vec3> places(n);
  std::vector<double> uv(2 * n, 0.0);
  for (std::size_t k = 0; k < n; ++k) {
    double c[3] = {0, 0, 0};
    for (int e = 0; e < d; ++e) c[e] = points[k * static_cast<std::size_t>(d) + static_cast<std::size_t>(e)];
    places[k] = at(c);
    uv[2 * k] = t[k];
  }
  const std::vector<Slide> slide(n, Slide::along_u);
  std::vector<double> squared = foot_points(surface, places, slide, kSteps, uv);
  for (std::size_t k = 0; k < n; ++k) t[k] = uv[2 * k];
  if (!closed) return squared;

  // Points that came to the seam go on from its other side.
  const double first = surface.u().first(), last = surface.u().last();
  std::vector<std::size_t> stopped;
  std::vector<Vec3> there;
  std::vector<double> from;
  for (std::size_t k = 0; k < n; ++k)
    if (t[k] <= first || t[k] >= last) {
      stopped.push_back(k);
      there.push_back(places[k]);
      from.insert(from.end(), {t[k] <= first ? last : first, 0.0});
    }
  const std::vector<Slide> held(stopped.size(), Slide::along_u);
  const std::vector<double> others = foot_points(surface, there, held, kSteps, from);
  for (std::size_t k = 0; k < stopped.size(); ++k)
    if (others[k] < squared[stopped[k]]) {
      squared[stopped[k]] = others[k];
      t[stopped[k]] = from[2 * k];
    }
  return squared;
}

}  // namespace knotfit
