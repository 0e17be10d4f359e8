#include <fmt/format.h>

#include <algorithm>

#include "knotfit/exceptions.h"
#include "knotfit/parameterize.h"
#include "knotfit/remedy.h"
#include "parameterize/table_checks.h"
namespace knotfit {
namespace {

using parameterize::point_name;
using parameterize::point_names;

void check_inside(const PointTable& table) {
  std::vector<Index> outside;
  auto inside = [](double t) { return t >= 0 && t <= 1; };
  for (Index k = 0; k < table.size(); ++k)
    if (!inside(table.u[k]) || !inside(table.v[k])) outside.push_back(k);
  if (outside.empty()) return;
  const Index first = outside[0];
  std::string message =
      inside(table.u[first])
          ? fmt::format("{}: v = {} is outside [0,1]", point_name(table.line, first), table.v[first])
          : fmt::format("{}: u = {} is outside [0,1]", point_name(table.line, first), table.u[first]);
  if (outside.size() > 1)
    message += fmt::format(", likewise {}", point_names(table.line, std::span(outside).subspan(1)));
  throw InvalidInput(message + "; " + remedy_text(Remedy::rescale) + " maps the range of u and v to [0,1]");
}

}  // namespace

ParameterizedPoints parameterize_given(const PointTable& table, bool rescale) {
  parameterize::check_table(table);
  if (table.u.empty() && !table.x.empty())
    throw InvalidInput("x, y and z without u, v columns: the points have no parameters; " +
                       remedy_text(Remedy::height_field) + " fits z over (x, y)");
  if (table.u.empty())
    throw InvalidInput("no u, v columns: the points have no parameters; name them with " +
                       remedy_text(Remedy::columns));
  if (!rescale) check_inside(table);
  parameterize::check_plane(table.u, table.v, "u", "v", table.line);

  ParameterizedPoints points;
  if (rescale) {
    const parameterize::Range u = parameterize::range_of(table.u, "u"),
                              v = parameterize::range_of(table.v, "v");
    points.map = {"u", "v", u.low, u.high, v.low, v.high};
  }
  points.dimension = table.x.empty() ? 1 : 3;
  points.weights = table.weight;
  points.source = table.line;
  points.uv.reserve(2 * table.z.size());
  points.values.reserve(static_cast<std::size_t>(points.dimension) * table.z.size());
  for (Index k = 0; k < table.size(); ++k) {
    points.uv.push_back(rescale ? std::clamp(points.map.to_u(table.u[k]), 0.0, 1.0) : table.u[k]);
    points.uv.push_back(rescale ? std::clamp(points.map.to_v(table.v[k]), 0.0, 1.0) : table.v[k]);
    if (points.dimension == 3) points.values.push_back(table.x[k]), points.values.push_back(table.y[k]);
    points.values.push_back(table.z[k]);
  }
  return points;
}

}  // namespace knotfit
