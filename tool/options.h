// What the command line asks for, as plain structs. A field without a value was not given.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "knotfit/cad.h"
#include "knotfit/features.h"
#include "knotfit/map_picture.h"
#include "knotfit/parameterize.h"
#include "knotfit/parameterize_cloud.h"
#include "knotfit/parameterize_mesh.h"
#include "knotfit/place.h"
#include "knotfit/refine.h"
#include "knotfit/tolerance.h"
namespace knotfit::tool {

/// --tol: absolute, or in % of the diagonal (height fields: of the range of heights).
struct ToleranceValue {
  double value = 0;
  bool relative = false;
};

/// Where neither a tolerance nor a size nor knots are given.
inline constexpr ToleranceValue kDefaultTolerance{0.1, true};
/// Of --cad-safe: far below any tolerance of a fit.
inline constexpr ToleranceValue kDefaultCadTolerance{0.001, true};

/// What counts as the error: --rms, --within, default max.
struct MeasureValue {
  ErrorMeasure measure = ErrorMeasure::max;
  double share = 1;  ///< percentile: in (0,1)
};

struct IntegerPair {
  int first = 0, second = 0;
};

/// Places of a .csv output of convert.
inline constexpr IntegerPair kConvertGrid{100, 100};

/// Where knots come from: a method by name, or given interior knots.
struct KnotSource {
  std::string method;  ///< empty: given
  std::optional<InteriorKnots> given;
};

/// --shear: none, found, or given.
struct ShearChoice {
  bool automatic = false;
  double u = 0, v = 0;  ///< both 0: none, unless automatic
  bool asked() const { return automatic || u != 0 || v != 0; }
};

/// --corners: a rule, or four vertices by number or place.
struct CornerChoice {
  CornerRule rule = CornerRule::automatic;
  std::vector<Index> vertices{};                ///< four in the file's own counting, or none
  std::vector<std::array<double, 3>> places{};  ///< four, or none
};

/// --base: what a cloud is projected to.
struct BaseChoice {
  CloudBase kind = CloudBase::automatic;
  std::string surface{};              ///< file of a given one
  std::vector<std::string> curves{};  ///< files of four boundary curves, or none
};

/// --weld: vertices at the same place become one.
struct WeldChoice {
  bool off = false;
  std::optional<ToleranceValue> tolerance{};  ///< none: the usual one
};

/// How a data file is read.
struct InputOptions {
  std::optional<std::string> format;
  std::optional<std::vector<std::string>> columns;
  std::optional<double> nodata;                      ///< NaN: every word for missing data
  std::optional<Index> skip_lines;                   ///< of a text
  std::optional<std::vector<int>> classes, returns;  ///< of LAS points, as ReadOptions
  std::optional<std::string> weld;                   ///< of meshes: text of parse_weld
  bool keep_parameters = false;                      ///< of meshes: none are given up in a weld
  bool every_vertex = false;                         ///< of meshes: there is no weld
  std::vector<std::string>
      given;  ///< every option on the command line, as "--base", also those of no reading
};

/// What STEP and IGES outputs are like.
struct CadChoices {
  std::optional<CadUnit> unit;
  std::optional<std::string> name;          ///< of the part; default: the file's
  std::optional<CadFormat> schema;          ///< of STEP
  std::optional<bool> safe;                 ///< cad_safe
  std::optional<ToleranceValue> tolerance;  ///< what cad_safe may move the surface by
};

/// Which surface of a file, and in which unit it is wanted.
struct SurfaceChoices {
  std::optional<CadUnit> unit;  ///< of STEP and IGES
  std::optional<int> face;      ///< from 1
};

/// The options of `fit` that shape its result: stored in every output, repeated by --options.
struct FitChoices {
  std::optional<ToleranceValue> tolerance;
  std::optional<MeasureValue> measure;
  std::optional<IntegerPair> control_points;
  std::optional<KnotSource> knots;
  std::optional<IntegerPair> degree;  ///< 0 x 0: auto
  std::optional<ShearChoice> shear;
  std::optional<RefineRoute> refine;
  std::optional<Effort> effort;
  std::optional<bool> guard;
  std::optional<Engine> engine;
  std::optional<long long> max_control_points;
  std::optional<long> max_fits;
  std::optional<double> time_limit;
  std::optional<FeatureMeasure> feature;
  std::optional<std::string> feature_file;  ///< in place of `feature`
  std::optional<long> evaluations;
  std::optional<double> smoothing;
  std::optional<bool> between;
  InputOptions input;
  std::optional<bool> height_field;
  std::optional<RowSpacing> spacing;
  std::optional<bool> rescale_parameters;
  std::optional<DuplicateRule> duplicates;
  std::optional<std::pair<double, double>> cell;  ///< of .asc outputs: dx, dy
  std::optional<bool> fill_holes;  ///< of a raster in .asc outputs, of a mesh before it is mapped
  std::optional<bool> largest_part, orient, drop_degenerate, new_parameters;  ///< of meshes
  std::optional<std::string> corners;                                         ///< text of parse_corners
  std::optional<std::string> base;                                            ///< text of parse_base
  std::optional<int> correct;      ///< rounds of parameter correction; 0: off, -1: auto
  std::optional<double> fairness;  ///< of a correction, in times of the default
  std::optional<double> omega;     ///< weight of the normals in the map
  std::optional<int> samples;      ///< a span, of .obj, .ply and .vts outputs
  CadChoices cad;
};

struct OutputOptions {
  std::vector<std::string> paths;
  bool force = false;
};

enum class Command { fit, compare, fit_curve, parameterize, eval, distance, info, convert, methods, formats };

/// What the command line asks for. Each command has the options that its rows give it (option_rows.h); the others are as
/// they are here.
struct Arguments {
  Command command = Command::fit;
  std::string input;         ///< the file, or the first of two
  std::string data;          ///< distance: the second
  FitChoices choices;        ///< with how a file is read, and what CAD outputs are like
  SurfaceChoices source;     ///< where a surface is read: of convert the unit is that of `choices.cad`
  OutputOptions output;      ///< compare: one folder
  bool reflections = false;  ///< in pictures
  bool names = false;        ///< lists: names alone, one a line, for shell completion
  bool json = false, quiet = false;
  int threads = 0;
  std::optional<IntegerPair> grid;  ///< eval: places; convert: those of a .csv output

  // fit
  std::string knots_from;    ///< surface file whose knots (and degree) are used
  std::string options_from;  ///< file whose stored options are repeated
  // compare, and fit-curve with a table
  std::vector<IntegerPair> sizes;
  std::vector<ToleranceValue> tolerances;
  std::vector<std::string> methods;  ///< compare: empty is all; fit-curve: empty is one curve
  // fit-curve; of its control points and degree the first counts
  std::optional<std::vector<double>> knots_t;
  bool closed = false, function = false, corrected = false;
  Index block = 0;  ///< of a text, from 1; 0: there is one
  // parameterize
  bool newton = true;                   ///< false: mean value map
  int lines = MapPictureInput{}.parts;  ///< parts between parameter lines in a picture
  // eval
  std::vector<std::pair<double, double>> at;
  std::string points;
  std::vector<IntegerPair> derivatives;  ///< (a, b) orders
  std::optional<int> derivatives_up_to;
  bool normals = false, curvature = false, clamp = false;
  // distance
  int surface_samples = 700;  ///< a direction; 0: the surface to a mesh is not measured
};

}  // namespace knotfit::tool
