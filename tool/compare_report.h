// The folder that a comparison leaves behind.
#pragma once
#include <string>
#include <vector>

#include "input.h"
#include "knotfit/compare.h"
#include "knotfit/comparison_picture.h"
namespace knotfit::tool {

/// Rows, surfaces and pictures as files of one folder, each written whole:
///   table.csv table.json     every row
///   errors.svg errors.png    error against control points
///   maps-SIZE.svg .png       every method at one size or tolerance
///   maps/METHOD-SIZE.svg .png  one method, in the colour scale of its size
///   surfaces/METHOD-SIZE.json
class CompareFolder {
 public:
  /// Makes the folder where it is missing. \throws FileError  no such parent, no permission, a table is there and not
  /// force
  CompareFolder(std::string path, bool force);
  /// A row that ended: its surface, and the tables with it.
  void add(const CompareRow& row, const FitInput& input, const std::string& options);
  /// The pictures of all rows so far.
  void draw(const FitInput& input) const;
  const std::vector<CompareRow>& rows() const { return rows_; }
  std::string file(const std::string& name) const;

 private:
  void write(const std::string& name, const std::string& text) const;
  std::string path_;
  std::vector<CompareRow> rows_;
};

/// "12x12" or "0.1%", for names of files and rows.
std::string asked_text(const CompareRow& row);
/// RMS error against control points, a series a method in the order of the rows; rows without an error are left out.
std::vector<ErrorSeries> error_series(const std::vector<CompareRow>& rows);
/// The table as it is printed: a row a line, columns aligned.
std::string compare_table(const std::vector<CompareRow>& rows);
std::string compare_csv(const std::vector<CompareRow>& rows);
/// \param input  named in it
std::string compare_json(const std::vector<CompareRow>& rows, const FitInput& input, bool stopped);

}  // namespace knotfit::tool
