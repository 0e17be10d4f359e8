// The picture that is hardest to lay out, and the sizes that it is tried at.
#pragma once
#include <cmath>
#include <utility>
#include <vector>

#include "scenes.h"
namespace knotfit::report {

struct Case {
  Surface surface;
  ParameterizedPoints points;
  PictureInput input;
};

// The most crowded picture: every mark, long texts, large numbers.
inline void fill(Case& c, int dimension) {
  c.surface = dimension == 1 ? scenes::heights(scenes::hills) : scenes::in_space([](double u, double v) {
    return std::vector{u + 0.1 * v, v, 0.6 * u * v + 0.3 * std::sin(6 * u)};
  });
  c.points = scenes::random_points(500, dimension);
  c.points.values.clear();  // errors are made up
  c.points.map = {"longitude", "latitude", 512050, 513150, 5403060, 5404100};
  c.input.surface = &c.surface;
  c.input.points = &c.points;
  for (Index k = 0; k < c.points.size(); ++k)
    c.input.signed_errors.push_back(1e-4 * std::sin(static_cast<double>(k)));
  c.input.tolerance = 3.14159e-5;
  c.input.unit = "metre";
  c.input.title = "a_rather_long_name_of_an_input_file_of_terrain.asc";
  c.input.subtitle =
      "The tolerance was not reached: the largest error is 3.2 times the tolerance; ask for more control "
      "points with --max-control-points, or for a share of the points with --within 99.5%.";
  for (int k = 0; k < 40; ++k) c.input.thin_places.push_back({.u = 0.3 + 0.004 * k, .v = 0.5});
}

inline constexpr std::pair<int, int> kSizes[] = {{1600, 900}, {800, 450},  {640, 480},  {1000, 1000},
                                                 {900, 1400}, {400, 900},  {2400, 600}, {400, 240},
                                                 {200, 200},  {1500, 200}, {200, 1500}, {1200, 675}};

}  // namespace knotfit::report
