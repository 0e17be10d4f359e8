// The data with equal parameters merged, laid out in strips for the neighbour search.
#pragma once
#include <cstdint>
#include <vector>

#include "knotfit/points.h"
namespace knotfit {

/// Points of distinct parameters, sorted by (u, v). Points of equal parameters are one point here:
/// their weighted mean, with the sum of their weights.
struct DistinctPoints {
  int dimension = 1;
  std::vector<double> u, v;
  std::vector<double> values;      ///< size() x dimension
  std::vector<double> weights;     ///< over the mean weight of the data; empty: all 1
  std::vector<Index> strip_start;  ///< strips + 1 offsets; a strip's points have larger u than those before
  std::vector<std::uint32_t> of;   ///< of each point given, its distinct point
  Index size() const { return static_cast<Index>(u.size()); }
  const double* value(Index k) const { return values.data() + k * dimension; }
};

/// O(N log N), the same result for any number of threads.
/// \param points  valid
DistinctPoints distinct_points(const ParameterizedPoints& points);

}  // namespace knotfit
