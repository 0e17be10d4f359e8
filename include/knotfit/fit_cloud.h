// Clouds of many points: a sample is mapped and fitted, all points are judged [METHOD 8.15].
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "knotfit/fit_mesh.h"
#include "knotfit/parameterize_cloud.h"
namespace [[gnu::visibility("default")]] knotfit {

struct CloudSource {
  std::span<const double> points;  ///< n x 3, row-major
  /// Lays some of the points over a base, as parameterize_cloud() does.
  /// \param index  of these points, from 0, rising
  std::function<CloudMap(std::span<const double> points, std::span<const Index> index)> lay;
};

/// The map of a sample, even in space and with the outline of the cloud. Its mesh's vertex_line are numbers in the whole
/// cloud, from 1.
/// \param most  points of the sample, > 3
/// \param also  points that it has besides, from 0
/// \throws InvalidInput  what `lay` throws; coordinates that are no points in space, one not finite
CloudMap map_sample(const CloudSource& cloud, Index most, std::span<const Index> also = {});

struct CloudFit {
  CloudMap map;  ///< the last: with the points that joined
  /// Points, errors, distances and the verdict are of all points of the cloud: those of the map first, then the others, whose
  /// parameters are those of their closest points. `correction` without its distances, and `to_mesh`, are of the map.
  MeshFit fit;
  int rounds = 1;  ///< fits made: one and the exchanges
};

/// Fits the map of a sample by fit_mesh(), finds the closest points of all others, and judges by all. Where the tolerance
/// holds on the sample and not for all, the worst of the others join the sample, which is mapped and fitted anew; where the
/// tolerance is an RMS error or a percentile, it is tightened by what is missing. At most four times; the best by the error
/// of all is kept.
/// \param map  map_sample() of this cloud with `most`
/// \throws InvalidInput  see map_sample(), fit_mesh()
CloudFit fit_cloud(const CloudSource& cloud, Index most, CloudMap map, const FitOptions& options,
                   const CorrectionOptions& correction = {}, const Control& control = {});

}  // namespace knotfit
