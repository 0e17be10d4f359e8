#include "sampling.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <iterator>

#include "knotfit/evaluate.h"
#include "surface_file.h"
namespace knotfit::tool {
namespace {

// "z_xxy": the component and the coordinates it is differentiated by.
std::string derivative_name(const std::string& component, const ParameterMap& map, IntegerPair order) {
  std::string name = component + "_";
  for (int i = 0; i < order.first; ++i) name += map.name_u;
  for (int i = 0; i < order.second; ++i) name += map.name_v;
  return order.first + order.second == 0 ? component : name;
}

/// d^(p+q) / (ds^p dt^q) of the user's square (s, t) as a sum over the derivatives in (u, v): the entry k is the
/// factor of that with k orders in v. The map is linear, so that the chain rule is a product of polynomials.
std::vector<double> derivative_terms(const ParameterMap& map, IntegerPair order) {
  const double u = 1 / (1 + std::abs(map.shear_u)), v = 1 / (1 + std::abs(map.shear_v));
  std::vector<double> terms{1};
  const auto times = [&](double of_u, double of_v) {
    terms.push_back(0);
    for (std::size_t k = terms.size() - 1; k > 0; --k) terms[k] = of_u * terms[k] + of_v * terms[k - 1];
    terms[0] *= of_u;
  };
  for (int i = 0; i < order.first; ++i) times(u, map.shear_v * v);
  for (int i = 0; i < order.second; ++i) times(map.shear_u * u, v);
  return terms;
}

void add_components(Table& table, const SurfaceDocument& document, const std::vector<double>& uv,
                    IntegerPair order) {
  const ParameterMap& map = document.map;
  const int d = document.surface.dimension();
  const std::vector<std::string> names = component_names(d);
  std::vector<std::vector<double>> columns(d, std::vector<double>(uv.size() / 2, 0.0));
  const double scale = std::pow(map.u1 - map.u0, order.first) * std::pow(map.v1 - map.v0, order.second);
  const std::vector<double> terms = derivative_terms(map, order);
  const int total = order.first + order.second;
  for (int in_v = 0; in_v <= total; ++in_v) {
    if (terms[in_v] == 0) continue;
    const std::vector<double> values = evaluate(document.surface, uv, total - in_v, in_v);
    for (int c = 0; c < d; ++c)
      for (std::size_t k = 0; k < columns[c].size(); ++k)
        columns[c][k] += terms[in_v] * values[k * d + c] / scale;
  }
  for (int c = 0; c < d; ++c) table.add(derivative_name(names[c], map, order), std::move(columns[c]));
}

void add_geometry(Table& table, const SurfaceDocument& document, const std::vector<double>& uv,
                  const SampleOptions& options) {
  const Surface surface =
      surface_in_space(document, "--normals and --curvature need a surface in space or a height field");
  constexpr std::array<const char*, 7> kNames = {"nx", "ny", "nz", "mean_curvature", "gaussian_curvature",
                                                 "k1", "k2"};
  std::array<std::vector<double>, 7> columns;
  for (auto& column : columns) column.resize(uv.size() / 2);
  for (std::size_t k = 0; k < uv.size() / 2; ++k) {
    const LocalGeometry g = local_geometry(surface, uv[2 * k], uv[2 * k + 1]);
    const std::array<double, 7> row = {g.normal[0],          g.normal[1], g.normal[2], g.mean_curvature,
                                       g.gaussian_curvature, g.k1,        g.k2};
    for (std::size_t c = 0; c < row.size(); ++c) columns[c][k] = row[c];
  }
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (c < 3 ? options.normals : options.curvature) table.add(kNames[c], std::move(columns[c]));
}

}  // namespace

std::string to_csv(const Table& table) {
  std::string text = fmt::format("{}\n", fmt::join(table.names, ","));
  const std::size_t rows = table.columns.empty() ? 0 : table.columns.front().size();
  auto out = std::back_inserter(text);
  for (std::size_t k = 0; k < rows; ++k)
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      fmt::format_to(out, "{}{}", table.columns[c][k], c + 1 == table.columns.size() ? '\n' : ',');
  return text;
}

std::vector<std::string> component_names(int dimension) {
  if (dimension == 1) return {"z"};
  if (dimension == 3) return {"x", "y", "z"};
  std::vector<std::string> names;
  for (int c = 1; c <= dimension; ++c) names.push_back(fmt::format("c{}", c));
  return names;
}

Table sample(const SurfaceDocument& document, const Places& places, const std::vector<double>& uv,
             const SampleOptions& options) {
  Table table;
  table.add(document.map.name_u, places.a);
  table.add(document.map.name_v, places.b);
  add_components(table, document, uv, {0, 0});
  for (const IntegerPair order : options.derivatives) add_components(table, document, uv, order);
  if (options.normals || options.curvature) add_geometry(table, document, uv, options);
  return table;
}

}  // namespace knotfit::tool
