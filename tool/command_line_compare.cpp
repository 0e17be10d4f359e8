#include <CLI/CLI.hpp>
#include <algorithm>

#include "command_line_options.h"
#include "text_values.h"
namespace knotfit::tool {
namespace {

// "a,b,c", each given to `take`.
void each_of(const std::string& list, const std::function<void(const std::string&)>& take) {
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    take(list.substr(begin, end - begin));
    begin = end + 1;
  }
}

}  // namespace

void add_compare(CLI::App& app, CompareArguments& compare) {
  FitChoices& c = compare.choices;
  add_input(app, "INPUT", compare.input,
            "Points with parameters, a mesh, a raster of heights, rows or grids of points");
  const std::string what = "What is compared";
  add(app, "--sizes", "NxM,...", "Fixed sizes, in control points along u and v", what,
      [&](const std::string& t) {
        each_of(t, [&](const std::string& size) { compare.sizes.push_back(parse_pair(size, 2)); });
      });
  add(app, "--tolerances", "X|X%,...", "Tolerances as --tol of fit takes them: sizes are searched to each",
      what, [&](const std::string& t) {
        each_of(t, [&](const std::string& one) { compare.tolerances.push_back(parse_tolerance(one)); });
      });
  add(app, "--methods", "A,B,...",
      "Methods by name (knotfit methods lists them), criterion:MEASURE for a feature measure "
      "(criterion:given: that of "
      "--feature-file); default all",
      what,
      [&](const std::string& t) { each_of(t, [&](const std::string& m) { compare.methods.push_back(m); }); });
  CLI::Option* within = add(app, "--within", "P%", "The share of the points that must hold a tolerance", what,
                            [&](const std::string& t) { c.measure = parse_percentile(t); });
  add_flag(app, "--rms", "The root mean square error counts in a tolerance, not the maximum", what, [&] {
    c.measure = MeasureValue{ErrorMeasure::rms, 1};
  })->excludes(within);
  add(app, "--degree", "D|DxE", "Degree along u and v, 1 to 9; default 3", what, [&](const std::string& t) {
    c.degree = parse_pair(t, 1);
    if (c.degree->first > kMaxDegree || c.degree->second > kMaxDegree) refuse(t, "a degree from 1 to 9");
  });
  add_evaluations(app, c, what);
  add(app, "--max-control-points", "N", "Most control points of a search", what,
      [&](const std::string& t) { c.max_control_points = parse_count(t, 1); });
  add(app, "--max-fits", "N", "Most linear fits of one search", what,
      [&](const std::string& t) { c.max_fits = static_cast<long>(parse_count(t, 1)); });
  add(app, "--feature", one_of(kFeatures), "Feature measure of methods that have one; default hessian", what,
      [&](const std::string& t) { c.feature = parse_named(kFeatures, t); });
  add_feature_file(app, c, what);
  add(app, "--smoothing", "X", "Relative smoothing floor of the least squares; default 1e-9", what,
      [&](const std::string& t) { c.smoothing = parse_not_negative(t); });
  add_data_options(app, c);
  add_mesh_options(app, c);
  add_flag(app, "--fill-holes",
           "Close the openings of a cloud, and every boundary loop of a mesh but the longest", "Meshes",
           [&] { c.fill_holes = true; });
  add(app, "-o,--output", "FOLDER",
      "Tables (CSV, JSON), every surface, and pictures (SVG, PNG): error against control points, and each "
      "method's "
      "knot lines over its errors in one colour scale",
      "Output", [&](const std::string& t) { compare.folder = t; });
  add_force(app, compare.force, "Replace the files of a comparison that is there");
  add_flag(app, "--json", "One JSON object on standard output in place of the table", "Output",
           [&] { compare.json = true; });
  add(app, "--between", one_of(kSwitch), "Measure the surfaces between the points too; default on", "Running",
      [&](const std::string& t) { c.between = parse_named(kSwitch, t); });
  add_threads(app, compare.threads);
  add_quiet(app, compare.quiet, "No progress and no table");
}

}  // namespace knotfit::tool
