// Parameters of ordered points of a curve.
#pragma once
#include <span>

#include "knotfit/curve_points.h"
#include "knotfit/parameterize.h"
#include "knotfit/source_data.h"
namespace [[gnu::visibility("default")]] knotfit {

/// t by the distances between neighbours as the spacing's rule takes them [Piegl97 9.2.1], 0 at the first point and 1
/// at the last; closed: back at the first, which must not be given again (it is dropped where it is).
/// \param values  n x dimension, row-major
/// \throws InvalidInput  fewer than 2 points (closed: 3), no length, a value that is not finite
CurvePoints parameterize_curve(std::span<const double> values, int dimension,
                               RowSpacing spacing = RowSpacing::chord, bool closed = false);

/// Of a table (x, y; x, y, z; with weights) or of one row of points. A table of x, y alone is planar.
/// \param function  y over x: t from x, which must increase
/// \throws InvalidInput  as above; a raster or a mesh; several rows
CurvePoints curve_points_of(const SourceData& data, RowSpacing spacing = RowSpacing::chord,
                            bool closed = false, bool function = false);

}  // namespace knotfit
