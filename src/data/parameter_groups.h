// The points of a curve in the order of their parameters, those of equal ones together.
#pragma once
#include <span>
#include <vector>

#include "knotfit/index.h"
namespace knotfit {

struct ParameterGroups {
  std::vector<Index> order;  ///< n, numbers of points, t rising; of equal t in their own order
  std::vector<Index> start;  ///< groups + 1 offsets into `order`
  Index size() const { return static_cast<Index>(start.size()) - 1; }
  std::span<const Index> group(Index g) const {
    return std::span(order).subspan(start[g], start[g + 1] - start[g]);
  }
};

/// \param t  n >= 0 parameters
ParameterGroups group_by_parameter(std::span<const double> t);

}  // namespace knotfit
