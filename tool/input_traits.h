// What an input is and how it becomes points with parameters: what decides which options act.
#pragma once
#include <string>

#include "knotfit/source_data.h"
#include "options.h"
namespace knotfit::tool {

struct InputTraits {
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
  bool mapped() const;
  /// "a mesh", "rows of points over a surface (--base)".
  std::string name() const;
};

InputTraits input_traits(const SourceData& data, const FitChoices& choices);

}  // namespace knotfit::tool
