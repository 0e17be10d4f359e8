// Airfoils in Lednicer's form: the upper and the lower surface, each from the nose to the tail.
#pragma once
#include <string>

#include "formats/point_text.h"
#include "formats/text_lines.h"
namespace knotfit {

/// Lines of x and y: `upper` and then `lower` of them run from one nose to the tail, x never back by more than 1 % of
/// the chord.
bool is_lednicer(LineReader lines, Index upper, Index lower);

/// Joins the surfaces in the order of a closed profile: from the tail over the upper surface to the nose, and back below.
/// A nose that stands in both is there once. \return what was done, for a note
std::string join_lednicer(PointTable& table, Index upper);

}  // namespace knotfit
