// The cells of a uniform grid.
#pragma once
#include <algorithm>

#include "knotfit/index.h"
namespace knotfit {

/// The cell, of `cells` equal ones over [0,1], that holds x; 1 lies in the last.
inline Index uniform_cell(double x, Index cells) {
  return std::min(cells - 1, static_cast<Index>(x * static_cast<double>(cells)));
}

}  // namespace knotfit
