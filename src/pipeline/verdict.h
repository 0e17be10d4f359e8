// The verdict on a surface: its status, and the note that leads where it swings.
#pragma once
#include <string>
#include <string_view>

#include "knotfit/fit_surface.h"
namespace knotfit {

/// Status, measured and reached from the rechecked errors and the swings. One order where several apply: failed, stopped,
/// time_limit, swings, folded, tolerance_below_noise, limit_reached, data_too_sparse, not_reached.
/// \param searched        how the search ended; fixed_size without one
/// \param with_tolerance  one was asked
/// \param search          sizes were searched
void judge(FitResult& result, const ParameterizedPoints& points, Status searched, bool with_tolerance,
           bool search);

/// Of a fixed size that the data energy holds. \param before  the largest swing of its least squares
/// \param left  the largest that is left \param what  "surface" or "curve"
std::string held_note(double before, double left, std::string_view what);

/// What a user should know of the swings, first of all notes; nothing where there are none.
void note_swings(FitResult& result);

}  // namespace knotfit
