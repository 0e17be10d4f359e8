// Index to int for interfaces that count in int (LAPACK): an overflow is an error, not a wrap.
#pragma once
#include <limits>

#include "knotfit/exceptions.h"
#include "knotfit/index.h"
namespace knotfit {
inline int narrow(Index value) {
  if (value > std::numeric_limits<int>::max() || value < std::numeric_limits<int>::min())
    throw InvalidInput("a count of " + std::to_string(value) +
                       " is beyond what the linear algebra can index; ask for fewer control points");
  return static_cast<int>(value);
}
}  // namespace knotfit
