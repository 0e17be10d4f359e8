// Parameters in [0,1]^2 for data that has none.
#pragma once
#include "knotfit/points.h"
#include "knotfit/source_data.h"
namespace [[gnu::visibility("default")]] knotfit {

enum class RowSpacing { chord, centripetal, uniform };
enum class DuplicateRule { fail, mean, lowest, highest };

/// z over x, y: u = (x - x0)/(x1 - x0) from the first to the last cell centre, likewise v.
/// Holes are left out; points row by row as in the file (north first).
/// \throws InvalidInput  fewer than 2 rows or columns, or no cell with data
ParameterizedPoints parameterize_height_field(const Raster& raster);

/// z over x, y of scattered points, u and v from their bounding box.
/// \throws InvalidInput  no x, y columns; all points equal or on one straight line in (x, y)
ParameterizedPoints parameterize_height_field(const PointTable& table);

/// x, y, z at the table's own u, v (or z alone where the table has no x, y).
/// \param rescale  map the range of u and v to [0,1] (kept in ParameterizedPoints::map);
///   without it a parameter outside [0,1] throws, naming its line
/// \throws InvalidInput  no u, v columns; the message names Remedy::height_field where x, y are there
ParameterizedPoints parameterize_given(const PointTable& table, bool rescale = false);

/// Rows of points: u along a row by the spacing's rule, v from row to row likewise. Rows of one
/// length make a grid, with the parameters of each direction averaged over its rows [Piegl97 9.3];
/// rows of different lengths keep their own u. A row or column that is one point, a pole (shorter than 1e-6 of the
/// longest), has no say in them: its points take those of the others, in rows of different lengths of their neighbour.
/// \throws InvalidInput  fewer than 2 rows, a row of fewer than 2 points, all rows of no length
ParameterizedPoints parameterize_rows(const PointRows& rows, RowSpacing spacing = RowSpacing::chord);

/// Points with equal parameters. fail: throws InvalidInput, naming the lines, where their values
/// differ by more than twice `tolerance` (<= 0: never); the others merge them into one point of
/// summed weight (mean), or keep the one of lowest or highest last component.
/// \return number of points dropped
Index settle_duplicates(ParameterizedPoints& points, DuplicateRule rule, double tolerance);

}  // namespace knotfit
