// Options on what is written and said: outputs, CAD files, pictures, numbers of a surface, the run itself.
#include <fmt/format.h>

#include "knotfit/cad.h"
#include "mesh_outputs.h"
#include "option_holders.h"
namespace knotfit::tool {
namespace {

constexpr std::string_view kOutput = "Output", kCad = "CAD files", kRunning = "Running", kWhat = "What",
                           kRepeat = "Repeating a fit";
constexpr Commands kWrites = kFits | kMap | kEval | kDistance | kConvert;

constexpr Acts kOfPictures = {.on_output = OutputKind::picture, .outputs = ".png, .svg or .pdf"};
constexpr Acts kOfCad = {.on_output = OutputKind::cad, .outputs = "STEP or IGES"};

std::string cell_text(const std::pair<double, double>& cell) {
  return fmt::format("{}x{}", cell.first, cell.second);
}

void add_cad_rows(std::vector<OptionRow>& rows) {
  const CadOptions usual;
  const std::string unit(name_of(kUnits, usual.unit));
  const std::string of_data = "The unit of the data, for STEP and IGES outputs; default ";
  rows.push_back(
      {.names = "--unit",
       .value = one_of(kUnits),
       .uses = {{kFit | kCurve, kCad, of_data + unit},
                {kConvert, kCad, "The unit of STEP and IGES files, also of the input; default " + unit}},
       .holds = named(&CadChoices::unit, kUnits),
       .stored = {.form = Form::text, .usual = unit},
       .acts = kOfCad});
  rows.push_back({.names = "--name",
                  .value = "TEXT",
                  .uses = {{kFit | kCurve | kConvert, kCad, "Name of the part; default: the file's name"}},
                  .holds = text(&CadChoices::name),
                  .stored = {.form = Form::words},
                  .acts = kOfCad});
  const std::string schema(name_of(kSchemas, usual.format));
  rows.push_back({.names = "--step-schema",
                  .value = one_of(kSchemas),
                  .uses = {{kFit | kCurve | kConvert, kCad, "Schema of STEP outputs; default " + schema}},
                  .holds = named(&CadChoices::schema, kSchemas),
                  .stored = {.form = Form::text, .usual = schema},
                  .acts = {.on_output = OutputKind::cad, .outputs = "STEP"}});
  rows.push_back(
      {.names = "--cad-safe",
       .uses =
           {{kFit | kConvert, kCad,
             "Faces that every CAD system digests: degree 3, C1, at most 250 control points a direction, no "
             "knots nearer than 1e-7 of the domain; one surface may become several faces"}},
       .holds = on(&CadChoices::safe),
       .stored = {.form = Form::boolean, .usual = "off"},
       .acts = kOfCad});
  rows.push_back(
      {.names = "--cad-tol",
       .value = "X|X%",
       .uses =
           {{kFit | kConvert, kCad,
             "What --cad-safe may move the surface by where it lowers a degree or merges knots: absolute, or "
             "in % of the diagonal; default " +
                 to_text(kDefaultCadTolerance)}},
       .holds =
           kept(&CadChoices::tolerance, parse_tolerance, [](const ToleranceValue& t) { return to_text(t); }),
       .stored = {.form = Form::text},
       .acts = kOfCad});
}

void add_number_rows(std::vector<OptionRow>& rows) {
  rows.push_back(
      {.names = "--samples",
       .value = "N",
       .uses = {{kDistance, kWhat,
                 fmt::format(
                     "Of the surface, along u and v, from which the distance to a mesh is measured; 0: "
                     "not measured; default {}",
                     Arguments{}.surface_samples)}},
       .holds = {[](Arguments& a, const std::string& t) {
         a.surface_samples = count_up_to(t, 0, 20000, "a number of samples up to 20000");
       }},
       .brief = "Samples of the surface, along u and v"});
  rows.push_back({.names = "--derivatives",
                  .value = "N",
                  .uses = {{kEval, kWhat, "All derivatives up to this order, by the user's coordinates"}},
                  .holds = {[](Arguments& a, const std::string& t) {
                    a.derivatives_up_to = count_up_to(t, 0, 20, "an order of 0 to 20");
                  }}});
  rows.push_back(
      {.names = "--derivative",
       .value = "A,B",
       .uses = {{kEval, kWhat, "The derivative of order A along u and B along v; may repeat"}},
       .holds = {[](Arguments& a, const std::string& t) { a.derivatives.push_back(parse_orders(t)); }},
       .repeats = true,
       .excludes = {"--derivatives"}});
  rows.push_back({.names = "--normals",
                  .uses = {{kEval, kWhat, "Unit normals (height fields: of the surface in space)"}},
                  .holds = flag(&Arguments::normals)});
  rows.push_back({.names = "--curvature",
                  .uses = {{kEval, kWhat, "Mean, Gaussian and principal curvatures"}},
                  .holds = flag(&Arguments::curvature)});
}

}  // namespace

void add_output_rows(std::vector<OptionRow>& rows) {
  rows.push_back({.names = "-o,--output",
                  .value = "FILE",
                  .uses = {{kFit, kOutput,
                            "May repeat; by extension: .json the surface, .csv the residuals, .asc or .grd "
                            "the fitted heights, .png "
                            ".svg .pdf a picture, .obj .ply .vts the surface in triangles or as a grid, with "
                            "errors, .step .stp .igs "
                            ".iges the surface for CAD"},
                           {kCurve, kOutput,
                            "May repeat; by extension: .json the curve, .csv the points with t and error, "
                            ".svg .png .pdf a picture, "
                            ".step .stp .igs .iges the curve for CAD"},
                           {kMap, kOutput,
                            "May repeat; by extension: .csv the vertices x,y,z,u,v, .obj the mesh with vt, "
                            ".ply with s, t, .png .svg "
                            ".pdf a picture of the parameter lines on the mesh"},
                           {kEval, kOutput, "A .csv file in place of standard output"},
                           {kDistance, kOutput,
                            "A .csv file: x,y,z of the points, u,v of their closest points, the distance "
                            "signed by the surface's "
                            "normal"},
                           {kConvert, kOutput,
                            "May repeat. Of a surface: .json, .csv (values on --grid), .asc or .grd "
                            "(heights; --cell), .png .svg .pdf, "
                            ".obj .ply .vts, .step .stp .igs .iges. Of data: .csv (points), .asc or .grd "
                            "(points that lie on a grid), "
                            ".obj .ply (meshes)"}},
                  .holds = {[](Arguments& a, const std::string& t) { a.output.paths.push_back(t); }},
                  .first = kFits,
                  .offer = Offer::files,
                  .repeats = true,
                  .required = kConvert,
                  .brief = "Output file, the format by its extension",
                  .more = "The residuals are a line a point: x,y,z,u,v,error; meshes and grids hold error, "
                          "normal and curvature. CAD "
                          "files are read back before they count. A file is written whole or not at all."});
  rows.push_back(
      {.names = "-o,--output",
       .value = "FOLDER",
       .uses =
           {{kCompare, kOutput,
             "Tables (CSV, JSON), every surface, and pictures (SVG, PNG): error against control points, and "
             "each method's knot lines over its errors in one colour scale"}},
       .holds = {[](Arguments& a, const std::string& t) { a.output.paths = {t}; }},
       .first = kFits,
       .offer = Offer::files,
       .brief = "Folder of the tables, surfaces and pictures"});
  rows.push_back({.names = "--force,--overwrite",
                  .uses = {{kWrites & ~kCompare, kOutput, "Replace output files that exist"},
                           {kCompare, kOutput, "Replace the files of a comparison that is there"}},
                  .holds = {[](Arguments& a, const std::string&) { a.output.force = true; }},
                  .first = kFits});
  const std::string cell = "Cell size of an .asc output, or two as 30x25; default: ";
  rows.push_back({.names = "--cell",
                  .value = "SIZE",
                  .uses = {{kFit, kOutput, cell + "the input raster's own grid"},
                           {kConvert, kOutput, cell + "the grid of the raster that was fitted"}},
                  .holds = kept(&FitChoices::cell, parse_cell, cell_text),
                  .stored = {.form = Form::real_pair},
                  .acts = {.on_output = OutputKind::raster, .outputs = ".asc or .grd"}});
  rows.push_back(
      {.names = "--fill-holes",
       .uses = {{kFit, kOutput,
                 "Heights of the surface where the input has no data; of a mesh or a cloud: close its "
                 "openings, every "
                 "boundary loop but the longest, before it is mapped"},
                {kCompare, "Meshes",
                 "Close the openings of a cloud, and every boundary loop of a mesh but the longest"},
                {kMap, "Meshes", "Close every boundary loop but the longest"}},
       .holds = on(&FitChoices::fill_holes),
       .stored = {.form = Form::boolean, .usual = "off", .filled = true},
       .acts =
           {.on_input =
                [](const InputTraits& i) {
                  return i.raster || i.mesh || i.height_field || i.cloud() || i.mapped();
                },
            .purpose =
                "it closes the holes of a raster or of what is mapped, and writes heights where no data is"},
       .brief = "Fill the holes of a raster, a mesh or a cloud",
       .more = "What closes a hole is no data."});
}

void add_look_rows(std::vector<OptionRow>& rows) {
  rows.push_back(
      {.names = "--samples",
       .value = "N",
       .uses = {{kFit | kConvert, kOutput,
                 fmt::format("Samples a knot span of .obj, .ply and .vts outputs; default {}",
                             kSamplesPerSpan)}},
       .holds = kept(
           &FitChoices::samples,
           [](const std::string& t) { return count_up_to(t, 1, 10000, "a number of samples up to 10000"); },
           [](int n) { return std::to_string(n); }),
       .stored = {.form = Form::whole, .usual = std::to_string(kSamplesPerSpan), .filled = true},
       .acts = {.on_output = OutputKind::mesh, .outputs = ".obj, .ply or .vts"}});
  rows.push_back(
      {.names = "--reflections",
       .uses =
           {{kFit | kConvert, kOutput,
             "Pictures show the surface with reflection lines: where they break or wave, so do its normals"}},
       .holds = flag(&Arguments::reflections),
       .acts = kOfPictures,
       .brief = "Reflection lines in pictures",
       .more = "The lines are those of lamps 10 degrees apart."});
  rows.push_back(
      {.names = "--lines",
       .value = "N",
       .uses = {{kMap, kOutput,
                 fmt::format("Parts between the parameter lines of a picture, 1 to 200; default {}",
                             Arguments{}.lines)}},
       .holds = {[](Arguments& a, const std::string& t) {
         a.lines = count_up_to(t, 1, 200, "a number of parts from 1 to 200");
       }},
       .acts = kOfPictures});
  add_cad_rows(rows);
  add_number_rows(rows);
  rows.push_back({.names = "--names",
                  .uses = {{kLists, kOutput, "Names alone, one a line"}},
                  .holds = flag(&Arguments::names)});
  const std::string one = "One JSON object on standard output";
  rows.push_back({.names = "--json",
                  .uses = {{kFit | kCurve | kDistance, kOutput, one + " in place of the summary"},
                           {kCompare, kOutput, one + " in place of the table"},
                           {kMap, kOutput, one + ": the map's quality"},
                           {kEval, kOutput, one + ": columns, rows, and the differences' summary"},
                           {kInfo, kOutput, "One JSON object"},
                           {kLists, kOutput, "One JSON array"}},
                  .holds = flag(&Arguments::json),
                  .first = kFits});
  rows.push_back({.names = "--threads",
                  .value = "N",
                  .uses = {{kFits | kMap | kEval | kDistance, kRunning,
                            "Threads; 0 (default): as many as there are cores. Results do not depend on it"}},
                  .holds = {[](Arguments& a, const std::string& t) {
                    a.threads = count_up_to(t, 0, 4096, "a number of threads up to 4096");
                  }}});
  rows.push_back(
      {.names = "-q,--quiet",
       .uses = {{kFit, kRunning, "No progress and no summary; errors and --json are still printed"},
                {kCurve | kMap | kDistance, kRunning, "No progress and no summary"},
                {kCompare, kRunning, "No progress and no table"}},
       .holds = flag(&Arguments::quiet),
       .first = kFits});
  rows.push_back(
      {.names = "--options",
       .value = "FILE",
       .uses = {{kFit, kRepeat,
                 "Repeat the options stored in a surface.json (or in the output of --json); the command line "
                 "wins"}},
       .holds = {[](Arguments& a, const std::string& t) { a.options_from = t; }},
       .offer = Offer::files});
}

}  // namespace knotfit::tool
