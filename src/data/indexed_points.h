// Points made ready for all who look about a place: made once a call and handed on.
#pragma once
#include <memory>

#include "data/distinct_points.h"
#include "data/neighbours.h"
namespace knotfit {

struct IndexedPoints {
  DistinctPoints distinct;
  Neighbours neighbours;  ///< of the distinct points, in (u, v)

  /// \param points  valid
  explicit IndexedPoints(const ParameterizedPoints& points)
      : distinct(distinct_points(points)), neighbours(plain_neighbours(distinct)) {}
};

/// `given`, or one made of the points where that is null.
inline std::shared_ptr<const IndexedPoints> indexed_or(std::shared_ptr<const IndexedPoints> given,
                                                       const ParameterizedPoints& points) {
  return given ? std::move(given) : std::make_shared<const IndexedPoints>(points);
}

}  // namespace knotfit
