// Further routes after a first one: the better of two results, and how the later ones are shown.
#pragma once
#include "knotfit/refine.h"
namespace knotfit {

/// Of two results the better, with the fits and sizes of both: the one that reached with fewer control points, else one that
/// does not swing, else the least error. A stop of either stays the status, and a time limit that cut the first short, or a further route
/// where neither holds. \param a  of the search itself
RefineResult better_of(RefineResult a, RefineResult b);

/// The control of a further route: its progress shows the best of an earlier one while that is better.
Control after(const RefineResult& earlier, const Control& control);

}  // namespace knotfit
