#include <CLI/CLI.hpp>

#include "command_line_options.h"
#include "text_values.h"
namespace knotfit::tool {

void add_distance(CLI::App& app, DistanceArguments& distance) {
  add_input(app, "SURFACE", distance.surface, "A surface.json, or a STEP or IGES file");
  add_input(app, "DATA", distance.data, "Points, a mesh, a raster of heights, rows of points");
  add_surface_options(app, distance.source);
  add_input_options(app, distance.input);
  add_weld(app, distance.input);
  const std::string what = "What";
  add(app, "--tol", "X|X%",
      "What the points may be away from the surface: absolute, or in % of the diagonal of their bounding "
      "box. "
      "Says which share of them is, and exits with 3 where not all are",
      what, [&](const std::string& t) { distance.tolerance = parse_tolerance(t); });
  add(app, "--samples", "N",
      "Of the surface, along u and v, from which the distance to a mesh is measured; 0: not measured; "
      "default 700",
      what, [&](const std::string& t) {
        const long long n = parse_count(t, 0);
        if (n > 20000) refuse(t, "a number of samples up to 20000");
        distance.samples = static_cast<int>(n);
      });
  add_output_options(
      app, distance.output,
      "A .csv file: x,y,z of the points, u,v of their closest points, the distance signed by the "
      "surface's normal");
  add_flag(app, "--json", "One JSON object on standard output in place of the summary", "Output",
           [&] { distance.json = true; });
  add_threads(app, distance.threads);
  add_quiet(app, distance.quiet, "No progress and no summary");
}

}  // namespace knotfit::tool
