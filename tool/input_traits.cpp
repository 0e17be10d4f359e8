#include "input_traits.h"

#include <fmt/format.h>

#include "knotfit/mesh_parameters.h"
#include "text_values.h"
namespace knotfit::tool {

bool InputTraits::mapped() const {
  if (raster || height_field || !in_space) return false;
  if (mesh) return !parameters || anew;
  if (cloud()) return base.kind == CloudBase::automatic || base.kind == CloudBase::graph;
  return rows && (anew || (ragged && chord && corrected));
}

std::string InputTraits::name() const {
  if (raster) return "a raster of heights";
  const std::string what = mesh ? "a mesh" : rows ? "rows of points" : "points";
  if (height_field) return what + " fitted as a height field (--height-field)";
  if (own_parameters()) return what + " with parameters of their own";
  if (cloud() && !base.surface.empty()) return what + " over a surface (--base)";
  if (cloud() && over_base())
    return fmt::format("{} over a base (--base {})", what, name_of(kBases, base.kind));
  return mesh || rows ? what : what + " without parameters";
}

InputTraits input_traits(const SourceData& data, const FitChoices& choices) {
  InputTraits input;
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

}  // namespace knotfit::tool
