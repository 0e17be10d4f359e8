// Curves as files: knotfit JSON, STEP and IGES.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "knotfit/cad.h"
#include "knotfit/curve.h"
namespace [[gnu::visibility("default")]] knotfit {

/// A curve with what belongs to it in a knotfit JSON file.
struct CurveDocument {
  Curve curve;
  bool closed = false;
  /// y over x = x0 + t (x1 - x0): the curve has one component.
  bool function = false;
  double x0 = 0, x1 = 1;
  std::string options;  ///< a JSON object as text; empty: none
  std::string result;   ///< a JSON object as text; empty: none
};
/// The schema "knotfit-curve" (docs/formats.md); doubles round-trip exactly.
/// \throws InvalidInput  no curve, x0 not below x1, options or result that are no JSON object
std::string to_json(const CurveDocument& document);
/// \throws FileError  not JSON, not a curve, or a foreign schema; names the member
CurveDocument curve_from_json(std::string_view text, const std::string& path);
CurveDocument read_curve(const std::string& path);

/// The curve in space: planar ones at z = 0, functions as (x, y, 0) with the Greville abscissae as x.
/// \throws InvalidInput  more than three components
Curve curve_in_space(const CurveDocument& document);

/// Writes one edge as write_cad writes a face: beside the target, read back with OpenCASCADE, compared, renamed.
/// \param curve  in R^3, continuous
/// \throws InvalidInput  not in R^3, a jump, a single point; FileError, WriteError as write_file
void write_cad_curve(const std::string& path, const Curve& curve, const CadOptions& options, bool force);
/// The B-spline curves of a STEP or IGES file that belong to no face, in the unit asked for.
/// \throws FileError  unreadable, or none in it that is not rational
std::vector<Curve> read_cad_curves(const std::string& path, CadUnit unit = CadUnit::millimetre);

}  // namespace knotfit
