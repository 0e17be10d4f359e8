#include "cad_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "knotfit/exceptions.h"
#include "knotfit/io.h"
namespace knotfit::tool {
namespace {

double net_diagonal(const Surface& s) {
  double squared = 0;
  for (int d = 0; d < 3; ++d) {
    double low = s.net()[d], high = low;
    for (std::size_t k = d; k < s.net().size(); k += 3) {
      low = std::min(low, s.net()[k]);
      high = std::max(high, s.net()[k]);
    }
    squared += (high - low) * (high - low);
  }
  return std::sqrt(squared);
}

CadFormat format_of(const OutputFile& file, const CadChoices& choices) {
  if (file.extension == ".igs" || file.extension == ".iges") return CadFormat::iges;
  return choices.schema.value_or(CadFormat::step_ap242);
}

std::vector<Surface> faces_of(const Surface& surface, const CadChoices& choices) {
  if (!choices.safe.value_or(false)) return {surface};
  const ToleranceValue tolerance = choices.tolerance.value_or(kDefaultCadTolerance);
  CadSafe safe;
  safe.tolerance = tolerance.relative ? tolerance.value / 100 * net_diagonal(surface) : tolerance.value;
  return cad_safe(surface, safe);
}

}  // namespace

void check_cad_output(const OutputFile& file, int dimension, bool height_field) {
  if (dimension != 3 && !height_field)
    throw InvalidInput(
        fmt::format("{}: holds a surface in space, but this one has {} component{} and is no height field",
                    file.path, dimension, dimension == 1 ? "" : "s"));
}

void write_cad_file(const OutputFile& file, bool force, const Surface& surface, const ParameterMap& map,
                    bool height_field, const CadChoices& choices) {
  check_cad_output(file, surface.dimension(), height_field);
  const Surface in_space = height_field ? height_field_in_space(surface, map) : surface;
  CadOptions options;
  options.format = format_of(file, choices);
  options.unit = choices.unit.value_or(CadUnit::millimetre);
  options.name = choices.name.value_or(std::filesystem::path(file.path).stem().string());
  try {
    write_cad(file.path, faces_of(in_space, choices), options, force);
  } catch (const InvalidInput& e) {
    throw InvalidInput(file.path + ": " + e.what());
  }
}

}  // namespace knotfit::tool
