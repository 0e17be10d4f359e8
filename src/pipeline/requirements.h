// What a fit asks of its input, in words a user can act on.
#pragma once
#include <string>
#include <vector>

#include "knotfit/fit_surface.h"
namespace knotfit {

/// \throws InvalidInput  points that no surface runs through: all equal, on one line, of one parameter; fewer
///   than the control points; degrees out of range
void check_requirements(const ParameterizedPoints& points, const FitOptions& options);

/// \throws InvalidInput  fewer control points than one patch of these degrees has
void check_least_size(Index size_u, Index size_v, int degree_u, int degree_v);

/// The tolerance asked for, absolute. \param rounding  half an ulp of the largest coordinate
/// \throws InvalidInput  not positive, below rounding, relative to a range of nothing
Tolerance absolute_tolerance(const ToleranceRequest& request, const ParameterizedPoints& points,
                             double diagonal, double rounding);

/// A note where points share parameters: least squares goes between them.
void note_duplicates(const ParameterizedPoints& points, std::vector<std::string>& notes);

}  // namespace knotfit
