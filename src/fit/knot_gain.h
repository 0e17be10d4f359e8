// What one more knot would gain.
#pragma once
#include <vector>

#include "fit/moving_fit.h"
namespace knotfit {

/// For every span of one direction: gain = sum_j (sum w r phi B_j)^2 / sum w (phi B_j)^2 over the
/// components, phi the function of the refined space centred on a new knot at the span's middle
/// [METHOD 3.3]. One pass over the points. Spans of no length gain 0.
/// Where no fit ever succeeded, the lengths of the spans.
std::vector<double> knot_gains(const MovingFit& fitted, bool along_v);

}  // namespace knotfit
