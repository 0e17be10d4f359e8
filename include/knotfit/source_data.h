// What a file holds before it has parameters.
#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "knotfit/index.h"
#include "knotfit/mesh.h"
namespace [[gnu::visibility("default")]] knotfit {

/// Heights on a regular grid; NaN is a hole. Row 0 is the north (largest y).
/// The value of column c, row r stands at the cell's centre:
/// x = x0 + (c + 0.5) dx, y = y0 + (rows - r - 0.5) dy.
struct Raster {
  Index columns = 0, rows = 0;
  double x0 = 0, y0 = 0;  ///< lower left corner of the lower left cell
  double dx = 1, dy = 1;  ///< cell size, > 0
  double nodata = -9999;  ///< value that stands for a hole in a file
  std::vector<double> z;  ///< rows x columns, row-major, NaN: hole
  double x(Index column) const { return x0 + (static_cast<double>(column) + 0.5) * dx; }
  double y(Index row) const { return y0 + (static_cast<double>(rows - row) - 0.5) * dy; }
};

/// Points with what columns the source had. Every present column has n entries.
struct PointTable {
  std::vector<double> x, y, z;     ///< z always present; x, y together or not at all
  std::vector<double> u, v;        ///< both or neither, as given (not yet checked or mapped)
  std::vector<double> weight;      ///< or empty
  std::vector<double> nx, ny, nz;  ///< normals of a scan, of any length; all three or none; 0, 0, 0: unknown
  std::vector<Index> line;         ///< line of each point in its file, from 1; empty: index
  Index size() const { return static_cast<Index>(z.size()); }
};

/// Ordered rows of points in space: a grid where all rows have the same length.
/// A point whose coordinates are NaN is a hole.
struct PointRows {
  std::vector<double> xyz;       ///< n x 3, row-major, row after row
  std::vector<Index> row_start;  ///< rows + 1 offsets into the points
  std::vector<Index> line;       ///< line of each point in its file; empty: none
  Index rows() const { return static_cast<Index>(row_start.size()) - 1; }
  Index size() const { return static_cast<Index>(xyz.size()) / 3; }
  /// Common length of all rows, or 0 where they differ.
  Index common_length() const {
    for (Index r = 1; r < rows(); ++r)
      if (row_start[r + 1] - row_start[r] != row_start[1] - row_start[0]) return 0;
    return rows() > 0 ? row_start[1] - row_start[0] : 0;
  }
};

/// What a reader returns.
struct SourceData {
  std::string path;    ///< as named by the user
  std::string format;  ///< "esri-ascii", "csv", "npy", "rows", "ply", "obj", "off", "stl", "las", "pcd"
  std::variant<Raster, PointTable, PointRows, Mesh> content;
  std::vector<std::string> notes = {};  ///< what a file says beside that, a sentence each: classes of points
  /// What each column of points was taken for: "x", "intensity"; "-": unknown and left out. Empty: the content is no
  /// points, or holds x, y, z alone by its format.
  std::vector<std::string> columns = {};
  std::string columns_from = {};  ///< what told it: "option", "header", "guess"
  Index left_out = 0;             ///< points that miss a value (ReadOptions::nodata)
};

}  // namespace knotfit
