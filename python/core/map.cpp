// Parameters without a fit: of a mesh, or of points over a base.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "arrays.h"
#include "bind.h"
#include "choices.h"
#include "run.h"
#include "sources.h"
#include "tool/mesh_input.h"
#include "tool/mesh_outputs.h"
namespace knotfit::python {
namespace {

struct Mapped {
  tool::FitInput input;
  Index rows = 0;
};

/// (mapped, exception or None).
py::tuple parameterize(Source& source, const Texts& texts, int threads, const py::object& progress) {
  auto mapped = std::make_unique<Mapped>();
  bool usual = false;
  const tool::FitChoices choices = complete_texts(texts, "", usual).choices;
  mapped->rows = source.rows;
  const py::object raised = run({.threads = threads, .progress = progress}, [&](const Control& control) {
    mapped->input = input_of(source, choices, control);
  });
  return py::make_tuple(py::cast(std::move(mapped)), raised);
}

py::array_t<double> parameters(const Mapped& m) {
  const ParameterizedPoints& p = m.input.points;
  const Index rows = m.rows > 0 ? m.rows : p.size();
  std::vector<double> out(static_cast<std::size_t>(2 * rows), std::numeric_limits<double>::quiet_NaN());
  for (Index k = 0; k < p.size(); ++k) {
    const Index row = m.rows == 0 || p.source.empty() ? k : p.source[k] - 1;
    if (row < 0 || row >= rows) continue;
    out[2 * row] = p.u(k), out[2 * row + 1] = p.v(k);
  }
  return array_of(std::move(out), {rows, 2});
}

}  // namespace

void bind_map(py::module_& m) {
  py::class_<Mapped>(m, "Mapped", "Data at its parameters.")
      .def_property_readonly("parameters", &parameters, "(rows, 2) in [0,1], NaN where a row was left out.")
      .def(
          "points",
          [](const Mapped& d) {
            const ParameterizedPoints& p = d.input.points;
            return py::make_tuple(array_of(std::vector<double>(p.uv), {p.size(), 2}),
                                  array_of(std::vector<double>(p.values), {p.size(), p.dimension}));
          },
          "(parameters (n, 2) in [0,1], values (n, d)) of what would be fitted.")
      .def(
          "json", [](const Mapped& d) { return d.input.mesh ? tool::mesh_to_json(*d.input.mesh) : "{}"; },
          "As the tool's parameterize --json.")
      .def("cloud_json", [](const Mapped& d) {
        return d.input.mesh && d.input.mesh->cloud ? tool::cloud_to_json(*d.input.mesh) : "{}";
      });
  m.def("parameterize", &parameterize, py::arg("source"), py::arg("texts"), py::arg("threads"),
        py::arg("progress"));
}

}  // namespace knotfit::python
