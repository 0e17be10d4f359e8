// Every placement method on the same data, and knots placed without a fit.
#include "knotfit/compare.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cmath>

#include "arrays.h"
#include "bind.h"
#include "choices.h"
#include "knotfit/comparison_picture.h"
#include "knotfit/exceptions.h"
#include "run.h"
#include "sources.h"
#include "tool/compare_options.h"
#include "tool/compare_report.h"
#include "tool/options_json.h"
namespace knotfit::python {
namespace {

struct Rows {
  tool::FitInput input;
  std::vector<CompareRow> rows;
  std::string options;
};

/// (rows, exception or None).
py::tuple compare(Source& source, const Texts& texts, const std::optional<Array>& feature, int threads,
                  const py::object& progress) {
  auto rows = std::make_unique<Rows>();
  const tool::Arguments arguments = take_texts(tool::Command::compare, texts);
  CompareOptions options = tool::compare_options(arguments);
  if (feature)
    options.fit.user_features = {
        .size_u = feature->shape(0), .size_v = feature->shape(1), .f = vector_of(*feature)};
  comparison_rows(options);  // what cannot be asked is said before any work
  rows->options = tool::options_to_json(arguments.choices);
  const py::object raised = run({.threads = threads, .progress = progress}, [&](const Control& control) {
    rows->input = input_of(source, arguments.choices, control);
    compare_methods(rows->input.points, options, control,
                    [&](const CompareRow& row) { rows->rows.push_back(row); });
  });
  return py::make_tuple(py::cast(std::move(rows)), raised);
}

SurfaceDocument document(const Rows& r, std::size_t k) {
  const FitResult& result = r.rows.at(k).result;
  return {.surface = result.surface,
          .map = result.map,
          .height_field = result.height_field,
          .options = r.options,
          .result = ""};
}

void save(const Rows& r, const std::string& folder, bool force) {
  const py::gil_scoped_release released;
  tool::CompareFolder files(folder, force);
  for (const CompareRow& row : r.rows) files.add(row, r.input, r.options);
  files.draw(r.input);
}

py::bytes draw_errors(const Rows& r, const std::string& extension, int width, int height) {
  return py::bytes(draw_error_plot(tool::error_series(r.rows), "RMS error against control points",
                                   "RMS error", extension, {.width = width, .height = height}));
}

py::bytes draw_maps(const Rows& r, const std::string& asked, const std::string& extension, int width,
                    int height) {
  std::vector<ComparedSurface> panels;
  for (const CompareRow& row : r.rows)
    if (row.fitted && tool::asked_text(row) == asked)
      panels.push_back(
          {.name = row.method, .remark = "", .surface = &row.result.surface, .errors = row.result.errors});
  if (panels.empty()) throw InvalidInput("asked: no surface of the comparison was asked for as " + asked);
  return py::bytes(draw_error_maps(panels, r.input.points, error_range(panels), "knots and errors, " + asked,
                                   extension, {.width = width, .height = height}));
}

/// (knots along u, along v, notes, exception or None).
py::tuple place(Source& source, const std::string& method, const Texts& texts,
                const std::optional<Array>& feature, int interior_u, int interior_v, int threads) {
  bool usual = false;
  const tool::FitChoices choices = complete_texts(texts, "", usual).choices;
  PlacementOptions options;
  options.interior_u = interior_u;
  options.interior_v = interior_v;
  options.degree_u = choices.degree->first;
  options.degree_v = choices.degree->second;
  options.smoothing = *choices.smoothing;
  options.feature = *choices.feature;
  options.engine = *choices.engine;
  if (choices.evaluations) options.evaluations = *choices.evaluations;
  if (feature)
    options.user_features = {
        .size_u = feature->shape(0), .size_v = feature->shape(1), .f = vector_of(*feature)};
  placement_method(method);
  Placement placed;
  const py::object raised = run({.threads = threads, .progress = py::none()}, [&](const Control& control) {
    const tool::FitInput input = input_of(source, choices, control);
    placed = place_knots(method, input.points, options, control);
  });
  return py::make_tuple(array_of(std::move(placed.knots.u)), array_of(std::move(placed.knots.v)),
                        placed.notes, raised);
}

}  // namespace

void bind_compare(py::module_& m) {
  py::class_<Rows>(m, "Rows", "The rows of a comparison, with the data they are of.")
      .def(
          "json", [](const Rows& r) { return tool::compare_json(r.rows, r.input, false); },
          "As the tool's --json.")
      .def("document", &document, py::arg("row"))
      .def("save", &save, py::arg("folder"), py::arg("force"))
      .def("draw_errors", &draw_errors, py::arg("extension"), py::arg("width"), py::arg("height"))
      .def("draw_maps", &draw_maps, py::arg("asked"), py::arg("extension"), py::arg("width"),
           py::arg("height"));
  m.def("compare", &compare, py::arg("source"), py::arg("texts"), py::arg("feature"), py::arg("threads"),
        py::arg("progress"));
  m.def("place_knots", &place, py::arg("source"), py::arg("method"), py::arg("texts"), py::arg("feature"),
        py::arg("interior_u"), py::arg("interior_v"), py::arg("threads"));
}

}  // namespace knotfit::python
