// The frame computations run in: centred and scaled once inside, undone once outside.
#pragma once
#include <span>
#include <vector>

#include "base/vec3.h"
#include "knotfit/mesh.h"
#include "knotfit/points.h"
#include "knotfit/surface.h"
namespace knotfit {

/// x -> (x - centre) / scale, the centre that of the box around the data.
class Frame {
 public:
  /// The scale is a power of two, so that scaling is exact, and centring is up to half an ulp of the data. It is the least
  /// one that puts the points into [-1,1].
  explicit Frame(const ParameterizedPoints& points);
  /// The scale is the diagonal of the box around the corners of the faces.
  /// \throws InvalidInput  a mesh without extent, or with one that is no number
  explicit Frame(const Mesh& mesh);

  double scale() const { return scale_; }
  ParameterizedPoints inside(const ParameterizedPoints& points) const;
  std::vector<Vec3> inside(const Mesh& mesh) const;  ///< the vertices
  Surface inside(const Surface& surface) const;
  Surface outside(const Surface& surface) const;
  /// Half an ulp of the largest coordinate: no surface in double precision is nearer than that.
  double rounding() const { return rounding_; }

 private:
  std::vector<double> scaled(std::span<const double> values) const;

  std::vector<double> centre_;
  double scale_ = 1, rounding_ = 0;
};

}  // namespace knotfit
