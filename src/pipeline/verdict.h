// The verdict on a surface or a curve: its status, and the notes on how it keeps to its data.
#pragma once
#include <functional>
#include <string>
#include <string_view>

#include "knotfit/fit_surface.h"
namespace knotfit {

/// What a status follows from, all of it measured apart from the fit.
struct Findings {
  Status searched = Status::fixed_size;  ///< how the search ended; fixed_size without one
  bool search = false;                   ///< sizes were searched
  bool with_tolerance = false;
  bool holds = false;  ///< the tolerance, at the points
  bool swings = false, folded = false;
};

/// One order where several apply: stopped or time_limit, swings, folded, reached, then what the search says.
Status status_of(const Findings& findings);

/// Status, measured and reached of a surface, from the rechecked errors and the swings.
void judge(FitResult& result, const ParameterizedPoints& points, Status searched, bool with_tolerance,
           bool search);

/// Of a fixed size that the data energy holds. \param before  the largest swing of its least squares
/// \param left  the largest that is left \param what  "surface" or "curve"
std::string held_note(double before, double left, std::string_view what);

/// Where and how far it swings, without a remedy. \param place  a place of the parameters in the user's words
std::string swing_text(const SwingReport& swings, double diagonal, std::string_view what,
                       const std::function<std::string(double u, double v)>& place);

/// What a user should know of a surface's swings, first of all notes; nothing where there are none.
void note_swings(FitResult& result);

}  // namespace knotfit
