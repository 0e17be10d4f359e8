// The data's own values between its points, at many places: what a surface is held against.
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "data/indexed_points.h"
#include "verify/local_reference.h"
#include "verify/net_coordinates.h"
namespace knotfit::verify {

using Place = std::array<double, 2>;

/// References and error bars by the plain metric, and where that is unsure by the coordinates of an
/// error-model net too [METHOD 5.3]. Threaded over places; the same for any number of threads.
class ReferenceField {
 public:
  /// \param tolerance  what the error bars are held against: noise below 0.02 of it is none, and bars above
  ///   a quarter of it ask the second metric
  /// \param metric_u, metric_v  interior knots of an error-model net; both empty: no second metric
  /// \param indexed  the points, where they are; null: made here
  ReferenceField(const ParameterizedPoints& points, double tolerance, std::span<const double> metric_u,
                 std::span<const double> metric_v, unsigned long long seed,
                 std::shared_ptr<const IndexedPoints> indexed = {});

  double noise() const { return noise_; }  ///< standard deviation in force; 0: none
  const DistinctPoints& points() const { return points_; }
  const Neighbours& neighbours() const { return plain_; }
  /// \param go_on  called between batches with the places done; false stops. May be empty
  /// \return a value a place, or nothing where it was stopped
  std::vector<ReferenceValue> at(std::span<const Place> places,
                                 const std::function<bool(Index done)>& go_on = {}) const;

 private:
  double tolerance_;
  const Neighbours& mapped() const;  ///< made when first asked for

  std::shared_ptr<const IndexedPoints> indexed_;
  const DistinctPoints& points_;
  const Neighbours& plain_;
  NetCoordinate xi_, eta_;
  bool two_metrics_;
  mutable std::once_flag mapped_once_;
  mutable std::unique_ptr<Neighbours> mapped_;
  double noise_ = 0;
};

}  // namespace knotfit::verify
