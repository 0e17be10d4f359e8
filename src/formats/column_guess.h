// Columns that nothing names, by their values: taken where these allow one reading only.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "formats/columns.h"
namespace knotfit {

/// What is seen of the values of every column, row by row.
class ColumnValues {
 public:
  explicit ColumnValues(Index columns) : of_(static_cast<std::size_t>(columns)) {}
  /// \param row  one number a column; NaN: missing
  void take(std::span<const double> row);
  Index columns() const { return static_cast<Index>(of_.size()); }
  Index rows() const { return rows_; }

  bool within(std::size_t column, double least, double most) const;
  bool whole(std::size_t column) const { return of_[column].whole; }
  bool constant(std::size_t column) const { return of_[column].least == of_[column].most; }
  double most(std::size_t column) const { return of_[column].most; }
  /// From row to row one more, as a number of the point is.
  bool counts(std::size_t column) const { return rows_ >= 8 && of_[column].counts; }
  /// The three columns from here on are unit vectors (to 2 %), or 0, 0, 0.
  bool unit_vectors(std::size_t column) const { return of_[column].vectors > 0 && of_[column].unit; }

 private:
  struct Column {
    double least = 0, most = 0, last = 0;
    bool seen = false, whole = true, counts = true, unit = true;
    Index vectors = 0;
  };
  std::vector<Column> of_;
  Index rows_ = 0;
};

/// The columns of these values: x, y, z first, then what the rest can be. Three are x, y, z; four have an intensity;
/// what follows may be parameters in [0,1], a weight above 0, colours (whole numbers, or beyond [0,1]), normals.
/// \param any_parameters  parameters may have any range
struct GuessedColumns {
  Columns columns;  ///< empty where the values allow none, or more than one, reading
  std::string why;  ///< then: what is open, and the columns of each reading
};
GuessedColumns guess_columns(const ColumnValues& values, bool any_parameters);

}  // namespace knotfit
