// Options on what is read: surfaces, data, places to evaluate at, and how points get their parameters.
#include <fmt/format.h>

#include "knotfit/mesh.h"
#include "option_holders.h"
namespace knotfit::tool {
namespace {

constexpr std::string_view kInput = "Input", kWhere = "Where";

template <class T>
std::string joined(const std::vector<T>& values) {
  return fmt::format("{}", fmt::join(values, ","));
}

bool is_text(const SourceData& data) {
  return data.format == "csv" || data.format == "rows";
}

bool has_columns(const SourceData& data) {
  const bool array = data.format.starts_with("npy") && !std::holds_alternative<Raster>(data.content);
  return is_text(data) || array;
}

bool may_miss_values(const SourceData& data) {
  return data.format != "off" && data.format != "stl";
}

void add_surface_rows(std::vector<OptionRow>& rows) {
  const Commands surfaces = kEval | kDistance | kInfo;
  rows.push_back(
      {.names = "--unit",
       .value = one_of(kUnits),
       .uses = {{surfaces, kInput,
                 fmt::format("The unit that a STEP or IGES file's surface is wanted in; default {}",
                             name_of(kUnits, CadUnit{}))}},
       .holds = {[](Arguments& a, const std::string& t) { a.source.unit = parse_named(kUnits, t); }}});
  rows.push_back({.names = "--face",
                  .value = "N",
                  .uses = {{surfaces | kConvert, kInput,
                            "Which surface of a STEP or IGES file that holds several, from 1"}},
                  .holds = {[](Arguments& a, const std::string& t) {
                    a.source.face = static_cast<int>(std::min<long long>(parse_count(t, 1), 1 << 30));
                  }},
                  .more = "info tells of all without it."});
}

void add_reading_rows(std::vector<OptionRow>& rows) {
  rows.push_back(
      {.names = "--input-format",
       .value = "NAME",
       .uses = {{kReads, kInput,
                 "Format of the input, by name (knotfit formats lists them); default: by extension, then "
                 "content"},
                {kMap, kInput, "Format of the input, by name; default: by extension, then content"}},
       .holds = text(&InputOptions::format),
       .first = kFits,
       .stored = {.form = Form::text},
       .offer = Offer::formats,
       .brief = "Format of the input"});
  rows.push_back(
      {.names = "--columns",
       .value = "x,y,z,u,v,w",
       .uses =
           {{kReads, kInput,
             "What the columns of a text file or array are, in order: the names a header may have; nx, ny, "
             "nz are normals, r, g, b, intensity, time and - are left out"}},
       .holds = kept(&InputOptions::columns, parse_columns, joined<std::string>),
       .first = kFits,
       .stored = {.form = Form::names},
       .acts = {.on_file = has_columns,
                .purpose = "it says what the columns of text and of n x k arrays are",
                .reading = true}});
  rows.push_back(
      {.names = "--nodata",
       .value = "V|nan",
       .uses = {{kReads, kInput,
                 "What stands for missing data: a number (of z), or nan for every word that does (nan, NA, "
                 "null, an empty cell). Cells become holes; points are left out and counted"}},
       .holds = kept(&InputOptions::nodata, parse_nodata, nodata_text),
       .first = kFit | kCompare,
       .stored = {.form = Form::real},
       .acts = {.on_file = may_miss_values,
                .purpose = "it is what stands for missing data among points and heights",
                .reading = true}});
  rows.push_back({.names = "--skip-lines",
                  .value = "N",
                  .uses = {{kReads, kInput, "Leave out the first N lines of a text"}},
                  .holds = count(&InputOptions::skip_lines),
                  .stored = {.form = Form::whole},
                  .acts = {.on_file = is_text,
                           .purpose = "it leaves out the first lines of points in text",
                           .reading = true}});
  rows.push_back(
      {.names = "--classes",
       .value = "N,M,...",
       .uses = {{kReads, kInput, "Only LAS points of these classes, such as 2 for ground; default: all"}},
       .holds = kept(&InputOptions::classes, parse_classes, joined<int>),
       .stored = {.form = Form::wholes},
       .acts = {.reading = true}});
  rows.push_back(
      {.names = "--returns",
       .value = "first|last|N,...",
       .uses = {{kReads, kInput,
                 "Only these returns of LAS pulses, by number, first, or the last of each; default: all"}},
       .holds = kept(&InputOptions::returns, parse_returns, returns_text),
       .stored = {.form = Form::returns},
       .acts = {.reading = true}});
  rows.push_back(
      {.names = "--weld",
       .value = "auto|off|X|X%",
       .uses =
           {{kFit | kCompare | kMap | kDistance | kInfo | kConvert, "Meshes",
             "Vertices of a mesh within X of each other become one where that joins its faces: X in the "
             "data's unit, or in % of the diagonal; default auto: 1e-7 of the diagonal, and the last bit of "
             "single precision"}},
       .holds = text(&InputOptions::weld, parse_weld),
       .stored = {.form = Form::text, .usual = "auto"},
       .acts = {.on_file = [](const SourceData& data) { return std::holds_alternative<Mesh>(data.content); },
                .purpose = "it joins the vertices of meshes",
                .reading = true},
       .more = "X is at most 1 % of the diagonal. What is cut open and would be no disk without the cut "
               "stays cut."});
}

void add_place_rows(std::vector<OptionRow>& rows) {
  rows.push_back(
      {.names = "--at",
       .value = "A,B",
       .uses = {{kEval, kWhere,
                 "Parameters u,v, or x,y for a height field, in the coordinates of the data that was fitted; "
                 "may repeat"}},
       .holds = {[](Arguments& a, const std::string& t) { a.at.push_back(parse_position(t)); }},
       .repeats = true,
       .excludes = {"--points", "--grid"}});
  rows.push_back(
      {.names = "--points",
       .value = "FILE",
       .uses = {{kEval, kWhere,
                 "Every point of a file: columns u,v, or x,y (or a raster) for a height field. Where it has "
                 "values too, the differences: check points never used in the fit"}},
       .holds = {[](Arguments& a, const std::string& t) { a.points = t; }},
       .offer = Offer::files,
       .excludes = {"--grid"}});
  rows.push_back({.names = "--grid",
                  .value = "NxM",
                  .uses = {{kEval, kWhere, "N x M places over the whole domain, borders included"},
                           {kConvert, "Output",
                            fmt::format("Places of a .csv output; default {}x{}", kConvertGrid.first,
                                        kConvertGrid.second)}},
                  .holds = {[](Arguments& a, const std::string& t) { a.grid = parse_pair(t, 2); }},
                  .acts = {.on_output = OutputKind::table, .outputs = ".csv"}});
  rows.push_back({.names = "--clamp",
                  .uses = {{kEval, kWhere,
                            "Move places outside the domain to its border; without it they are an error"}},
                  .holds = flag(&Arguments::clamp)});
}

void add_parameter_rows(std::vector<OptionRow>& rows) {
  rows.push_back({.names = "--height-field",
                  .uses = {{kFit | kCompare, kInput, "Fit z over x, y (always so for rasters)"}},
                  .holds = on(&FitChoices::height_field),
                  .first = kFit | kCompare,
                  .stored = {.form = Form::boolean, .usual = "off", .filled = true}});
  rows.push_back(
      {.names = "--block",
       .value = "N",
       .uses = {{kCurve, kInput,
                 "Which of several blocks of points (parted by blank lines, names or counts), from 1"}},
       .holds = {[](Arguments& a, const std::string& t) { a.block = static_cast<Index>(parse_count(t, 1)); }},
       .acts = {.on_file = is_text, .purpose = "it chooses a block of points in text"}});
  rows.push_back({.names = "--closed",
                  .uses = {{kCurve, kInput, "A closed curve: the last point is followed by the first"}},
                  .holds = flag(&Arguments::closed),
                  .first = kCurve,
                  .more = "It is a periodic spline, with as many control points as knots in a period."});
  rows.push_back({.names = "--function",
                  .uses = {{kCurve, kInput, "y over x: errors are differences of y, x must increase"}},
                  .holds = flag(&Arguments::function),
                  .first = kCurve,
                  .excludes = {"--closed"}});
  rows.push_back(
      {.names = "--spacing",
       .value = one_of(kSpacings),
       .uses = {{kFit | kCompare, kInput,
                 fmt::format(
                     "Parameters of rows and grids of points; default {} (rows of different lengths are "
                     "then mapped anew where they are corrected)",
                     name_of(kSpacings, RowSpacing::chord))},
                {kCurve, kInput,
                 fmt::format("Parameters of the points; default {}", name_of(kSpacings, RowSpacing::chord))}},
       .holds = named(&FitChoices::spacing, kSpacings),
       .stored = {.form = Form::text,
                  .usual = std::string(name_of(kSpacings, RowSpacing::chord)),
                  .filled = true},
       .acts = {.on_input = [](const InputTraits& i) { return i.rows && !i.height_field && !i.over_base(); },
                .purpose = "it gives rows and grids of points their parameters"},
       .excludes = {"--function"}});
  rows.push_back({.names = "--corrected",
                  .uses = {{kCurve, kInput,
                            "Move every parameter to the foot of its point on the curve, and fit again"}},
                  .holds = flag(&Arguments::corrected),
                  .first = kCurve,
                  .excludes = {"--function"}});
  rows.push_back(
      {.names = "--rescale-parameters",
       .uses = {{kFit | kCompare, kInput,
                 "Map the range of u and of v to [0,1]; without it a parameter outside [0,1] is an error"}},
       .holds = on(&FitChoices::rescale_parameters),
       .stored = {.form = Form::boolean, .usual = "off", .filled = true},
       .acts = {.on_input = [](const InputTraits& i) { return i.own_parameters(); },
                .purpose = "it scales parameters that come with the points"}});
  rows.push_back(
      {.names = "--duplicates",
       .value = one_of(kDuplicateRules),
       .uses = {{kFit | kCompare, kInput,
                 "What becomes of points with equal parameters: their mean, "
                 "the lowest, the highest; default fail: an error where no surface can meet the tolerance at "
                 "both"}},
       .holds = named(&FitChoices::duplicates, kDuplicateRules),
       .stored = {.form = Form::text,
                  .usual = std::string(name_of(kDuplicateRules, DuplicateRule::fail)),
                  .filled = true},
       .acts = {.on_input = [](const InputTraits& i) { return !i.raster; },
                .purpose = "it settles points with equal parameters"}});
}

}  // namespace

void add_input_rows(std::vector<OptionRow>& rows) {
  add_surface_rows(rows);
  add_reading_rows(rows);
  add_place_rows(rows);
  add_parameter_rows(rows);
}

}  // namespace knotfit::tool
