// Options on meshes and clouds: repair, map, base, correction of parameters.
#include <fmt/format.h>

#include "knotfit/correct.h"
#include "option_holders.h"
namespace knotfit::tool {
namespace {

constexpr std::string_view kMeshes = "Meshes";
constexpr Commands kMapped = kFit | kCompare | kMap;

constexpr Acts kRepair = {.on_input = [](const InputTraits& i) { return i.mesh; },
                          .purpose = "it repairs meshes"};
constexpr Acts kMapping = {.on_input = [](const InputTraits& i) { return i.mapped(); },
                           .purpose = "it shapes the map of a mesh, or of points that become one"};
const Stored kSwitchedOff = {.form = Form::boolean, .usual = "off", .filled = true};

}  // namespace

void add_mesh_rows(std::vector<OptionRow>& rows) {
  rows.push_back({.names = "--largest-part",
                  .uses = {{kMapped, kMeshes, "Keep the part of a mesh with the most area"}},
                  .holds = on(&FitChoices::largest_part),
                  .stored = kSwitchedOff,
                  .acts = kRepair});
  rows.push_back(
      {.names = "--orient",
       .uses = {{kMapped, kMeshes,
                 "Turn triangles that have their corners in the opposite order to their neighbours"}},
       .holds = on(&FitChoices::orient),
       .stored = kSwitchedOff,
       .acts = kRepair});
  rows.push_back({.names = "--drop-degenerate",
                  .uses = {{kMapped, kMeshes, "Drop triangles of no area, without opening gaps"}},
                  .holds = on(&FitChoices::drop_degenerate),
                  .stored = kSwitchedOff,
                  .acts = kRepair});
  rows.push_back(
      {.names = "--correct",
       .value = "auto|off|N",
       .uses =
           {{kFit, kMeshes,
             fmt::format(
                 "Parameters corrected together with the control points, in N rounds; the error is then the "
                 "distance to the surface, and a surface that folds over the data does not hold a tolerance. "
                 "Default auto: {} rounds for meshes and clouds that are mapped and for rows of different "
                 "lengths (two fifths at each size of a search), none with --refine insert or --degree auto",
                 CorrectionOptions{}.rounds)}},
       .holds = kept(&FitChoices::correct, parse_correct, correct_text),
       .stored = {.form = Form::text, .usual = "auto", .filled = true},
       .more = "The distance from the surface to the mesh and its folds are reported too."});
  rows.push_back(
      {.names = "--fairness",
       .value = "X",
       .uses =
           {{kFit, kMeshes,
             "Weight of a correction against ruffles that do not turn back, in times of its own: 0 none, 10 "
             "a fairer surface that is farther from the data; default 1"}},
       .holds = real(&FitChoices::fairness, parse_not_negative),
       .stored = {.form = Form::real, .usual = "1", .filled = true}});
  rows.push_back(
      {.names = "--new-parameters",
       .uses = {{kFit, kMeshes, "Map a mesh or points anew that have parameters (vt; s, t; u, v)"}},
       .holds = on(&FitChoices::new_parameters),
       .stored = kSwitchedOff,
       .acts = {.on_input = [](const InputTraits& i) { return !i.raster && !i.height_field && i.in_space; },
                .purpose = "it maps points or meshes in space anew"},
       .more = "parameterize always does."});
  rows.push_back({.names = "--corners",
                  .value = "RULE|I,J,K,L|PLACES",
                  .uses = {{kMapped, kMeshes,
                            "Corners of the square that a mesh is mapped to: auto (default), sharpest, "
                            "search; or four vertices of the "
                            "boundary, counter-clockwise, by number as the file counts (OBJ from 1, others "
                            "from 0) or by place: "
                            "\"x,y,z;x,y,z;x,y,z;x,y,z\""}},
                  .holds = text(&FitChoices::corners, parse_corners),
                  .stored = {.form = Form::words,
                             .usual = std::string(name_of(kCornerRules, CornerChoice{}.rule)),
                             .filled = true},
                  .acts = kMapping,
                  .words = one_of(kCornerRules, " ")});
  rows.push_back(
      {.names = "--base",
       .value = "BASE|FILE|A,B,C,D",
       .uses = {{kFit | kCompare, "Input",
                 "What points without parameters are projected to: plane (through their principal axes), "
                 "cylinder, graph (no "
                 "base: nearest neighbours make a mesh that is mapped), the file of a surface, or four of "
                 "boundary curves; "
                 "default auto: plane, or graph where they fold over it. Given parameters are left aside"}},
       .holds = text(&FitChoices::base, parse_base),
       .first = kFit | kCompare,
       .stored = {.form = Form::words,
                  .usual = std::string(name_of(kBases, BaseChoice{}.kind)),
                  .filled = true},
       .acts = {.on_input = [](const InputTraits& i) { return !i.raster && !i.mesh && !i.height_field; },
                .purpose = "it is what points without parameters are projected to"},
       .offer = Offer::files,
       .words = "auto plane cylinder graph"});
  rows.push_back({.names = "--omega",
                  .value = "X",
                  .uses = {{kMapped, kMeshes,
                            "Weight of the normals in the map's metric, 0 to 10; default: the best of some"}},
                  .holds = real(&FitChoices::omega, parse_not_negative),
                  .stored = {.form = Form::real},
                  .acts = kMapping});
  rows.push_back({.names = "--map",
                  .value = one_of(kMaps),
                  .uses = {{kMap, kMeshes,
                            "How a mesh is mapped: with little stretch (newton, default), or by mean value "
                            "coordinates alone"}},
                  .holds = {[](Arguments& a, const std::string& t) { a.newton = parse_named(kMaps, t); }}});
}

}  // namespace knotfit::tool
