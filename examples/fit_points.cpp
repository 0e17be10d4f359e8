// Points on a bump, one surface within 0.1 % of their range of heights: the shortest way through the library.
#include <cmath>
#include <cstdio>

#include "knotfit/evaluate.h"
#include "knotfit/fit_surface.h"

int main() {
  knotfit::ParameterizedPoints points;
  points.dimension = 1;
  for (int i = 0; i < 60; ++i)
    for (int j = 0; j < 60; ++j) {
      const double u = i / 59.0, v = j / 59.0;
      points.uv.insert(points.uv.end(), {u, v});
      points.values.push_back(std::exp(-20 * ((u - 0.4) * (u - 0.4) + (v - 0.5) * (v - 0.5))));
    }

  knotfit::FitOptions options;
  options.tolerance = knotfit::ToleranceRequest{.value = 0.1, .relative = true};
  const knotfit::FitResult result = knotfit::fit_surface(points, options);
  std::printf("%s\n", result.message.c_str());
  if (result.status != knotfit::Status::reached) return 3;

  double z = 0;
  knotfit::evaluate(result.surface, 0.4, 0.5, {&z, 1});
  std::printf("height at the top: %.6f (1 in truth)\n", z);
  return 0;
}
