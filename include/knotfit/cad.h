// CAD exchange by OpenCASCADE: STEP and IGES. Compiled where KNOTFIT_WITH_CAD is on.
#pragma once
#include <string>
#include <vector>

#include "knotfit/surface.h"
namespace knotfit {

enum class CadUnit { millimetre, metre, inch };
enum class CadFormat { step_ap214, step_ap242, iges };

struct CadOptions {
  CadFormat format = CadFormat::step_ap242;
  CadUnit unit = CadUnit::millimetre;   ///< the unit the surface's coordinates are in
  std::string name = "knotfit surface"; ///< of the part
};

/// Whether this build has CAD exchange.
bool cad_available();

/// Writes beside the target, reads the file back with OpenCASCADE, compares surface, unit and face, and only then
/// renames. One valid face a surface.
/// \param surfaces  in R^3
/// \throws InvalidInput  a surface not in R^3; FileError, WriteError as write_file; std::runtime_error where the
///   file read back differs
void write_cad(const std::string& path, const std::vector<Surface>& surfaces, const CadOptions& options, bool force);

/// The B-spline surfaces of a STEP or IGES file, in the unit asked for.
/// \throws FileError  unreadable, or no B-spline surface in it; rational ones are refused by name
std::vector<Surface> read_cad(const std::string& path, CadUnit unit = CadUnit::millimetre);

struct CadSafe {
  int degree = 3;                    ///< raised to it, or approximated within `tolerance`
  double tolerance = 0;              ///< what degree reduction may cost; 0: refuse to reduce
  Index most_control_points = 250;   ///< a direction, a face
  double least_knot_distance = 1e-7; ///< of the domain: nearer knots are merged within `tolerance`
};
/// What CAD systems digest: degree 3, split at full-multiplicity knots into C1 faces, limits on control points a
/// direction, no knots closer than CAD tolerance. The union of the faces is the surface.
std::vector<Surface> cad_safe(const Surface& surface, const CadSafe& options = {});

}  // namespace knotfit
