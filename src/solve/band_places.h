// Where the functions of an axis stand in a band matrix.
#pragma once
#include "solve/axis.h"
namespace knotfit {

/// Those of a period are numbered from both sides of the seam in turn, so that neighbours on the ring are at most
/// 2 degree + 1 apart.
class BandPlaces {
 public:
  explicit BandPlaces(const Axis& axis)
      : n_(axis.functions()),
        bandwidth_(axis.is_periodic() ? 2 * axis.degree() + 1 : axis.degree()),
        ring_(axis.is_periodic()) {}
  Index operator()(Index function) const {
    if (!ring_) return function;
    return 2 * function < n_ ? 2 * function : 2 * (n_ - 1 - function) + 1;
  }
  Index bandwidth() const { return bandwidth_; }

 private:
  Index n_, bandwidth_;
  bool ring_;
};

}  // namespace knotfit
