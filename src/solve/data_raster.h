// What the data says of itself about every place: the weights and goals of the data energy [METHOD 5.1].
#pragma once
#include <vector>

#include "data/indexed_points.h"
#include "knotfit/curve_points.h"
namespace knotfit {

/// Piecewise constant on side_u x side_v cells of [0,end_u] x [0,1], cell (i, j) at i * side_v + j.
struct DataRaster {
  enum Kind { kUu, kUv, kVv, kU, kV };
  static constexpr int kKinds = 5;

  int dimension = 0;
  Index side_u = 0, side_v = 0;
  double end_u = 1;
  std::vector<double> weight;  ///< a cell: 5 weights
  std::vector<double> goal;    ///< a cell: 5 x dimension derivatives wanted, times their weights
  std::vector<double> spacing_u, spacing_v;  ///< a cell: distance of neighbouring points

  DataRaster(int dimension_, Index side_u_, Index side_v_, double end_u_);
  Index cells() const { return side_u * side_v; }
};

/// \param points  valid
/// \param scale   t > 0: errors of this size are all the same to the caller
DataRaster data_raster(const ParameterizedPoints& points, double scale,
                       std::shared_ptr<const IndexedPoints> indexed = {});

/// Of the strip of a curve (strip.h), which holds every point twice: weights are twice those of the curve. Of a closed curve
/// two periods, [0,2].
DataRaster strip_raster(const CurvePoints& points, double scale);

}  // namespace knotfit
