#include "command_line.h"

#include <CLI/CLI.hpp>

#include "command_line_options.h"
#include "help_text.h"
#include "knotfit/exceptions.h"
#include "text_values.h"
namespace knotfit::tool {

// One option of one command, its value given to `take`; what `take` refuses is named by the option.
CLI::Option* add(CLI::App& app, const std::string& name, const std::string& value, const std::string& help,
                 const std::string& group, const std::function<void(const std::string&)>& take) {
  const std::string shown = name.substr(name.rfind(',') + 1);
  return app
      .add_option_function<std::string>(
          name,
          [take, shown](const std::string& text) {
            try {
              take(text);
            } catch (const InvalidInput& e) {
              throw UsageError(shown + ": " + e.what());
            }
          },
          wrap(help, kDescription))
      ->type_name(value)
      ->group(group);
}

// The same where the option may repeat.
CLI::Option* add_repeated(CLI::App& app, const std::string& name, const std::string& value,
                          const std::string& help, const std::string& group,
                          const std::function<void(const std::string&)>& take) {
  const std::string shown = name.substr(name.rfind(',') + 1);
  return app
      .add_option_function<std::vector<std::string>>(
          name,
          [take, shown](const std::vector<std::string>& texts) {
            try {
              for (const std::string& text : texts) take(text);
            } catch (const InvalidInput& e) {
              throw UsageError(shown + ": " + e.what());
            }
          },
          wrap(help, kDescription))
      ->allow_extra_args(false)
      ->type_name(value)
      ->group(group);
}

CLI::Option* add_flag(CLI::App& app, const std::string& name, const std::string& help,
                      const std::string& group, const std::function<void()>& take) {
  return app
      .add_flag_function(
          name, [take](std::int64_t) { take(); }, wrap(help, kDescription))
      ->group(group);
}

CLI::Option* add_input(CLI::App& app, const std::string& name, std::string& path, const std::string& help) {
  return app.add_option(name, path, wrap(help, kDescription))->required()->type_name("");
}

void add_input_options(CLI::App& app, InputOptions& input) {
  const std::string group = "Input";
  add(app, "--input-format", "NAME",
      "Format of the input, by name (knotfit formats lists them); default: "
      "by extension, then content",
      group, [&](const std::string& t) { input.format = t; });
  add(app, "--columns", "x,y,z,u,v,w",
      "What the columns of a text file or array are, in order: the names a header may have; nx, ny, nz are "
      "normals, r, g, b, intensity, time and - are left out",
      group, [&](const std::string& t) { input.columns = parse_columns(t); });
  add(app, "--nodata", "V|nan",
      "What stands for missing data: a number (of z), or nan for every word that does (nan, NA, null, an "
      "empty "
      "cell). Cells become holes; points are left out and counted",
      group, [&](const std::string& t) { input.nodata = parse_nodata(t); });
  add(app, "--skip-lines", "N", "Leave out the first N lines of a text", group,
      [&](const std::string& t) { input.skip_lines = static_cast<Index>(parse_count(t, 1)); });
  add(app, "--classes", "N,M,...", "Only LAS points of these classes, such as 2 for ground; default: all",
      group, [&](const std::string& t) { input.classes = parse_classes(t); });
  add(app, "--returns", "first|last|N,...",
      "Only these returns of LAS pulses, by number, first, or the last of each; default: all", group,
      [&](const std::string& t) { input.returns = parse_returns(t); });
}

void add_force(CLI::App& app, bool& force, const std::string& help) {
  add_flag(app, "--force,--overwrite", help, "Output", [&] { force = true; });
}

void add_quiet(CLI::App& app, bool& quiet, const std::string& help) {
  add_flag(app, "-q,--quiet", help, "Running", [&] { quiet = true; });
}

CLI::Option* add_output_options(CLI::App& app, OutputOptions& output, const std::string& what) {
  const std::string group = "Output";
  CLI::Option* o = add_repeated(app, "-o,--output", "FILE", what, group,
                                [&](const std::string& t) { output.paths.push_back(t); });
  add_force(app, output.force, "Replace output files that exist");
  return o;
}

void add_threads(CLI::App& app, int& threads) {
  add(app, "--threads", "N", "Threads; 0 (default): as many as there are cores. Results do not depend on it",
      "Running", [&](const std::string& t) {
        const long long n = parse_count(t, 0);
        if (n > 4096) refuse(t, "a number of threads up to 4096");
        threads = static_cast<int>(n);
      });
}

void add_cell(CLI::App& app, std::optional<std::pair<double, double>>& cell, const std::string& help) {
  add(app, "--cell", "SIZE", help, "Output", [&](const std::string& t) { cell = parse_cell(t); });
}

void add_tolerance_options(CLI::App& app, FitChoices& c) {
  const std::string group = "Tolerance and size";
  add(app, "--tol", "X|X%",
      "Largest error allowed: absolute, in the data's unit, or in % of the diagonal of "
      "the data's bounding box (height fields: of the range of heights). Default, where neither a size nor "
      "knots are given: 0.1%",
      group, [&](const std::string& t) { c.tolerance = parse_tolerance(t); });
  CLI::Option* within = add(app, "--within", "P%",
                            "The share of the points that must hold the tolerance, such as 99.5%; "
                            "default 100%: the maximum counts",
                            group, [&](const std::string& t) { c.measure = parse_percentile(t); });
  add_flag(app, "--rms", "The root mean square error counts, not the maximum", group, [&] {
    c.measure = MeasureValue{ErrorMeasure::rms, 1};
  })->excludes(within);
  add(app, "--control-points", "NxM",
      "A fixed size, in control points along u and v. With --tol too: the "
      "size stays, the tolerance gives the verdict. \"search\" undoes a stored size",
      group, [&](const std::string& t) {
        c.control_points = t == "search" ? IntegerPair{0, 0} : parse_pair(t, 2);
      });
  add(app, "--degree", "D|DxE|auto",
      "Degree along u and v, 1 to 9; default 3. auto: 3, 4 and 5 are tried, and the fewest control points "
      "win",
      group, [&](const std::string& t) { c.degree = parse_degree(t); });
  add(app, "--shear", "auto|off|A|v:A",
      "Oblique parameters for the oblique features of a height field: u + A v in place of u (v:A: v + A u), "
      "A from -1 "
      "to 1; auto finds A, fits with it and without, and keeps the smaller surface. The parameters change, "
      "and the "
      "corners of the surface lie beyond the data; default off",
      group, [&](const std::string& t) { c.shear = parse_shear(t); });
  add(app, "--max-control-points", "N",
      "Most control points; default: half of the points, for scattered "
      "data at most 50000",
      group, [&](const std::string& t) { c.max_control_points = parse_count(t, 1); });
  add(app, "--max-fits", "N", "Most linear fits of one search; default: by the size of the search", group,
      [&](const std::string& t) { c.max_fits = static_cast<long>(parse_count(t, 1)); });
  add(app, "--time-limit", "S",
      "Seconds after which the best surface so far is taken (status time_limit); "
      "default: none",
      group, [&](const std::string& t) { c.time_limit = parse_positive(t); });
}

void add_evaluations(CLI::App& app, FitChoices& c, const std::string& group) {
  add(app, "--evaluations", "N", "Of the error, in an evolutionary search at one size; default 2000", group,
      [&](const std::string& t) { c.evaluations = static_cast<long>(parse_count(t, 1)); });
}

void add_knot_options(CLI::App& app, FitArguments& fit) {
  const std::string group = "Knots";
  FitChoices& c = fit.choices;
  CLI::Option* method =
      add(app, "--knots", "METHOD",
          "How knots are placed (knotfit methods says more): " + method_names() + "; default optimal", group,
          [&](const std::string& t) { c.knots = KnotSource{.method = t, .given = std::nullopt}; });
  const auto given = [&c]() -> InteriorKnots& {
    if (!c.knots || !c.knots->given) c.knots = KnotSource{.method = "", .given = InteriorKnots{}};
    return *c.knots->given;
  };
  CLI::Option* u = add(app, "--knots-u", "A,B,...",
                       "Interior knots along u, increasing in (0,1); none for "
                       "none. Parameters run over [0,1]",
                       group, [=](const std::string& t) { given().u = parse_knots(t); });
  CLI::Option* v = add(app, "--knots-v", "A,B,...", "The same along v", group,
                       [=](const std::string& t) { given().v = parse_knots(t); });
  CLI::Option* from = add(app, "--knots-from", "SURFACE",
                          "Knots, and unless --degree is given degrees, of a "
                          "surface.json, STEP or IGES file",
                          group, [&](const std::string& t) { fit.knots_from = t; });
  u->needs(v);
  v->needs(u);
  CLI::Option* size = app.get_option("--control-points");
  for (CLI::Option* option : {method, from, size}) option->excludes(u)->excludes(v);
  from->excludes(method)->excludes(size);
  CLI::Option* refine =
      add(app, "--refine", one_of(kRoutes),
          "How a tolerance is reached: sizes searched, knots placed anew at "
          "each (search, default), or knot lines inserted where features or errors are large (insert)",
          group, [&](const std::string& t) { c.refine = parse_named(kRoutes, t); });
  for (CLI::Option* option : {u, v, from, size}) refine->excludes(option);
  add(app, "--effort", one_of(kEfforts),
      "Work of a search with optimal knots, counted in fits: fast (no minimax), balanced (default), best "
      "(every "
      "start, every neighbouring size, insertion as well)",
      group, [&](const std::string& t) { c.effort = parse_named(kEfforts, t); });
  add(app, "--guard", one_of(kSwitch),
      "Hold a search with optimal knots to the data between its points too; default on", group,
      [&](const std::string& t) { c.guard = parse_named(kSwitch, t); });
  add(app, "--feature", one_of(kFeatures),
      "Feature measure of the criterion and of insertion; default hessian", group,
      [&](const std::string& t) { c.feature = parse_named(kFeatures, t); });
  add_feature_file(app, c, group);
  add_evaluations(app, c, group);
  add(app, "--smoothing", "X", "Relative smoothing floor of the least squares; default 1e-9", group,
      [&](const std::string& t) { c.smoothing = parse_not_negative(t); });
}

void add_feature_file(CLI::App& app, FitChoices& c, const std::string& group) {
  add(app, "--feature-file", "FILE",
      "A feature measure of your own, in place of --feature: a grid, or points x,y,z or u,v,z in the data's "
      "parameters, whose z is the measure, at least 0",
      group, [&](const std::string& t) { c.feature_file = t; });
}

void add_data_options(CLI::App& app, FitChoices& c) {
  const std::string group = "Input";
  add_input_options(app, c.input);
  add_flag(app, "--height-field", "Fit z over x, y (always so for rasters)", group,
           [&] { c.height_field = true; });
  add(app, "--spacing", one_of(kSpacings),
      "Parameters of rows and grids of points; default chord (rows of different lengths are then mapped anew "
      "where they are corrected)",
      group, [&](const std::string& t) { c.spacing = parse_named(kSpacings, t); });
  add_flag(app, "--rescale-parameters",
           "Map the range of u and of v to [0,1]; without it a parameter outside "
           "[0,1] is an error",
           group, [&] { c.rescale_parameters = true; });
  add(app, "--duplicates", one_of(kDuplicateRules),
      "What becomes of points with equal parameters: their mean, "
      "the lowest, the highest; default fail: an error where no surface can meet the tolerance at both",
      group, [&](const std::string& t) { c.duplicates = parse_named(kDuplicateRules, t); });
  add(app, "--base", "BASE|FILE|A,B,C,D",
      "What points without parameters are projected to: plane (through their principal axes), cylinder, "
      "graph (no "
      "base: nearest neighbours make a mesh that is mapped), the file of a surface, or four of boundary "
      "curves; "
      "default auto: plane, or graph where they fold over it. Given parameters are left aside",
      group, [&](const std::string& t) {
        parse_base(t);
        c.base = t;
      });
}

void add_weld(CLI::App& app, InputOptions& input) {
  add(app, "--weld", "auto|off|X|X%",
      "Vertices of a mesh within X of each other become one where that joins its faces: X in the data's "
      "unit, or in "
      "% of the diagonal; default auto: 1e-7 of the diagonal, and the last bit of single precision",
      "Meshes", [&](const std::string& t) {
        parse_weld(t);
        input.weld = t;
      });
}

void add_mesh_options(CLI::App& app, FitChoices& c) {
  const std::string group = "Meshes";
  add_weld(app, c.input);
  add_flag(app, "--largest-part", "Keep the part of a mesh with the most area", group,
           [&] { c.largest_part = true; });
  add_flag(app, "--orient",
           "Turn triangles that have their corners in the opposite order to their neighbours", group,
           [&] { c.orient = true; });
  add_flag(app, "--drop-degenerate", "Drop triangles of no area, without opening gaps", group,
           [&] { c.drop_degenerate = true; });
  add(app, "--corners", "RULE|I,J,K,L|PLACES",
      "Corners of the square that a mesh is mapped to: auto (default), sharpest, search; or four vertices of "
      "the "
      "boundary, counter-clockwise, by number as the file counts (OBJ from 1, others from 0) or by place: "
      "\"x,y,z;x,y,z;x,y,z;x,y,z\"",
      group, [&](const std::string& t) {
        parse_corners(t);
        c.corners = t;
      });
  add(app, "--omega", "X", "Weight of the normals in the map's metric, 0 to 10; default: the best of some",
      group, [&](const std::string& t) { c.omega = parse_not_negative(t); });
}

void add_reflections(CLI::App& app, bool& reflections) {
  add_flag(app, "--reflections",
           "Pictures show the surface with reflection lines: where they break or wave, so do its normals",
           "Output", [&] { reflections = true; });
}

void add_samples(CLI::App& app, std::optional<int>& samples) {
  add(app, "--samples", "N", "Samples a knot span of .obj, .ply and .vts outputs; default 4", "Output",
      [&](const std::string& t) {
        const long long n = parse_count(t, 1);
        if (n > 10000) refuse(t, "a number of samples up to 10000");
        samples = static_cast<int>(n);
      });
}

void add_unit(CLI::App& app, std::optional<CadUnit>& unit, const std::string& help,
              const std::string& group) {
  add(app, "--unit", one_of(kUnits), help, group,
      [&](const std::string& t) { unit = parse_named(kUnits, t); });
}

void add_face(CLI::App& app, std::optional<int>& face) {
  add(app, "--face", "N", "Which surface of a STEP or IGES file that holds several, from 1", "Input",
      [&](const std::string& t) {
        face = static_cast<int>(std::min<long long>(parse_count(t, 1), 1 << 30));
      });
}

// Where a surface is read.
void add_surface_options(CLI::App& app, SurfaceChoices& source) {
  add_unit(app, source.unit, "The unit that a STEP or IGES file's surface is wanted in; default mm", "Input");
  add_face(app, source.face);
}

// Where CAD files are written.
void add_cad_options(CLI::App& app, CadChoices& cad, const std::string& unit) {
  const std::string group = "CAD files";
  add_unit(app, cad.unit, unit, group);
  add(app, "--name", "TEXT", "Name of the part; default: the file's name", group,
      [&](const std::string& t) { cad.name = t; });
  add(app, "--step-schema", one_of(kSchemas), "Schema of STEP outputs; default ap242", group,
      [&](const std::string& t) { cad.schema = parse_named(kSchemas, t); });
  add_flag(app, "--cad-safe",
           "Faces that every CAD system digests: degree 3, C1, at most 250 control points a direction, no "
           "knots nearer than 1e-7 of the domain; one surface may become several faces",
           group, [&] { cad.safe = true; });
  add(app, "--cad-tol", "X|X%",
      "What --cad-safe may move the surface by where it lowers a degree or merges knots: absolute, or in % "
      "of "
      "the diagonal; default 0.001%",
      group, [&](const std::string& t) { cad.tolerance = parse_tolerance(t); });
}

void add_parameterize(CLI::App& app, ParameterizeArguments& parameterize) {
  add_input(app, "MESH", parameterize.input, "A mesh with one boundary loop: .ply .obj .off .stl");
  add_mesh_options(app, parameterize.choices);
  add_flag(app, "--fill-holes", "Close every boundary loop but the longest", "Meshes",
           [&] { parameterize.choices.fill_holes = true; });
  add(app, "--input-format", "NAME", "Format of the input, by name; default: by extension, then content",
      "Input", [&](const std::string& t) { parameterize.choices.input.format = t; });
  add(app, "--map", one_of(kMaps),
      "How a mesh is mapped: with little stretch (newton, default), or by mean value coordinates alone",
      "Meshes", [&](const std::string& t) { parameterize.newton = parse_named(kMaps, t); });
  add_output_options(app, parameterize.output,
                     "May repeat; by extension: .csv the vertices x,y,z,u,v, .obj the mesh with vt, .ply "
                     "with s, t, .png .svg "
                     ".pdf a picture of the parameter lines on the mesh");
  add(app, "--lines", "N", "Parts between the parameter lines of a picture, 1 to 200; default 20", "Output",
      [&](const std::string& t) {
        const long long n = parse_count(t, 1);
        if (n > 200) refuse(t, "a number of parts from 1 to 200");
        parameterize.lines = static_cast<int>(n);
      });
  add_flag(app, "--json", "One JSON object on standard output: the map's quality", "Output",
           [&] { parameterize.json = true; });
  add_threads(app, parameterize.threads);
  add_quiet(app, parameterize.quiet, "No progress and no summary");
}

void add_fit(CLI::App& app, FitArguments& fit) {
  FitChoices& c = fit.choices;
  add_input(app, "INPUT", fit.input,
            "Points with parameters, a mesh, a raster of heights, rows or grids of points");
  add_tolerance_options(app, c);
  add_knot_options(app, fit);
  add_data_options(app, c);
  add_mesh_options(app, c);
  add_flag(app, "--new-parameters", "Map a mesh or points anew that have parameters (vt; s, t; u, v)",
           "Meshes", [&] { c.new_parameters = true; });
  add(app, "--correct", "auto|off|N",
      "Parameters corrected together with the control points, in N rounds; the error is then the distance to "
      "the "
      "surface, and a surface that folds over the data does not hold a tolerance. Default auto: 30 rounds "
      "for meshes "
      "and clouds that are mapped and for rows of different lengths (two fifths at each size of a search), "
      "none with "
      "--refine insert or --degree auto",
      "Meshes", [&](const std::string& t) { c.correct = parse_correct(t); });
  add(app, "--fairness", "X",
      "Weight of a correction against ruffles that do not turn back, in times of its own: 0 none, 10 a "
      "fairer surface that is farther from the data; default 1",
      "Meshes", [&](const std::string& t) { c.fairness = parse_not_negative(t); });
  add_output_options(
      app, fit.output,
      "May repeat; by extension: .json the surface, .csv the residuals, .asc or .grd the fitted "
      "heights, .png .svg .pdf a picture, .obj .ply .vts the surface in triangles or as a grid, with errors, "
      ".step .stp .igs .iges the surface for CAD");
  add_samples(app, c.samples);
  add_reflections(app, fit.reflections);
  add_cad_options(app, c.cad, "The unit of the data, for STEP and IGES outputs; default mm");
  const std::string output = "Output";
  add_cell(app, c.cell, "Cell size of an .asc output, or two as 30x25; default: the input raster's own grid");
  add_flag(app, "--fill-holes",
           "Heights of the surface where the input has no data; of a mesh or a cloud: close its openings, "
           "every boundary "
           "loop but the longest, before it is mapped",
           output, [&] { c.fill_holes = true; });
  add_flag(app, "--json", "One JSON object on standard output in place of the summary", output,
           [&] { fit.json = true; });
  const std::string running = "Running";
  add(app, "--between", one_of(kSwitch), "Measure the surface between the points too; default on", running,
      [&](const std::string& t) { c.between = parse_named(kSwitch, t); });
  add_threads(app, fit.threads);
  add_quiet(app, fit.quiet, "No progress and no summary; errors and --json are still printed");
  const std::string repeat = "Repeating a fit";
  add(app, "--options", "FILE",
      "Repeat the options stored in a surface.json (or in the output of --json); "
      "the command line wins",
      repeat, [&](const std::string& t) { fit.options_from = t; });
  add_flag(app, "--no-height-field", "Undo a stored --height-field", repeat, [&] {
    c.height_field = false;
  })->excludes(app.get_option("--height-field"));
  add_flag(app, "--no-rescale-parameters", "Undo a stored --rescale-parameters", repeat, [&] {
    c.rescale_parameters = false;
  })->excludes(app.get_option("--rescale-parameters"));
  add_flag(app, "--no-fill-holes", "Undo a stored --fill-holes", repeat, [&] {
    c.fill_holes = false;
  })->excludes(app.get_option("--fill-holes"));
  const std::pair<const char*, std::optional<bool>*> undone[] = {{"largest-part", &c.largest_part},
                                                                 {"orient", &c.orient},
                                                                 {"drop-degenerate", &c.drop_degenerate},
                                                                 {"new-parameters", &c.new_parameters},
                                                                 {"cad-safe", &c.cad.safe}};
  for (const auto& [name, flag] : undone) {
    const std::string option = std::string("--") + name;
    add_flag(app, std::string("--no-") + name, "Undo a stored " + option, repeat, [flag = flag] {
      *flag = false;
    })->excludes(app.get_option(option));
  }
}

void add_eval(CLI::App& app, EvalArguments& eval) {
  add_input(app, "SURFACE", eval.surface, "A surface.json, or a STEP or IGES file");
  add_surface_options(app, eval.source);
  const std::string where = "Where";
  CLI::Option* at = add_repeated(app, "--at", "A,B",
                                 "Parameters u,v, or x,y for a height field, in the coordinates of the "
                                 "data that was fitted; may repeat",
                                 where, [&](const std::string& t) { eval.at.push_back(parse_position(t)); });
  CLI::Option* points = add(app, "--points", "FILE",
                            "Every point of a file: columns u,v, or x,y (or a raster) for a height field. "
                            "Where it has values too, the differences: check points never used in the fit",
                            where, [&](const std::string& t) { eval.points = t; });
  CLI::Option* grid = add(app, "--grid", "NxM", "N x M places over the whole domain, borders included", where,
                          [&](const std::string& t) { eval.grid = parse_pair(t, 2); });
  at->excludes(points)->excludes(grid);
  points->excludes(grid);
  add_flag(app, "--clamp", "Move places outside the domain to its border; without it they are an error",
           where, [&] { eval.clamp = true; });
  const std::string what = "What";
  CLI::Option* all =
      add(app, "--derivatives", "N", "All derivatives up to this order, by the user's coordinates", what,
          [&](const std::string& t) {
            const long long n = parse_count(t, 0);
            if (n > 20) refuse(t, "an order of 0 to 20");
            eval.derivatives_up_to = static_cast<int>(n);
          });
  add_repeated(app, "--derivative", "A,B", "The derivative of order A along u and B along v; may repeat",
               what, [&](const std::string& t) { eval.derivatives.push_back(parse_orders(t)); })
      ->excludes(all);
  add_flag(app, "--normals", "Unit normals (height fields: of the surface in space)", what,
           [&] { eval.normals = true; });
  add_flag(app, "--curvature", "Mean, Gaussian and principal curvatures", what,
           [&] { eval.curvature = true; });
  add_input_options(app, eval.input);
  add_output_options(app, eval.output, "A .csv file in place of standard output");
  add_flag(app, "--json", "One JSON object on standard output: columns, rows, and the differences' summary",
           "Output", [&] { eval.json = true; });
  add_threads(app, eval.threads);
}

void add_info(CLI::App& app, InfoArguments& info) {
  add_input(app, "FILE", info.file, "A surface.json, a STEP or IGES file, or a data file");
  add_surface_options(app, info.source);
  add_input_options(app, info.input);
  add_weld(app, info.input);
  add_flag(app, "--json", "One JSON object", "Output", [&] { info.json = true; });
}

void add_convert(CLI::App& app, ConvertArguments& convert) {
  add_input(app, "INPUT", convert.input, "A surface.json, a STEP or IGES file, or a data file");
  add_face(app, convert.face);
  add_input_options(app, convert.read);
  add_weld(app, convert.read);
  add_output_options(
      app, convert.output,
      "May repeat. Of a surface: .json, .csv (values on --grid), .asc or .grd (heights; --cell), "
      ".png .svg .pdf, .obj .ply .vts, .step .stp .igs .iges. Of data: .csv (points), .asc or .grd (points "
      "that lie on a grid), "
      ".obj .ply (meshes)")
      ->required();
  add_cell(app, convert.cell,
           "Cell size of an .asc output, or two as 30x25; default: the grid of the raster "
           "that was fitted");
  add_samples(app, convert.samples);
  add_reflections(app, convert.reflections);
  add_cad_options(app, convert.cad, "The unit of STEP and IGES files, also of the input; default mm");
  add(app, "--grid", "NxM", "Places of a .csv output; default 100x100", "Output",
      [&](const std::string& t) { convert.grid = parse_pair(t, 2); });
}

void add_list(CLI::App& app, ListArguments& list) {
  add_flag(app, "--names", "Names alone, one a line", "Output", [&] { list.names = true; });
  add_flag(app, "--json", "One JSON array", "Output", [&] { list.json = true; });
}

}  // namespace knotfit::tool
