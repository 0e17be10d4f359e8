// Surfaces with their map to the user's parameters: values, derivatives, geometry, knots.
#include "knotfit/surface.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "arrays.h"
#include "bind.h"
#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "knotfit/io.h"
#include "tool/places.h"
#include "tool/sampling.h"
#include "tool/surface_file.h"
namespace knotfit::python {
namespace {

using Map = std::tuple<std::string, std::string, double, double, double, double, double, double>;

Map map_of(const SurfaceDocument& d) {
  const ParameterMap& m = d.map;
  return {m.name_u, m.name_v, m.u0, m.u1, m.v0, m.v1, m.shear_u, m.shear_v};
}

SurfaceDocument make(int degree_u, const Array& knots_u, int degree_v, const Array& knots_v, const Array& net,
                     const Map& map, bool height_field, const std::string& options,
                     const std::string& result) {
  SurfaceDocument d;
  d.surface = Surface(KnotVector(degree_u, vector_of(knots_u)), KnotVector(degree_v, vector_of(knots_v)),
                      static_cast<int>(net.shape(2)), vector_of(net));
  if (d.surface.size_u() != net.shape(0) || d.surface.size_v() != net.shape(1))
    throw InvalidInput(
        "control_points: their first two sizes must be those of the knot vectors: knots - degree - 1");
  d.map = {std::get<0>(map), std::get<1>(map), std::get<2>(map), std::get<3>(map),
           std::get<4>(map), std::get<5>(map), std::get<6>(map), std::get<7>(map)};
  d.height_field = height_field;
  d.options = options;
  d.result = result;
  return d;
}

/// Parameters in [0,1] of the user's places; outside the domain they are refused, clamped, or NaN.
std::vector<double> parameters(const SurfaceDocument& d, const Array& a, const Array& b,
                               const std::string& outside) {
  tool::Places places;
  places.a = vector_of(a);
  places.b = vector_of(b);
  places.source = "place ";
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  std::vector<Index> unknown;
  for (Index k = 0; k < places.size(); ++k)
    if (std::isnan(places.a[k]) || std::isnan(places.b[k])) {
      unknown.push_back(k);
      places.a[k] = d.map.u0, places.b[k] = d.map.v0;
    }
  if (outside == "nan") {
    const double eps = 4 * std::numeric_limits<double>::epsilon();
    const auto within = [eps](double x, double first, double last) {
      const double slack = eps * (last - first + std::max(std::abs(first), std::abs(last)));
      return x >= first - slack && x <= last + slack;
    };
    for (Index k = 0; k < places.size(); ++k)
      if (!within(places.a[k], d.map.u0, d.map.u1) || !within(places.b[k], d.map.v0, d.map.v1))
        unknown.push_back(k);
  }
  std::vector<double> uv = tool::parameters_of(places, d.map, outside != "raise");
  for (const Index k : unknown) uv[2 * k] = uv[2 * k + 1] = kNan;
  return uv;
}

/// The last `columns` columns of the tool's table of samples, as rows.
py::array_t<double> sampled(const SurfaceDocument& d, const std::vector<double>& uv,
                            const tool::SampleOptions& options, Index columns) {
  const auto n = static_cast<Index>(uv.size() / 2);
  std::vector<double> rows(static_cast<std::size_t>(n * columns));
  {
    const py::gil_scoped_release released;
    tool::Places places;
    places.a.resize(n), places.b.resize(n);
    const tool::Table table = tool::sample(d, places, uv, options);
    const auto first = static_cast<Index>(table.columns.size()) - columns;
    for (Index c = 0; c < columns; ++c)
      for (Index k = 0; k < n; ++k) rows[k * columns + c] = table.columns[first + c][k];
  }
  return array_of(std::move(rows), {n, columns});
}

py::array_t<double> values(const SurfaceDocument& d, const Array& a, const Array& b, int du, int dv,
                           const std::string& outside) {
  const int dimension = d.surface.dimension();
  std::vector<double> uv, found;
  {
    const py::gil_scoped_release released;
    uv = parameters(d, a, b, outside);
    if (du == 0 && dv == 0) found = evaluate(d.surface, uv);
  }
  const auto n = static_cast<py::ssize_t>(uv.size() / 2);
  if (du == 0 && dv == 0) return array_of(std::move(found), {n, dimension});
  return sampled(d, uv, {.derivatives = {{du, dv}}}, dimension);
}

py::array_t<double> on_grid(const SurfaceDocument& d, const Array& a, const Array& b,
                            const std::string& outside) {
  if (d.map.sheared()) throw InvalidInput("grid: the parameters are sheared; evaluate at places one by one");
  const auto one_axis = [&](const Array& x, bool u) {
    Array other(std::vector<py::ssize_t>{x.size()});
    std::fill_n(other.mutable_data(), x.size(), u ? d.map.v0 : d.map.u0);
    const std::vector<double> uv = u ? parameters(d, x, other, outside) : parameters(d, other, x, outside);
    std::vector<double> t(static_cast<std::size_t>(x.size()));
    for (std::size_t k = 0; k < t.size(); ++k) t[k] = uv[2 * k + (u ? 0 : 1)];
    return t;
  };
  const std::vector<double> u = one_axis(a, true), v = one_axis(b, false);
  std::vector<double> found;
  {
    const py::gil_scoped_release released;
    found = evaluate_grid(d.surface, u, v);
  }
  return array_of(std::move(found), {a.size(), b.size(), d.surface.dimension()});
}

py::array_t<double> geometry(const SurfaceDocument& d, const Array& a, const Array& b, bool normals,
                             const std::string& outside) {
  const std::vector<double> uv = parameters(d, a, b, outside);
  return sampled(d, uv, {.derivatives = {}, .normals = normals, .curvature = !normals}, normals ? 3 : 4);
}

SurfaceDocument with_knots(const SurfaceDocument& d, const Array& u, const Array& v) {
  SurfaceDocument refined = d;
  refined.result.clear();
  const auto sorted = [](const Array& a) {
    std::vector<double> knots = vector_of(a);
    std::sort(knots.begin(), knots.end());
    return knots;
  };
  refined.surface = refine_v(refine_u(d.surface, sorted(u)), sorted(v));
  return refined;
}

}  // namespace

void bind_surface(py::module_& m) {
  py::class_<SurfaceDocument>(m, "Document",
                              "A surface, its map to the user's parameters, and what a fit said of it.")
      .def(py::init(&make), py::arg("degree_u"), py::arg("knots_u"), py::arg("degree_v"), py::arg("knots_v"),
           py::arg("net"), py::arg("map"), py::arg("height_field"), py::arg("options"), py::arg("result"))
      .def_property_readonly(
          "degree",
          [](const SurfaceDocument& d) { return std::pair(d.surface.degree_u(), d.surface.degree_v()); })
      .def_property_readonly("knots_u",
                             [](const SurfaceDocument& d) { return array_of(d.surface.knots_u().knots()); })
      .def_property_readonly("knots_v",
                             [](const SurfaceDocument& d) { return array_of(d.surface.knots_v().knots()); })
      .def_property_readonly(
          "interior_u", [](const SurfaceDocument& d) { return array_of(d.surface.knots_u().interior()); })
      .def_property_readonly(
          "interior_v", [](const SurfaceDocument& d) { return array_of(d.surface.knots_v().interior()); })
      .def_property_readonly("net",
                             [](const SurfaceDocument& d) {
                               const Surface& s = d.surface;
                               return array_of(s.net(), {s.size_u(), s.size_v(), s.dimension()});
                             })
      .def_property_readonly("map", &map_of)
      .def_readonly("height_field", &SurfaceDocument::height_field)
      .def_readonly("options", &SurfaceDocument::options)
      .def_readonly("result", &SurfaceDocument::result)
      .def("json", [](const SurfaceDocument& d) { return to_json(d); })
      .def(
          "same",
          [](const SurfaceDocument& a, const SurfaceDocument& b) {
            return a.surface == b.surface && a.map == b.map && a.height_field == b.height_field;
          },
          py::arg("other"))
      .def("values", &values, py::arg("a"), py::arg("b"), py::arg("du"), py::arg("dv"), py::arg("outside"),
           "(n, d) at places (n,), (n,); a derivative by the user's coordinates.")
      .def("grid", &on_grid, py::arg("a"), py::arg("b"), py::arg("outside"), "(n, m, d) over (n,) x (m,).")
      .def("geometry", &geometry, py::arg("a"), py::arg("b"), py::arg("normals"), py::arg("outside"),
           "(n, 3) unit normals, or (n, 4): mean, Gaussian, k1, k2.")
      .def("with_knots", &with_knots, py::arg("u"), py::arg("v"),
           "The same surface with more knots of [0,1].")
      .def("in_space", [](const SurfaceDocument& d) {
        SurfaceDocument space;
        space.surface = tool::surface_in_space(d, "the surface is neither in space nor a height field");
        return space;
      });
  m.def(
      "surface_from_json", [](const std::string& text) { return surface_from_json(text, "text"); },
      py::arg("text"));
}

}  // namespace knotfit::python
