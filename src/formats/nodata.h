// Values that stand for "no data here".
#pragma once
#include <cmath>
namespace knotfit {

/// NaN as nodata stands for every NaN. Large values (-3.4028235e38 in rasters) pass through single
/// precision on their way into a file, so that they are compared there.
inline bool is_nodata(double value, double nodata) {
  if (value == nodata) return true;
  if (std::isnan(nodata)) return std::isnan(value);
  return std::abs(nodata) > 1e30 && std::isfinite(nodata) &&
         std::abs(value - nodata) <= 1e-5 * std::abs(nodata);
}

}  // namespace knotfit
