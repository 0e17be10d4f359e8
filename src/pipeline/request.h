// What is asked of a fit, checked in words a user can act on: requirements of the input, tolerance, frame.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "data/indexed_points.h"
#include "fit/frame.h"
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

/// The tolerance of a call.
struct Request {
  bool searched = false;  ///< neither a size nor knots are given: sizes are searched
  double diagonal = 0;    ///< the unit of a relative tolerance
  Tolerance asked;        ///< absolute; value 0: none
  Tolerance inside;       ///< in the frame, with room for the way out of it
  bool with_tolerance() const { return asked.value > 0; }
};

/// \param unit  of the frame that the computations run in
/// \throws InvalidInput  neither a tolerance nor a size nor knots; see absolute_tolerance()
Request make_request(const std::optional<ToleranceRequest>& tolerance, bool size_or_knots,
                     const ParameterizedPoints& points, double rounding, double unit);

inline bool has_size_or_knots(const FitOptions& o) {
  return o.knots || o.control_points_u > 0 || o.control_points_v > 0;
}

/// A note where points share parameters: least squares goes between them.
void note_duplicates(const IndexedPoints& points, std::vector<std::string>& notes);

}  // namespace knotfit
