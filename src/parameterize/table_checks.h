// What every parameterization asks of a table, and how its messages name a point.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "knotfit/points.h"
#include "knotfit/source_data.h"
namespace knotfit::parameterize {

/// "line 14", or "point 14" where the source has no lines; k from 0.
std::string point_name(const std::vector<Index>& line, Index k);

/// "lines 7, 32 and 57"; of more than ten the first eight and how many more. Points likewise.
std::string point_names(const std::vector<Index>& line, std::span<const Index> points);

/// \throws InvalidInput  no points, columns of different lengths, a value that is not finite, a weight <= 0
void check_table(const PointTable& table);

/// Least and largest value of a column that must have an extent.
struct Range {
  double low = 0, high = 0;
};
/// \throws InvalidInput  the range is beyond what a double can hold
Range range_of(const std::vector<double>& column, const char* name);

/// \param values  n x dimension
/// \param line  of each point in its file; empty: its number is told
/// \throws InvalidInput  some points stand so far from the others that these look like one place; names them
void check_strays(std::span<const double> values, int dimension, const std::vector<Index>& line);

/// \throws InvalidInput  all points lie on one straight line in the plane of their two columns: their
///   distance from it is below 1e-5 of the box (files of six digits round by that much), or a range is empty; a stray
void check_plane(const std::vector<double>& a, const std::vector<double>& b, const char* name_a,
                 const char* name_b, const std::vector<Index>& line);

}  // namespace knotfit::parameterize
