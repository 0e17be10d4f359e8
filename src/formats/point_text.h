// Points in text, a line a point: what tables and rows have in common.
#pragma once
#include <vector>

#include "formats/columns.h"
#include "formats/file_bytes.h"
#include "formats/text_lines.h"
#include "knotfit/io.h"
#include "knotfit/source_data.h"
namespace knotfit {

struct PointText {
  PointTable table;                ///< may hold NaN and Inf: see the three lines below
  std::vector<Role> roles;         ///< of each column of the file
  std::vector<std::string> told;   ///< the same for reports: "x", "intensity", "-"
  std::string columns_from;        ///< what told them: "option", "header", "guess"
  std::vector<std::string> notes;  ///< what was left out before the points, a sentence each
  std::vector<Index> group_start;  ///< first point of each group of lines without a blank line between
  bool header = false;             ///< a line (not a comment) names the columns
  Separator separator = Separator::blanks;
  TextLine not_finite;         ///< the first line with NaN or Inf; number 0: none
  TextLine broken;             ///< the first such line that is no hole (x, y and z all NaN)
  std::vector<Index> missing;  ///< points with the nodata value: x, y, z are NaN
  Index joins = 0;             ///< points of the upper surface of an airfoil to be joined; 0: it is none
};

/// Reads every line, or those of one block. Table entries of points with the nodata value are NaN in x, y and z.
/// \throws FileError  no points, a wrong number of columns, text that is no number: names the line; several blocks of
///   a curve and none chosen
PointText parse_point_text(const FileBytes& file, const ReadOptions& options);

/// \throws FileError  always: names line and column of the first NaN or Inf of the line
[[noreturn]] void refuse_not_finite(const FileBytes& file, const PointText& points, const TextLine& line);

/// The points as a table; those with the nodata value are left out and counted.
/// \throws FileError  NaN or Inf, or no point left
SourceData table_of(const FileBytes& file, PointText&& points, const ReadOptions& options);
/// The points as rows; those with the nodata value, or NaN in x, y and z, are holes.
/// \throws FileError  columns other than x, y, z; Inf, or a point that is NaN in part
SourceData rows_of(const FileBytes& file, PointText&& points);

}  // namespace knotfit
