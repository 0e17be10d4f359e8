// Delaunay triangulations of points on a fine grid, with exact predicates.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "knotfit/index.h"
namespace knotfit::cloud {

/// A place of the grid: coordinates from 0 to 2^kGridBits, so that every predicate fits 128 bits.
using Place = std::array<std::int64_t, 2>;
inline constexpr int kGridBits = 29;

struct Triangulation {
  std::vector<std::array<std::int32_t, 3>> triangle;  ///< counter-clockwise, covering the convex hull
  std::vector<std::array<std::int32_t, 3>> beside;    ///< triangle opposite each corner, -1: none
  std::vector<char> used;                             ///< a place each: 0 where an earlier place is the same
};

/// By insertion in the order of a space-filling curve [Bowyer81, Watson81]; the same for the same places. Empty
/// where all places are on one line.
Triangulation delaunay(const std::vector<Place>& places);

/// Sign of the area of (a, b, c): positive counter-clockwise.
std::int64_t area(const Place& a, const Place& b, const Place& c);

}  // namespace knotfit::cloud
