// Curves: fits, values, files.
#include "knotfit/curve.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <chrono>
#include <cmath>
#include <limits>

#include "arrays.h"
#include "bind.h"
#include "choices.h"
#include "knotfit/curve_io.h"
#include "knotfit/curve_picture.h"
#include "knotfit/exceptions.h"
#include "knotfit/fit_curve.h"
#include "knotfit/parameterize_curve.h"
#include "run.h"
#include "sources.h"
#include "tool/curve_options.h"
#include "tool/curve_report.h"
namespace knotfit::python {
namespace {

using Clock = std::chrono::steady_clock;

struct CurveOutcome {
  CurvePoints points;
  CurveFitResult result;
  tool::Arguments arguments;
  tool::Reading reading;
  double seconds = 0;
  Index rows = 0;

  tool::CurveReport report() const {
    return {
        .result = result, .points = points, .arguments = arguments, .reading = reading, .seconds = seconds};
  }
};

/// (n, d) in order, with weights and the numbers of their rows.
CurvePoints points_of(const Array& values, const std::optional<Array>& t, const std::optional<Array>& weights,
                      const std::vector<Index>& lines, const tool::Arguments& a) {
  const RowSpacing spacing = a.choices.spacing.value_or(RowSpacing::chord);
  const auto dimension = static_cast<int>(values.shape(1));
  CurvePoints points;
  if (t) {
    points.dimension = dimension;
    points.values = vector_of(values);
    points.t = vector_of(*t);
    points.closed = a.closed;
    points.source = lines;
    if (weights) points.weights = vector_of(*weights);
    return points;
  }
  if (dimension != 2 && dimension != 3) {
    if (weights) throw InvalidInput("weights: of points that are not planar or in space they need t too");
    points = parameterize_curve(span_of(values), dimension, spacing, a.closed);
    if (static_cast<Index>(lines.size()) == points.size()) points.source = lines;
    return points;
  }
  PointTable table;
  const Index n = values.shape(0);
  for (Index k = 0; k < n; ++k) {
    table.x.push_back(values.data()[k * dimension]);
    table.y.push_back(values.data()[k * dimension + 1]);
    table.z.push_back(dimension == 3 ? values.data()[k * dimension + 2]
                                     : std::numeric_limits<double>::quiet_NaN());
  }
  if (weights) table.weight = vector_of(*weights);
  table.line = lines;
  return curve_points_of(SourceData{.path = kArrays, .format = kArrays, .content = std::move(table)}, spacing,
                         a.closed, a.function);
}

/// (outcome or None, exception or None).
py::tuple fit(const Array& values, const std::optional<Array>& t, const std::optional<Array>& weights,
              const std::optional<py::array_t<Index, py::array::c_style>>& rows, const Texts& texts,
              const std::optional<Array>& feature, int threads, const py::object& progress) {
  const auto start = Clock::now();
  auto o = std::make_unique<CurveOutcome>();
  o->arguments = take_texts(tool::Command::fit_curve, texts);
  o->arguments.input = kArrays;
  o->rows = values.shape(0);
  std::vector<Index> lines;
  if (rows)
    for (Index k = 0; k < rows->size(); ++k) lines.push_back(rows->data()[k] + 1);
  CurveFitOptions options = tool::curve_options(o->arguments);
  if (feature) options.user_features = {.size_u = feature->size(), .size_v = 1, .f = vector_of(*feature)};
  o->points = points_of(values, t, weights, lines, o->arguments);
  const double limit = o->arguments.choices.time_limit.value_or(0);
  const py::object raised =
      run({.threads = threads, .time_limit = limit, .progress = progress},
          [&](const Control& control) { o->result = fit_curve(o->points, options, control); });
  o->seconds = std::chrono::duration<double>(Clock::now() - start).count();
  if (o->result.curve.control_points().empty()) return py::make_tuple(py::none(), raised);
  return py::make_tuple(py::cast(std::move(o)), raised);
}

CurveDocument make(int degree, const Array& knots, const Array& control_points, bool closed, bool function,
                   double x0, double x1) {
  CurveDocument d;
  d.curve = Curve(KnotVector(degree, vector_of(knots)), static_cast<int>(control_points.shape(1)),
                  vector_of(control_points));
  d.closed = closed, d.function = function, d.x0 = x0, d.x1 = x1;
  return d;
}

/// \param t  in [0,1]; NaN gives NaN
py::array_t<double> values(const CurveDocument& d, const Array& t, int order) {
  const int dimension = d.curve.dimension();
  std::vector<double> out(static_cast<std::size_t>(t.size() * dimension));
  for (Index k = 0; k < t.size(); ++k) {
    const double at = t.data()[k];
    if (std::isnan(at)) {
      for (int c = 0; c < dimension; ++c) out[k * dimension + c] = at;
      continue;
    }
    const std::vector<double> found = evaluate_derivatives(d.curve, at, order);
    for (int c = 0; c < dimension; ++c) out[k * dimension + c] = found[order * dimension + c];
  }
  return array_of(std::move(out), {t.size(), dimension});
}

void save_outcome(const CurveOutcome& o, const std::string& path, bool force, const Texts& texts) {
  tool::Arguments start = o.arguments;
  start.choices.input.given.clear();
  tool::Arguments arguments = take_texts(tool::Command::fit_curve, texts, std::move(start));
  arguments.output = {.paths = {path}, .force = force};
  const std::vector<tool::OutputFile> files = tool::plan_outputs(arguments.output, "");
  tool::check_curve_output(files.front());
  const tool::CurveReport report{.result = o.result,
                                 .points = o.points,
                                 .arguments = arguments,
                                 .reading = o.reading,
                                 .seconds = o.seconds};
  const py::gil_scoped_release released;
  tool::write_curve_output(files.front(), report);
}

void save_document(const CurveDocument& d, const std::string& path, bool force, const Texts& texts) {
  const tool::Arguments arguments = take_texts(tool::Command::fit_curve, texts);
  const tool::OutputFile file = tool::plan_outputs({.paths = {path}, .force = force}, "").front();
  tool::check_curve_output(file);
  CurvePictureInput picture;
  picture.curve = &d.curve;
  picture.x0 = d.x0, picture.x1 = d.x1;
  switch (file.kind) {
    case tool::OutputKind::surface:
      return tool::write_text_file(path, force, to_json(d));
    case tool::OutputKind::picture:
      return tool::write_text_file(path, force, draw_curve_picture(picture, file.extension));
    case tool::OutputKind::cad: {
      CadOptions options;
      options.format = file.extension.starts_with(".ig")
                           ? CadFormat::iges
                           : arguments.choices.cad.schema.value_or(CadFormat{CadFormat::step_ap242});
      options.unit = arguments.choices.cad.unit.value_or(CadUnit::millimetre);
      options.name = arguments.choices.cad.name.value_or("knotfit curve");
      return write_cad_curve(path, curve_in_space(d), options, force);
    }
    default:
      throw InvalidInput(path + ": a .csv has the points of a fit: save the fit");
  }
}

py::bytes draw(const CurveDocument& d, const CurveOutcome* o, const std::string& extension, int width,
               int height) {
  CurvePictureInput p;
  p.curve = &d.curve;
  p.x0 = d.x0, p.x1 = d.x1;
  if (o != nullptr) p.points = o->points.values, p.t = o->result.t, p.errors = o->result.errors;
  return py::bytes(draw_curve_picture(p, extension, {.width = width, .height = height}));
}

}  // namespace

void bind_curve(py::module_& m) {
  py::class_<CurveDocument>(m, "CurveDocument", "A curve, and how it is meant.")
      .def(py::init(&make), py::arg("degree"), py::arg("knots"), py::arg("control_points"), py::arg("closed"),
           py::arg("function"), py::arg("x0"), py::arg("x1"))
      .def_property_readonly("degree", [](const CurveDocument& d) { return d.curve.degree(); })
      .def_property_readonly("knots",
                             [](const CurveDocument& d) { return array_of(d.curve.knots().knots()); })
      .def_property_readonly(
          "control_points",
          [](const CurveDocument& d) {
            return array_of(d.curve.control_points(), {d.curve.size(), d.curve.dimension()});
          })
      .def_readonly("closed", &CurveDocument::closed)
      .def_readonly("function", &CurveDocument::function)
      .def_readonly("x0", &CurveDocument::x0)
      .def_readonly("x1", &CurveDocument::x1)
      .def("json", [](const CurveDocument& d) { return to_json(d); })
      .def("values", &values, py::arg("t"), py::arg("order"), "(n, d), a derivative by t in [0,1].")
      .def(
          "with_knots",
          [](CurveDocument d, const Array& knots) {
            d.curve = refine(d.curve, span_of(knots));
            d.result.clear();
            return d;
          },
          py::arg("knots"))
      .def("save", &save_document, py::arg("path"), py::arg("force"), py::arg("texts"));
  py::class_<CurveOutcome>(m, "CurveOutcome", "What a curve's fit left.")
      .def_property_readonly("document",
                             [](const CurveOutcome& o) { return tool::document_of(o.result, o.points); })
      .def_property_readonly("status",
                             [](const CurveOutcome& o) { return std::string(to_string(o.result.status)); })
      .def_property_readonly(
          "errors", [](const CurveOutcome& o) { return array_of(std::vector<double>(o.result.errors)); })
      .def_property_readonly("t",
                             [](const CurveOutcome& o) { return array_of(std::vector<double>(o.result.t)); })
      .def("report", [](const CurveOutcome& o) { return tool::curve_to_json(o.report()); })
      .def("text", [](const CurveOutcome& o) { return tool::curve_to_text(o.report()); })
      .def("save", &save_outcome, py::arg("path"), py::arg("force"), py::arg("texts"));
  m.def("fit_curve", &fit, py::arg("values"), py::arg("t"), py::arg("weights"), py::arg("rows"),
        py::arg("texts"), py::arg("feature"), py::arg("threads"), py::arg("progress"));
  m.def("draw_curve", &draw, py::arg("document"), py::arg("outcome"), py::arg("extension"), py::arg("width"),
        py::arg("height"));
  m.def(
      "curve_from_json", [](const std::string& text) { return curve_from_json(text, "text"); },
      py::arg("text"));
  m.def("read_curve", &read_curve, py::arg("path"));
}

}  // namespace knotfit::python
