#include "applicable_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "knotfit/exceptions.h"
#include "knotfit/mesh_parameters.h"
#include "standard_streams.h"
#include "surface_file.h"
#include "text_values.h"
namespace knotfit::tool {
namespace {

// What decides which options act.
struct Input {
  bool raster = false, mesh = false, rows = false, ragged = false;
  bool in_space = true;       ///< points have x, y, z
  bool parameters = false;    ///< the file has u, v
  bool height_field = false;  ///< --height-field
  bool anew = false;          ///< --new-parameters
  bool corrected = true;      ///< unless --correct off
  bool chord = true;          ///< --spacing
  bool sheared = false;       ///< --shear, not off
  BaseChoice base{};          ///< --base

  bool over_base() const { return base.kind != CloudBase::automatic; }
  /// Parameters of the file are used.
  bool own_parameters() const { return parameters && !height_field && !anew && !(over_base() && !mesh); }
  /// Points without a mesh that are laid over a base or made a mesh.
  bool cloud() const {
    return !raster && !mesh && !height_field && (over_base() || (!rows && (anew || !parameters)));
  }
  /// A mesh, of the file or of the points, is mapped to the square.
  bool mapped() const {
    if (raster || height_field || !in_space) return false;
    if (mesh) return !parameters || anew;
    if (cloud()) return base.kind == CloudBase::automatic || base.kind == CloudBase::graph;
    return rows && (anew || (ragged && chord && corrected));
  }

  std::string name() const {
    if (raster) return "a raster of heights";
    const std::string what = mesh ? "a mesh" : rows ? "rows of points" : "points";
    if (height_field) return what + " fitted as a height field (--height-field)";
    if (own_parameters()) return what + " with parameters of their own";
    if (cloud() && !base.surface.empty()) return what + " over a surface (--base)";
    if (cloud() && over_base())
      return fmt::format("{} over a base (--base {})", what, name_of(kBases, base.kind));
    return mesh || rows ? what : what + " without parameters";
  }
};

Input input_of(const SourceData& data, const FitChoices& choices) {
  Input input;
  input.height_field = choices.height_field.value_or(false);
  input.anew = choices.new_parameters.value_or(false);
  input.corrected = choices.correct.value_or(-1) != 0;
  input.chord = choices.spacing.value_or(RowSpacing::chord) == RowSpacing::chord;
  input.base = parse_base(choices.base.value_or("auto"));
  input.sheared = choices.shear && choices.shear->asked();
  input.raster = std::holds_alternative<Raster>(data.content);
  if (const Mesh* mesh = std::get_if<Mesh>(&data.content)) {
    input.mesh = true;
    input.parameters = !mesh->uv.empty() && check_parameters(*mesh).one_to_one;  // else left aside
  } else if (const PointRows* rows = std::get_if<PointRows>(&data.content)) {
    input.rows = true;
    input.ragged = rows->common_length() == 0;
  } else if (const PointTable* table = std::get_if<PointTable>(&data.content)) {
    input.parameters = !table->u.empty();
    input.in_space = !table->x.empty();
  }
  return input;
}

struct InputRule {
  std::string_view option;
  bool (*acts)(const Input&);
  std::string_view purpose;
};
constexpr std::string_view kRepair = "it repairs meshes";
constexpr std::string_view kMap = "it shapes the map of a mesh, or of points that become one";
constexpr InputRule kInputRules[] = {
    {"--base", [](const Input& i) { return !i.raster && !i.mesh && !i.height_field; },
     "it is what points without parameters are projected to"},
    {"--spacing", [](const Input& i) { return i.rows && !i.height_field && !i.over_base(); },
     "it gives rows and grids of points their parameters"},
    {"--rescale-parameters", [](const Input& i) { return i.own_parameters(); },
     "it scales parameters that come with the points"},
    {"--new-parameters", [](const Input& i) { return !i.raster && !i.height_field && i.in_space; },
     "it maps points or meshes in space anew"},
    {"--duplicates", [](const Input& i) { return !i.raster; }, "it settles points with equal parameters"},
    {"--largest-part", [](const Input& i) { return i.mesh; }, kRepair},
    {"--orient", [](const Input& i) { return i.mesh; }, kRepair},
    {"--drop-degenerate", [](const Input& i) { return i.mesh; }, kRepair},
    {"--fill-holes",
     [](const Input& i) { return i.raster || i.mesh || i.height_field || i.cloud() || i.mapped(); },
     "it closes the holes of a raster or of what is mapped, and writes heights where no data is"},
    {"--corners", [](const Input& i) { return i.mapped(); }, kMap},
    {"--omega", [](const Input& i) { return i.mapped(); }, kMap},
    {"--shear", [](const Input& i) { return i.raster || i.height_field || !i.sheared; },
     "it is for height fields, whose x and y it shears"},
};

struct OutputRule {
  std::string_view option;
  OutputKind kind;
  std::string_view outputs;
};
constexpr OutputRule kOutputRules[] = {
    {"--cell", OutputKind::raster, ".asc or .grd"},
    {"--samples", OutputKind::mesh, ".obj, .ply or .vts"},
    {"--reflections", OutputKind::picture, ".png, .svg or .pdf"},
    {"--lines", OutputKind::picture, ".png, .svg or .pdf"},
    {"--grid", OutputKind::table, ".csv"},
    {"--unit", OutputKind::cad, "STEP or IGES"},
    {"--name", OutputKind::cad, "STEP or IGES"},
    {"--step-schema", OutputKind::cad, "STEP"},
    {"--cad-safe", OutputKind::cad, "STEP or IGES"},
    {"--cad-tol", OutputKind::cad, "STEP or IGES"},
};

}  // namespace

bool is_given(const std::vector<std::string>& given, std::string_view option) {
  return std::find(given.begin(), given.end(), option) != given.end();
}

void refuse_given(const std::vector<std::string>& given, std::initializer_list<std::string_view> options,
                  const std::string& what) {
  for (const std::string_view option : options)
    if (is_given(given, option)) throw InvalidInput(fmt::format("{} does not apply to {}", option, what));
}

void refuse_data_options(const std::vector<std::string>& given, const std::string& what) {
  refuse_given(given, {"--columns", "--nodata", "--classes", "--returns", "--skip-lines", "--weld"}, what);
}

void refuse_idle_reading(const SourceData& data, const std::string& path, const InputOptions& options) {
  const bool raster = std::holds_alternative<Raster>(data.content);
  const bool text = data.format == "csv" || data.format == "rows";
  const bool array = data.format.starts_with("npy") && !raster;
  const auto refuse_unless = [&](bool acts, std::string_view option, std::string_view purpose) {
    if (acts || !is_given(options.given, option)) return;
    throw InvalidInput(fmt::format(
        "{}: {} does not apply to {}: {}", input_name(path), option,
        raster ? "a raster of heights" : fmt::format("a file of format {}", data.format), purpose));
  };
  refuse_unless(text || array, "--columns", "it says what the columns of text and of n x k arrays are");
  refuse_unless(text, "--skip-lines", "it leaves out the first lines of points in text");
  refuse_unless(text, "--block", "it chooses a block of points in text");
  refuse_unless(std::holds_alternative<Mesh>(data.content), "--weld", "it joins the vertices of meshes");
  refuse_unless(!(data.format == "off" || data.format == "stl"), "--nodata",
                "it is what stands for missing data among points and heights");
}

void refuse_idle_options(const SourceData& data, const FitChoices& choices) {
  const Input input = input_of(data, choices);
  for (const InputRule& rule : kInputRules)
    if (is_given(choices.input.given, rule.option) && !rule.acts(input))
      throw InvalidInput(fmt::format("{} does not apply to {}: {}", rule.option, input.name(), rule.purpose));
}

void refuse_idle_output_options(const std::vector<std::string>& given, const std::vector<OutputFile>& files) {
  for (const OutputRule& rule : kOutputRules)
    if (is_given(given, rule.option) && !asks_for(files, rule.kind))
      throw InvalidInput(
          fmt::format("{} is for {} outputs (-o), and none is asked for", rule.option, rule.outputs));
}

}  // namespace knotfit::tool
