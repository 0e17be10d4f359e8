#include "search/noise_plateau.h"

#include <cmath>
namespace knotfit {

NoisePlateau::NoisePlateau(double noise, Index points, int dimension)
    : level_(noise * std::sqrt(static_cast<double>(dimension))), points_(static_cast<double>(points)) {}

bool NoisePlateau::add(Index control_points, double rms) {
  const double size = static_cast<double>(control_points);
  // White noise of N points keeps a share (N - n)/N of its squares beside n control points.
  const bool flat = level_ > 0 && last_size_ > 0 && size > last_size_ && rms < 1.5 * level_ &&
                    rms > 0.97 * last_rms_ * std::sqrt((points_ - size) / (points_ - last_size_));
  flat_ = flat ? flat_ + 1 : 0;
  last_size_ = size;
  last_rms_ = rms;
  return flat_ >= 2;
}

}  // namespace knotfit
