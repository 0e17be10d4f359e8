// Where more control points only follow the noise.
#pragma once
#include "knotfit/index.h"
namespace knotfit {

/// The residual's RMS only follows the noise: two sizes in a row gain no more than control points
/// gain on white noise, near the noise level found in the data [METHOD 4.8].
class NoisePlateau {
 public:
  NoisePlateau(double noise, Index points, int dimension);
  /// \return true where the sizes so far say so
  bool add(Index control_points, double rms);

 private:
  double level_, points_;
  double last_size_ = 0, last_rms_ = 0;
  int flat_ = 0;
};

}  // namespace knotfit
