// Clouds and meshes of many points: a sample is mapped and fitted, all points are judged [METHOD 8.15].
#pragma once
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "knotfit/fit_mesh.h"
#include "knotfit/parameterize_cloud.h"
namespace [[gnu::visibility("default")]] knotfit {

/// What a sample is taken of.
struct SampleSource {
  std::vector<double> points;  ///< n x 3, row-major: all of them are judged
  /// The map of some of the points (of others besides, where a mesh cannot do without). Its mesh's vertex_line are numbers in
  /// `points`, from 1; 0: no point.
  /// \param points  these points  \param index  of some, from 0, rising
  std::function<CloudMap(std::span<const double> points, std::span<const Index> index)> map = {};
  std::shared_ptr<const Mesh> mesh =
      {};  ///< whose vertices they are, with vertex_line as above; none: a cloud
};

/// Of a cloud. \param lay  lays some of the points over a base, as parameterize_cloud() does; their numbers are `index`
SampleSource cloud_source(
    std::vector<double> points,
    std::function<CloudMap(std::span<const double> points, std::span<const Index> index)> lay);

/// Of a mesh that is a disk: its vertices that are data. For a sample of them the others are taken out by collapsing edges, but
/// for those on the border and of virtual faces. \param map  of the mesh that is left, as parameterize_mesh() makes it
SampleSource mesh_source(const Mesh& mesh, std::function<MeshMap(const Mesh&)> map);

/// The map of a sample, even in space and with the outline of the points.
/// \param most  points of the sample, > 3
/// \param also  points that it has besides, from 0
/// \throws InvalidInput  what the source's map throws; coordinates that are no points in space, one not finite
CloudMap map_sample(const SampleSource& source, Index most, std::span<const Index> also = {});

struct SampleFit {
  CloudMap map;  ///< the last: with the points that joined
  /// Points, errors, distances and the verdict are of all points: those of the map first, then the others, whose parameters
  /// are those of their closest points. `correction` but for its distances is of the map; `to_mesh` is of the whole mesh, and
  /// of clouds not measured.
  MeshFit fit;
  int rounds = 1;  ///< fits made: one and the exchanges
};

/// Fits the map of a sample by fit_mesh(), finds the closest points of all others, and judges by all. Where the tolerance
/// holds on the sample and not for all, the worst of the others join the sample, which is mapped and fitted anew; where the
/// tolerance is an RMS error or a percentile, it is tightened by what is missing. At most four times; the best by the error
/// of all is kept.
/// \param map  map_sample() of this source with `most`
/// \throws InvalidInput  see map_sample(), fit_mesh()
SampleFit fit_sample(const SampleSource& source, Index most, CloudMap map, const FitOptions& options,
                     const CorrectionOptions& correction = {}, const Control& control = {});

}  // namespace knotfit
