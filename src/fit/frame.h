// The frame computations run in: centred and scaled once inside, undone once outside.
#pragma once
#include <vector>

#include "knotfit/points.h"
#include "knotfit/surface.h"
namespace knotfit {

/// x -> (x - centre) / scale, scale a power of two: scaling is exact, and so is centring up to half
/// an ulp of the data.
class Frame {
 public:
  explicit Frame(const ParameterizedPoints& points);
  double scale() const { return scale_; }
  ParameterizedPoints inside(const ParameterizedPoints& points) const;
  Surface outside(const Surface& surface) const;
  /// Half an ulp of the largest coordinate: no surface in double precision is nearer than that.
  double rounding() const { return rounding_; }

 private:
  std::vector<double> centre_;
  double scale_ = 1, rounding_ = 0;
};

}  // namespace knotfit
