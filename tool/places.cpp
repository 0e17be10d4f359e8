#include "places.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "input.h"
#include "knotfit/exceptions.h"
#include "places_file.h"
namespace knotfit::tool {
namespace {

Places of_table(PointTable table, const SurfaceDocument& document, const std::string& path) {
  const bool height_field = document.height_field;
  const int dimension = document.surface.dimension();
  Places places;
  places.a = height_field ? table.x : table.u;
  places.b = height_field ? table.y : table.v;
  if (places.a.empty() && table.size() > 0)
    throw InvalidInput(fmt::format(
        "{}: there are no columns {}; name the columns with --columns", path,
        height_field ? "x, y: the surface is a height field" : "u, v: the surface is not a height field"));
  places.line = std::move(table.line);
  if (dimension == 1) {
    places.given_dimension = 1;
    places.given = std::move(table.z);
  } else if (dimension == 3 && !table.x.empty()) {
    places.given_dimension = 3;
    places.given.reserve(3 * table.z.size());
    for (Index k = 0; k < table.size(); ++k)
      places.given.insert(places.given.end(), {table.x[k], table.y[k], table.z[k]});
  }
  return places;
}

Places of_file(const Arguments& arguments, const SurfaceDocument& document) {
  const std::string& path = arguments.points;
  if (auto places = read_places_alone(path, arguments.choices.input, document.height_field))
    return std::move(*places);
  InputOptions options = arguments.choices.input;
  options.every_vertex = true;  // each is a place to look at
  SourceData data = read_input(path, options);
  Places places;
  if (const Raster* raster = std::get_if<Raster>(&data.content)) {
    if (!document.height_field)
      throw InvalidInput(path + ": holds heights over x, y, but the surface is not a height field");
    places = of_table(table_of(*raster), document, path);
  } else if (PointRows* rows = std::get_if<PointRows>(&data.content)) {
    places = of_table(table_of(*rows), document, path);
  } else if (const Mesh* mesh = std::get_if<Mesh>(&data.content)) {
    places = of_table(table_of(*mesh), document, path);
  } else {
    places = of_table(std::move(std::get<PointTable>(data.content)), document, path);
  }
  places.source = path;
  if (places.size() == 0) throw InvalidInput(path + ": holds no places");
  return places;
}

// The place in [0,1], or NaN where it is outside by more than the rounding of the map.
double inside(double value, double parameter, double first, double last, bool clamp) {
  const double eps = std::numeric_limits<double>::epsilon();
  const double slack = 4 * eps * (1 + std::max(std::abs(first), std::abs(last)) / (last - first));
  if (!std::isfinite(value)) return std::numeric_limits<double>::quiet_NaN();
  if (!clamp && (parameter < -slack || parameter > 1 + slack))
    return std::numeric_limits<double>::quiet_NaN();
  return std::clamp(parameter, 0.0, 1.0);
}

}  // namespace

Places grid_places(const ParameterMap& map, IntegerPair counts) {
  Places places;
  places.source = "--grid";
  for (int i = 0; i < counts.first; ++i)
    for (int j = 0; j < counts.second; ++j) {
      // The ends exactly: the far border is not missed by rounding.
      places.a.push_back(i + 1 == counts.first ? map.u1 : map.from_u(i / (counts.first - 1.0)));
      places.b.push_back(j + 1 == counts.second ? map.v1 : map.from_v(j / (counts.second - 1.0)));
    }
  return places;
}

Places find_places(const Arguments& arguments, const SurfaceDocument& document) {
  if (!arguments.points.empty()) return of_file(arguments, document);
  if (arguments.grid) {
    if (static_cast<double>(arguments.grid->first) * arguments.grid->second > 1e8)
      throw InvalidInput("--grid: more than 1e8 places; give fewer");
    return grid_places(document.map, *arguments.grid);
  }
  if (arguments.at.empty()) throw InvalidInput("eval needs places: --at A,B, --points FILE or --grid NxM");
  Places places;
  places.source = "--at";
  for (const auto& [a, b] : arguments.at) {
    places.a.push_back(a);
    places.b.push_back(b);
  }
  return places;
}

std::vector<double> parameters_of(const Places& places, const ParameterMap& map, bool clamp) {
  std::vector<double> uv(2 * places.a.size());
  for (Index k = 0; k < places.size(); ++k) {
    const double s = inside(places.a[k], map.to_u(places.a[k]), map.u0, map.u1, clamp);
    const double t = inside(places.b[k], map.to_v(places.b[k]), map.v0, map.v1, clamp);
    const auto [u, v] = map.shear(s, t);
    uv[2 * k] = std::min(u, 1.0);
    uv[2 * k + 1] = std::min(v, 1.0);
    if (std::isnan(s) || std::isnan(t))
      throw InvalidInput(fmt::format(
          "{}{}: {},{} is outside the domain {} in [{}, {}], {} in [{}, {}]; --clamp moves it to the border",
          places.source, places.line.empty() ? std::string() : fmt::format(":{}", places.line[k]),
          places.a[k], places.b[k], map.name_u, map.u0, map.u1, map.name_v, map.v0, map.v1));
  }
  return uv;
}

}  // namespace knotfit::tool
