// A fit, with everything that its report and its files are made of.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <chrono>
#include <limits>

#include "arrays.h"
#include "bind.h"
#include "choices.h"
#include "knotfit/exceptions.h"
#include "run.h"
#include "sources.h"
#include "tool/applicable_options.h"
#include "tool/fit_run.h"
#include "tool/fit_writer.h"
#include "tool/mesh_outputs.h"
#include "tool/options_json.h"
namespace knotfit::python {
namespace {

using Clock = std::chrono::steady_clock;

struct Outcome {
  tool::FitInput input;
  tool::FitChoices choices;
  tool::FitRun run;
  bool default_tolerance = false;
  double seconds = 0;
  std::string call;
  Index rows = 0;

  tool::FitReport report() const {
    return {.result = run.result,
            .input = input,
            .choices = choices,
            .corrected = run.correction(),
            .default_tolerance = default_tolerance,
            .seconds = seconds,
            .peak_memory_bytes = tool::peak_memory_bytes(),
            .outputs = {},
            .call = call};
  }
};

using Shared = std::shared_ptr<Outcome>;

py::object surface_or_none(const Shared& outcome) {
  return outcome->run.result.surface.empty() ? py::object(py::none()) : py::cast(outcome);
}

/// (outcome or None, exception or None, None); where the work goes on after an exception, (None, it, a call that waits
/// and gives the outcome or None).
py::tuple fit(Source& source, const Texts& texts, const std::string& stored,
              const std::optional<Array>& feature, int threads, const py::object& progress,
              const std::string& call) {
  const auto start = Clock::now();
  auto outcome = std::make_shared<Outcome>();
  outcome->choices = complete_texts(texts, stored, outcome->default_tolerance).choices;
  outcome->call = call;
  outcome->rows = source.rows;
  tool::FitExtras extras;
  if (feature)
    extras.features = {.size_u = feature->shape(0), .size_v = feature->shape(1), .f = vector_of(*feature)};
  const double limit = outcome->choices.time_limit.value_or(0);
  auto data = std::make_shared<Source>(std::move(source));
  Work work({.threads = threads, .time_limit = limit, .progress = progress},
            [outcome, data, extras, start](const Control& control) {
              outcome->input = input_of(*data, outcome->choices, control);
              if (control.stop.stop_requested()) return;
              const Control left = outcome->input.mesh ? time_left(control, start) : control;
              outcome->run = tool::fit_input(outcome->input, outcome->choices, extras, left);
              outcome->seconds = std::chrono::duration<double>(Clock::now() - start).count();
            });
  const py::object raised = work.watch(progress);
  if (work.ended()) {
    if (raised.is_none()) work.wait();  // throws what it threw
    return py::make_tuple(surface_or_none(outcome), raised, py::none());
  }
  return py::make_tuple(py::none(), raised, py::cpp_function([work, outcome]() mutable {
                          const py::object again = work.wait();
                          if (!again.is_none()) {
                            PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(again.ptr())), again.ptr());
                            throw py::error_already_set();
                          }
                          return surface_or_none(outcome);
                        }));
}

SurfaceDocument document(const Outcome& o) {
  return {.surface = o.run.result.surface,
          .map = o.run.result.map,
          .height_field = o.run.result.height_field,
          .options = tool::options_to_json(o.choices),
          .result = tool::stored_result(o.report())};
}

/// A value a row of the caller's array, NaN where the row was left out.
py::array_t<double> by_row(const Outcome& o, const std::vector<double>& values,
                           const ParameterizedPoints& points, Index width) {
  const Index n = points.size();
  const Index rows = o.rows > 0 ? o.rows : n;
  std::vector<double> out(static_cast<std::size_t>(rows * width), std::numeric_limits<double>::quiet_NaN());
  for (Index k = 0; k < n && k * width < static_cast<Index>(values.size()); ++k) {
    const Index row = o.rows == 0 || points.source.empty() ? k : points.source[k] - 1;
    if (row < 0 || row >= rows) continue;
    for (Index c = 0; c < width; ++c) out[row * width + c] = values[k * width + c];
  }
  if (width == 1) return array_of(std::move(out));
  return array_of(std::move(out), {rows, width});
}

py::array_t<double> errors(const Outcome& o) {
  if (o.input.mesh) return by_row(o, o.run.result.errors, o.input.points, 1);
  return by_row(o, tool::errors_of_all(o.run.result, o.input), tool::points_of_all(o.input), 1);
}

py::array_t<double> parameters(const Outcome& o) {
  const ParameterizedPoints points = o.input.mesh ? o.input.points : tool::points_of_all(o.input);
  std::vector<double> places(points.uv.size());
  for (Index k = 0; k < points.size(); ++k) {
    const auto at = o.run.result.map.from_uv(points.u(k), points.v(k));
    places[2 * k] = at[0], places[2 * k + 1] = at[1];
  }
  return by_row(o, places, points, 2);
}

/// The outcome with its output options, as the tool's command line would have given them.
tool::Arguments with_outputs(const Outcome& o, const Texts& texts) {
  tool::Arguments start;
  start.choices = o.choices;
  start.choices.input.given.clear();
  return take_texts(tool::Command::fit, texts, std::move(start));
}

void save(const Outcome& o, const std::string& path, bool force, const Texts& texts) {
  const tool::Arguments arguments = with_outputs(o, texts);
  const std::vector<tool::OutputFile> files =
      tool::plan_outputs({.paths = {path}, .force = force}, o.rows > 0 ? "" : o.input.summary.path);
  tool::refuse_idle_output_options(arguments.choices.input.given, files);
  tool::FitReport report{.result = o.run.result,
                         .input = o.input,
                         .choices = arguments.choices,
                         .corrected = o.run.correction(),
                         .default_tolerance = o.default_tolerance,
                         .outputs = {},
                         .call = o.call};
  const bool raster = tool::asks_for(files, tool::OutputKind::raster);
  const Raster grid = raster ? tool::output_grid(o.input, arguments.choices) : Raster{};
  const std::vector<char> support = tool::output_support(grid, o.input, o.run.result, arguments.choices);
  const py::gil_scoped_release released;
  tool::FitWriter(report, grid, support, force, arguments.reflections).write(files.front());
}

py::bytes draw(const Outcome& o, const std::string& extension, int width, int height, bool reflections) {
  const tool::FitReport report = o.report();
  const Raster grid;
  const std::vector<char> support;
  std::string bytes;
  {
    const py::gil_scoped_release released;
    bytes = tool::FitWriter(report, grid, support, false, reflections)
                .draw(extension, {.width = width, .height = height});
  }
  return py::bytes(bytes);
}

py::list thin_places(const Outcome& o) {
  py::list places;
  for (const ThinPlace& p : o.run.result.between.thin_places) {
    const auto at = o.run.result.map.from_uv(p.u, p.v);
    places.append(py::make_tuple(at[0], at[1], p.error_bar, p.gap));
  }
  return places;
}

}  // namespace

void bind_fit(py::module_& m) {
  py::class_<Outcome, Shared>(m, "Outcome", "What a fit left, for its report and its files.")
      .def_property_readonly("document", &document)
      .def_property_readonly("status",
                             [](const Outcome& o) { return std::string(to_string(o.run.result.status)); })
      .def_property_readonly("errors", &errors, "(rows,), NaN where a row was left out.")
      .def_property_readonly("parameters", &parameters, "(rows, 2), in the user's coordinates; NaN likewise.")
      .def_property_readonly("thin_places", &thin_places, "(a, b, error bar, gap) of each.")
      .def(
          "report", [](const Outcome& o) { return tool::report_to_json(o.report()); },
          "As the tool's --json.")
      .def(
          "text", [](const Outcome& o) { return tool::report_to_text(o.report()); }, "As the tool's summary.")
      .def("save", &save, py::arg("path"), py::arg("force"), py::arg("texts"))
      .def("draw", &draw, py::arg("extension"), py::arg("width"), py::arg("height"), py::arg("reflections"));
  m.def("fit", &fit, py::arg("source"), py::arg("texts"), py::arg("stored"), py::arg("feature"),
        py::arg("threads"), py::arg("progress"), py::arg("call"),
        "(outcome or None, exception or None, None or a call that waits for the outcome): what stopped it, "
        "and the best.");
}

}  // namespace knotfit::python
