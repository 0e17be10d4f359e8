// Surfaces whose ends are knots of full multiplicity.
#pragma once
#include "knotfit/surface.h"
namespace knotfit {

/// The same surface over the same domain with clamped knots: knots outside the domain are gone.
Surface clamped(const Surface& s);

}  // namespace knotfit
