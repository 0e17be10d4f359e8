// Spans in parallel where neighbours write to the same functions.
#pragma once
#include "base/parallel.h"
#include "solve/axis.h"
namespace knotfit {

/// Calls body(span) for all spans. Spans less than degree + 1 apart share functions, so every
/// (degree + 1)-th goes at once, in a fixed order of colours: the same sums for any threads.
template <class Body>
void for_spans_in_turn(const Axis& axis, const Body& body) {
  const int colours = axis.width();
  for (int colour = 0; colour < colours; ++colour) {
    const Index count = (axis.spans() - colour + colours - 1) / colours;
    if (count > 0) parallel_for(count, [&](Index i) { body(colour + i * colours); });
  }
}

}  // namespace knotfit
