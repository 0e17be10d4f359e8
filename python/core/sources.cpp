#include "sources.h"

#include <fmt/format.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>

#include "arrays.h"
#include "bind.h"
#include "knotfit/exceptions.h"
#include "parameterize/table_checks.h"
#include "tool/applicable_options.h"
#include "tool/welding.h"
namespace knotfit::python {
namespace {

using OptionalArray = std::optional<Array>;
using Rows = std::optional<py::array_t<Index, py::array::c_style>>;

std::vector<double> column(const Array& a, Index stride, Index offset) {
  const double* from = a.data() + offset;
  std::vector<double> values(static_cast<std::size_t>(a.size() / stride));
  for (double& x : values) x = *from, from += stride;
  return values;
}

/// -1: all are finite.
Index first_not_finite(std::span<const double> values) {
  constexpr Index kLanes = 8, kBlock = 512 * kLanes;
  const auto n = static_cast<Index>(values.size());
  for (Index k = 0; k < n; k += kBlock) {
    const Index end = std::min(n, k + kBlock);
    double sums[kLanes] = {};  // 0 * x is 0, or NaN where x is not finite; lanes do not wait for each other
    Index i = k;
    for (; i + kLanes <= end; i += kLanes)
      for (Index lane = 0; lane < kLanes; ++lane) sums[lane] += 0 * values[i + lane];
    for (; i < end; ++i) sums[0] += 0 * values[i];
    double sum = 0;
    for (const double s : sums) sum += s;
    if (sum == 0) continue;
    for (i = k; i < end; ++i)
      if (!std::isfinite(values[i])) return i;
  }
  return -1;
}

/// Numbers of rows in messages, from 1; empty where no row was left out.
std::vector<Index> lines_of(const Rows& rows) {
  if (!rows) return {};
  std::vector<Index> lines(rows->data(), rows->data() + rows->size());
  for (Index& line : lines) ++line;
  return lines;
}

Source table_source(const Array& values, const OptionalArray& uv, const OptionalArray& weights,
                    const OptionalArray& normals, const Rows& rows, Index count) {
  const Index dimension = values.ndim() == 2 ? values.shape(1) : 1;
  PointTable table;
  if (dimension == 3) {
    table.x = column(values, 3, 0);
    table.y = column(values, 3, 1);
  }
  table.z = column(values, dimension, dimension - 1);
  if (uv) table.u = column(*uv, 2, 0), table.v = column(*uv, 2, 1);
  if (weights) table.weight = vector_of(*weights);
  if (normals) {
    table.nx = column(*normals, 3, 0);
    table.ny = column(*normals, 3, 1);
    table.nz = column(*normals, 3, 2);
  }
  table.line = lines_of(rows);
  return {SourceData{.path = kArrays, .format = kArrays, .content = std::move(table)}, count};
}

Source points_source(const Array& values, const Array& uv, const OptionalArray& weights, const Rows& rows,
                     Index count) {
  ParameterizedPoints points;
  points.dimension = values.ndim() == 2 ? static_cast<int>(values.shape(1)) : 1;
  points.values = vector_of(values);
  points.uv = vector_of(uv);
  if (weights) points.weights = vector_of(*weights);
  points.source = lines_of(rows);
  return {std::move(points), count};
}

Source rows_source(const Array& xyz) {
  PointRows rows;
  rows.xyz = vector_of(xyz);
  for (Index r = 0; r <= xyz.shape(0); ++r) rows.row_start.push_back(r * xyz.shape(1));
  return {SourceData{.path = kArrays, .format = kArrays, .content = std::move(rows)},
          static_cast<Index>(xyz.shape(0) * xyz.shape(1))};
}

Source raster_source(const Array& z, double x0, double y0, double dx, double dy) {
  Raster raster;
  raster.rows = z.shape(0);
  raster.columns = z.shape(1);
  raster.x0 = x0, raster.y0 = y0, raster.dx = dx, raster.dy = dy;
  raster.z = vector_of(z);
  return {SourceData{.path = kArrays, .format = kArrays, .content = std::move(raster)},
          static_cast<Index>(z.size())};
}

Source mesh_source(const Array& vertices, const Faces& faces, const OptionalArray& uv) {
  Mesh mesh;
  mesh.vertices = vector_of(vertices);
  mesh.faces.resize(static_cast<std::size_t>(faces.shape(0)));
  for (Index f = 0; f < mesh.face_count(); ++f)
    for (Index c = 0; c < 3; ++c) mesh.faces[f][c] = faces.data()[3 * f + c];
  if (uv) mesh.uv = vector_of(*uv);
  return {SourceData{.path = kArrays, .format = kArrays, .content = std::move(mesh)},
          static_cast<Index>(vertices.shape(0))};
}

/// What parameterize_given() would refuse; all but that has been looked at.
void check_parameters(const ParameterizedPoints& points) {
  std::vector<double> u(static_cast<std::size_t>(points.size())), v(u);
  for (Index k = 0; k < points.size(); ++k) {
    u[k] = points.u(k), v[k] = points.v(k);
    const auto inside = [](double t) { return t >= 0 && t <= 1; };
    if (!inside(u[k]) || !inside(v[k]))
      throw InvalidInput(fmt::format("{}: {} = {} is outside [0,1]; {} maps the range of u and v to [0,1]",
                                     parameterize::point_name(points.source, k), inside(u[k]) ? "v" : "u",
                                     inside(u[k]) ? v[k] : u[k], remedy_text(Remedy::rescale)));
  }
  parameterize::check_plane(u, v, "u", "v", points.source);
}

/// Options that do nothing for points with parameters of their own.
void refuse_idle(const tool::FitChoices& choices) {
  PointTable one;
  one.x = one.y = one.z = one.u = one.v = {0};
  tool::refuse_idle_options(SourceData{.path = kArrays, .format = kArrays, .content = std::move(one)},
                            choices);
}

}  // namespace

tool::FitInput input_of(Source& source, const tool::FitChoices& choices, const Control& control) {
  if (const auto* path = std::get_if<std::string>(&source.content))
    return tool::read_fit_input(*path, choices, control);
  if (auto* points = std::get_if<ParameterizedPoints>(&source.content)) {
    refuse_idle(choices);
    check_parameters(*points);
    return tool::fit_input_of(std::move(*points), kArrays, choices);
  }
  SourceData data = std::move(std::get<SourceData>(source.content));
  tool::refuse_idle_reading(data, kArrays, choices.input);
  const Index welded = tool::weld_input(data, choices.input);
  return tool::fit_input_of(std::move(data), welded, choices, control);
}

void bind_sources(py::module_& m) {
  py::class_<Source>(m, "Source", "Data on its way to one fit.").def_readonly("rows", &Source::rows);
  m.def("table_source", &table_source, py::arg("values"), py::arg("uv"), py::arg("weights"),
        py::arg("normals"), py::arg("rows"), py::arg("count"),
        "Points (n, 3) or (n,), with what columns they have.");
  m.def("points_source", &points_source, py::arg("values"), py::arg("uv"), py::arg("weights"),
        py::arg("rows"), py::arg("count"), "Points (n, d) at their parameters (n, 2).");
  m.def("rows_source", &rows_source, py::arg("xyz"), "Rows of points (rows, columns, 3); NaN is a hole.");
  m.def("raster_source", &raster_source, py::arg("z"), py::arg("x0"), py::arg("y0"), py::arg("dx"),
        py::arg("dy"), "Heights (rows, columns), the first row north; NaN is a hole.");
  m.def("mesh_source", &mesh_source, py::arg("vertices"), py::arg("faces"), py::arg("uv"),
        "Triangles (m, 3) of vertices (n, 3).");
  m.def(
      "file_source",
      [](const std::string& path) {
        return Source{path, 0};
      },
      py::arg("path"), "A file of any format that the tool reads.");
  m.def(
      "first_not_finite",
      [](const Array& a) {
        const py::gil_scoped_release released;
        return first_not_finite(span_of(a));
      },
      py::arg("array"), "Index of the first element, in C order, that is not finite; -1: all are.");
}

}  // namespace knotfit::python
