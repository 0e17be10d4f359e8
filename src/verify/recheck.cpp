#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "base/parallel.h"
#include "knotfit/exceptions.h"
#include "knotfit/verify.h"
#include "verify/de_boor.h"
namespace knotfit {

std::vector<double> recheck_errors(const Surface& surface, const ParameterizedPoints& points) {
  validate(points);
  if (surface.empty()) throw InvalidInput("no surface to check: its control net is empty");
  if (surface.dimension() != points.dimension)
    throw InvalidInput(
        fmt::format("a surface of dimension {} cannot be checked against points of dimension {}",
                    surface.dimension(), points.dimension));
  std::vector<double> errors(static_cast<std::size_t>(points.size()));
  const auto dimension = static_cast<std::size_t>(points.dimension);
  parallel_chunks(points.size(), [&](Index, Index begin, Index end) {
    std::vector<double> at(dimension);
    for (Index k = begin; k < end; ++k) {
      verify::de_boor(surface, points.u(k), points.v(k), at);
      bool finite = true;
      for (double x : at) finite = finite && std::isfinite(x);
      errors[k] = finite ? verify::distance(at, {points.value(k), dimension})
                         : std::numeric_limits<double>::quiet_NaN();
    }
  });
  return errors;
}

}  // namespace knotfit
