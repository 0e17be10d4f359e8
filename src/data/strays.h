// Points that stand far from all others: slips of a scanner, numbers that stand for missing data.
#pragma once
#include <span>
#include <vector>

#include "knotfit/index.h"
namespace knotfit {

/// Points that stand at least 1000 times as far from the middle (the median of each coordinate) as the farthest of
/// the others: so far that these look like one place from there. At most one in 20, ascending; none of fewer than 5,
/// nor, in one dimension, beside others that are all equal.
/// \param values  n x dimension, finite
std::vector<Index> far_strays(std::span<const double> values, int dimension);

}  // namespace knotfit
