// CAD exchange by OpenCASCADE: STEP and IGES. Compiled where KNOTFIT_WITH_CAD is on.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "knotfit/cad_safe.h"
#include "knotfit/surface.h"
namespace [[gnu::visibility("default")]] knotfit {

enum class CadUnit { millimetre, metre, inch };
enum class CadFormat { step_ap214, step_ap242, iges };

struct CadOptions {
  CadFormat format = CadFormat::step_ap242;
  CadUnit unit = CadUnit::millimetre;    ///< the unit the surface's coordinates are in
  std::string name = "knotfit surface";  ///< of the part, UTF-8; in IGES what is not ASCII becomes '?'
  /// Of the header, as ISO 8601: a fixed one, so that the same surface gives the same bytes.
  std::string time_stamp = "1970-01-01T00:00:00";
};

/// Whether this build has CAD exchange.
bool cad_available();

/// Writes beside the target, reads the file back with OpenCASCADE, compares surface, unit and face, and only then
/// renames. One valid face a surface.
/// \param surfaces  in R^3
/// \throws InvalidInput  a surface not in R^3; FileError, WriteError as write_file; std::runtime_error where the
///   file read back differs
void write_cad(const std::string& path, const std::vector<Surface>& surfaces, const CadOptions& options,
               bool force);

/// A face of a CAD file: its surface, or why knotfit does not represent it.
struct CadFace {
  std::string kind;  ///< "B-spline surface", "rational B-spline surface", "plane", "cylindrical surface"
  std::optional<Surface> surface;  ///< whole, without the face's borders; absent: not usable
  std::string why;                 ///< it is not; empty: it is
  bool trimmed = false;  ///< the face is a part of the surface: its borders run inside, or it has holes
};

/// Every face of a STEP or IGES file in its order, in the unit asked for.
/// \throws FileError  unreadable, or no face in it
std::vector<CadFace> read_cad_faces(const std::string& path, CadUnit unit = CadUnit::millimetre);

/// The surfaces of the faces that are usable.
/// \throws FileError  unreadable, or none is: says why each is not
std::vector<Surface> read_cad(const std::string& path, CadUnit unit = CadUnit::millimetre);

}  // namespace knotfit
