// The k nearest points of a place: one k-d tree a strip of the domain.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "data/distinct_points.h"
namespace knotfit {

/// Strips are built at the same time, and a search leaves out those farther than what it has.
class Neighbours {
 public:
  /// \param x, y         coordinates of the points; strips in order of growing x
  /// \param strip_start  strips + 1 offsets into the points
  Neighbours(std::vector<double> x, std::vector<double> y, std::vector<Index> strip_start);
  ~Neighbours();
  Neighbours(Neighbours&&) noexcept;

  Index size() const { return static_cast<Index>(x_.size()); }
  double x(Index k) const { return x_[k]; }
  double y(Index k) const { return y_[k]; }
  /// The nearest points, nearest first; as many as `index` holds, or all there are.
  /// \return their number
  Index nearest(double x, double y, std::span<std::uint32_t> index, std::span<double> squared_distance) const;
  /// Distance to the nearest point.
  double gap(double x, double y) const;

 private:
  struct Strip;
  std::vector<double> x_, y_;
  std::vector<std::unique_ptr<Strip>> strips_;
};

/// Neighbours in the parameters themselves.
Neighbours plain_neighbours(const DistinctPoints& points);

}  // namespace knotfit
