#include <fmt/format.h>

#include <cmath>

#include "base/parallel.h"
#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "knotfit/picture.h"
#include "report/vectors.h"
namespace knotfit {

using report::Vec3;

std::vector<double> signed_errors(const Surface& surface, const ParameterizedPoints& points) {
  const int dimension = surface.dimension();
  if (surface.empty()) throw InvalidInput("errors need a surface, and this one is empty");
  if (points.dimension != dimension)
    throw InvalidInput(
        fmt::format("points of dimension {} cannot be measured against a surface of dimension {}",
                    points.dimension, dimension));
  const Index n = points.size();
  if (points.values.size() != static_cast<std::size_t>(n * dimension))
    throw InvalidInput(
        fmt::format("{} values for {} points of dimension {}", points.values.size(), n, dimension));
  const std::vector<double> value = evaluate(surface, points.uv);
  std::vector<double> errors(static_cast<std::size_t>(n));
  if (dimension == 1) {
    for (Index k = 0; k < n; ++k) errors[k] = value[k] - points.values[k];
    return errors;
  }
  std::vector<double> du, dv;
  if (dimension >= 3) {
    du = evaluate(surface, points.uv, 1, 0);
    dv = evaluate(surface, points.uv, 0, 1);
  }
  parallel_chunks(n, [&](Index, Index begin, Index end) {
    for (Index k = begin; k < end; ++k) {
      const double *s = value.data() + k * dimension, *p = points.value(k);
      double largest = 0, sum = 0;
      for (int d = 0; d < dimension; ++d) largest = std::max(largest, std::abs(s[d] - p[d]));
      for (int d = 0; d < dimension && largest > 0; ++d) sum += std::pow((s[d] - p[d]) / largest, 2);
      errors[k] = std::isnan(largest) ? NAN : largest * std::sqrt(sum);
      if (dimension < 3) continue;  // no normal, no sign
      auto first = [&](const std::vector<double>& of) {
        return Vec3{of[k * dimension], of[k * dimension + 1], of[k * dimension + 2]};
      };
      const Vec3 normal = cross(unit_or(first(du), {}), unit_or(first(dv), {}));
      if (dot(normal, {s[0] - p[0], s[1] - p[1], s[2] - p[2]}) < 0) errors[k] = -errors[k];
    }
  });
  return errors;
}

}  // namespace knotfit
