#include <CLI/CLI.hpp>
#include <algorithm>

#include "command_line_options.h"
#include "knotfit/knot_vector.h"
#include "text_values.h"
namespace knotfit::tool {

void add_fit_curve(CLI::App& app, CurveArguments& curve) {
  FitChoices& c = curve.choices;
  add_input(
      app, "INPUT", curve.input,
      "Ordered points: x,y or x,y,z on each line (airfoils of Selig's or Lednicer's form too), an n x 2 or "
      "n x 3 array, or one row of points");
  const std::string size = "Tolerance and size";
  add(app, "--tol", "X|X%",
      "Largest error allowed: absolute, or in % of the diagonal of the points' bounding box. Default, where "
      "neither a "
      "size nor knots are given: 0.1%",
      size, [&](const std::string& t) { c.tolerance = parse_tolerance(t); });
  CLI::Option* within = add(app, "--within", "P%", "The share of the points that must hold the tolerance",
                            size, [&](const std::string& t) { c.measure = parse_percentile(t); });
  add_flag(app, "--rms", "The root mean square error counts, not the maximum", size, [&] {
    c.measure = MeasureValue{ErrorMeasure::rms, 1};
  })->excludes(within);
  CLI::Option* points =
      add(app, "--control-points", "N", "A fixed size; of a closed curve as many as knots in a period", size,
          [&](const std::string& t) {
            curve.control_points = static_cast<int>(std::min<long long>(parse_count(t, 2), 1 << 30));
          });
  add(app, "--degree", "D", "Degree, 1 to 9; default 3", size, [&](const std::string& t) {
    const long long degree = parse_count(t, 1);
    if (degree > kMaxDegree) refuse(t, "a degree from 1 to 9");
    curve.degree = static_cast<int>(degree);
  });
  add(app, "--max-control-points", "N", "Most control points; default: half of the points", size,
      [&](const std::string& t) { c.max_control_points = parse_count(t, 1); });
  add(app, "--max-fits", "N", "Most linear fits of a search; default 100000", size,
      [&](const std::string& t) { c.max_fits = static_cast<long>(parse_count(t, 1)); });
  add(app, "--time-limit", "S",
      "Seconds after which a search tries no further size: the best so far is taken (status time_limit); "
      "default: none",
      size, [&](const std::string& t) { c.time_limit = parse_positive(t); });
  const std::string knots = "Knots";
  CLI::Option* method =
      add(app, "--knots", "METHOD", "How knots are placed (knotfit methods lists them); default optimal",
          knots, [&](const std::string& t) { c.knots = KnotSource{.method = t, .given = std::nullopt}; });
  add(app, "--knots-t", "A,B,...",
      "Knots given: interior ones, increasing in (0,1); of a closed curve those of a period, its seam at 0 "
      "left out",
      knots, [&](const std::string& t) { curve.knots = parse_knots(t); })
      ->excludes(method)
      ->excludes(points);
  add(app, "--compare", "A,B,...",
      "A table of these methods, or of all, in place of one curve; criterion:MEASURE for a feature measure "
      "(criterion:given: that of --feature-file)",
      knots,
      [&](const std::string& t) {
        for (std::size_t begin = 0; begin <= t.size();) {
          const std::size_t end = std::min(t.find(',', begin), t.size());
          curve.compare.push_back(t.substr(begin, end - begin));
          begin = end + 1;
        }
      })
      ->excludes(method);
  add(app, "--feature", one_of(kFeatures), "Feature measure of methods that have one; default hessian", knots,
      [&](const std::string& t) { c.feature = parse_named(kFeatures, t); });
  add(app, "--feature-file", "FILE",
      "A feature measure of your own, in place of --feature: two columns, t from 0 to 1 (with --function: x) "
      "and the measure, at least 0",
      knots, [&](const std::string& t) { c.feature_file = t; });
  add_evaluations(app, c, knots);
  add(app, "--smoothing", "X", "Relative smoothing floor of the least squares; default 1e-12", knots,
      [&](const std::string& t) { c.smoothing = parse_not_negative(t); });
  const std::string input = "Input";
  add_input_options(app, c.input);
  add(app, "--block", "N",
      "Which of several blocks of points (parted by blank lines, names or counts), from 1", input,
      [&](const std::string& t) { curve.block = static_cast<Index>(parse_count(t, 1)); });
  CLI::Option* closed = add_flag(app, "--closed", "A closed curve: the last point is followed by the first",
                                 input, [&] { curve.closed = true; });
  CLI::Option* function =
      add_flag(app, "--function", "y over x: errors are differences of y, x must increase", input,
               [&] { curve.function = true; });
  function->excludes(closed);
  add(app, "--spacing", one_of(kSpacings), "Parameters of the points; default chord", input,
      [&](const std::string& t) { c.spacing = parse_named(kSpacings, t); })
      ->excludes(function);
  add_flag(app, "--corrected", "Move every parameter to the foot of its point on the curve, and fit again",
           input, [&] { curve.corrected = true; })
      ->excludes(function);
  add_output_options(
      app, curve.output,
      "May repeat; by extension: .json the curve, .csv the points with t and error, .svg .png .pdf a "
      "picture, .step .stp .igs .iges the curve for CAD");
  const std::string cad = "CAD files";
  add_unit(app, c.cad.unit, "The unit of the data, for STEP and IGES outputs; default mm", cad);
  add(app, "--name", "TEXT", "Name of the part; default: the file's name", cad,
      [&](const std::string& t) { c.cad.name = t; });
  add(app, "--step-schema", one_of(kSchemas), "Schema of STEP outputs; default ap242", cad,
      [&](const std::string& t) { c.cad.schema = parse_named(kSchemas, t); });
  add_flag(app, "--json", "One JSON object on standard output in place of the summary", "Output",
           [&] { curve.json = true; });
  add_threads(app, curve.threads);
  add_quiet(app, curve.quiet, "No progress and no summary");
}

}  // namespace knotfit::tool
