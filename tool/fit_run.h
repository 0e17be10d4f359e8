// A fit from choices to a result: what the tool and the Python package share.
#pragma once
#include <optional>
#include <vector>

#include "input.h"
#include "knotfit/fit_mesh.h"
#include "knotfit/fit_surface.h"
#include "options.h"
namespace knotfit::tool {

/// What a caller in memory gives where the choices name files.
struct FitExtras {
  FeatureMap features{};  ///< in place of FitChoices::feature_file, over [0,1]^2; empty: none
};

struct FitRun {
  FitResult result;
  MeshFit corrected;          ///< its result moved to `result`
  bool is_corrected = false;  ///< parameters were corrected
  const MeshFit* correction() const { return is_corrected ? &corrected : nullptr; }
};

/// Fills in the defaults of what is open. \return no tolerance, size or knots were given: the usual tolerance counts
/// \throws InvalidInput  an unknown method
bool complete_choices(Arguments& arguments);

/// Rounds of parameter correction; 0: none. \throws InvalidInput  a correction that the input or other choices do not allow
int correction_rounds(const FitChoices& choices, const FitInput& input);

/// Fits as the choices say, and judges all points of the input. The points of `input` become those of the result.
/// \param choices  completed
/// \throws InvalidInput  without the input's name
FitRun fit_input(FitInput& input, const FitChoices& choices, const FitExtras& extras, const Control& control);

/// The error of every point of the input: also of those that were merged or that no triangle has.
std::vector<double> errors_of_all(const FitResult& result, const FitInput& input);
/// Those points, in the same order.
ParameterizedPoints points_of_all(const FitInput& input);

}  // namespace knotfit::tool
