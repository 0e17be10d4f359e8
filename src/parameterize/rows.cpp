#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "knotfit/exceptions.h"
#include "knotfit/parameterize.h"
#include "parameterize/row_parameters.h"
#include "parameterize/table_checks.h"
namespace knotfit {
namespace {

using parameterize::averaged_parameters;
using parameterize::cumulative_parameters;
using parameterize::point_name;
using parameterize::spacing_length;

constexpr double kHole = std::numeric_limits<double>::quiet_NaN();
constexpr Index kSections = 65;  // places along rows of different lengths at which they are compared

std::string row_name(const PointRows& rows, Index r) {
  const Index first = rows.row_start[r], last = rows.row_start[r + 1] - 1;
  if (rows.line.empty() || last < first) return fmt::format("row {}", r + 1);
  return fmt::format("row {} (lines {} to {})", r + 1, rows.line[first], rows.line[last]);
}

bool hole(const PointRows& rows, Index k) {
  return std::isnan(rows.xyz[3 * k]) || std::isnan(rows.xyz[3 * k + 1]) || std::isnan(rows.xyz[3 * k + 2]);
}

void check_rows(const PointRows& rows) {
  const Index n = rows.size();
  if (rows.rows() < 2)
    throw InvalidInput(
        fmt::format("{} rows of points: a surface needs at least 2", std::max<Index>(0, rows.rows())));
  if (rows.xyz.size() % 3 != 0 || rows.row_start.front() != 0 || rows.row_start.back() != n ||
      !std::is_sorted(rows.row_start.begin(), rows.row_start.end()))
    throw InvalidInput(fmt::format("row starts that do not run from 0 to the number of points, {}", n));
  if (!rows.line.empty() && static_cast<Index>(rows.line.size()) != n)
    throw InvalidInput(fmt::format("{} line numbers for {} points", rows.line.size(), n));
  for (Index r = 0; r < rows.rows(); ++r)
    if (rows.row_start[r + 1] - rows.row_start[r] < 2)
      throw InvalidInput(fmt::format("{} has {} points: a row needs at least 2", row_name(rows, r),
                                     rows.row_start[r + 1] - rows.row_start[r]));
  // Half of the largest double leaves room for differences, and 1/4 for the norm of three.
  constexpr double most = std::numeric_limits<double>::max() / 4;
  for (Index k = 0; k < n; ++k)
    for (int d = 0; d < 3 && !hole(rows, k); ++d)
      if (!(std::abs(rows.xyz[3 * k + d]) < most))
        throw InvalidInput(fmt::format("{}: coordinate {} is not finite or beyond what distances can hold",
                                       point_name(rows.line, k), rows.xyz[3 * k + d]));
}

[[noreturn]] void no_length(const PointRows& rows, Index r) {
  throw InvalidInput(fmt::format("{} has no length: all its points are equal", row_name(rows, r)));
}

void add_point(ParameterizedPoints& points, const PointRows& rows, Index k, double u, double v) {
  points.uv.push_back(u), points.uv.push_back(v);
  points.values.insert(points.values.end(), {rows.xyz[3 * k], rows.xyz[3 * k + 1], rows.xyz[3 * k + 2]});
  points.source.push_back(rows.line.empty() ? k + 1 : rows.line[k]);
}

// The part of a grid of points that holds all of its data.
struct Window {
  Index first_row = -1, last_row = -1, first_column = -1, last_column = -1;
};

Window data_window(const PointRows& rows, Index columns) {
  Window w;
  for (Index r = 0; r < rows.rows(); ++r)
    for (Index c = 0; c < columns; ++c) {
      if (hole(rows, r * columns + c)) continue;
      if (w.first_row < 0) w.first_row = r;
      w.last_row = r;
      w.first_column = w.first_column < 0 ? c : std::min(w.first_column, c);
      w.last_column = std::max(w.last_column, c);
    }
  if (w.first_row < 0) throw InvalidInput("every point of the rows is a hole");
  if (w.first_row == w.last_row || w.first_column == w.last_column)
    throw InvalidInput(
        "the points that are no holes lie in a single row or column: a surface needs at least 2 of each");
  return w;
}

// Lines of a grid that are one point, a pole: shorter than this share of the longest. Their noise would be read as
// parameters; that of single precision about a pole is 1e-7 of it.
constexpr double kPole = 1e-6;

// Sets the lengths of poles to 0, so that the other lines give their parameters.
void silence_poles(std::vector<double>& lengths, const std::vector<double>& chords, Index gaps) {
  if (gaps < 1) return;
  const Index lines = static_cast<Index>(chords.size()) / gaps;
  std::vector<double> length(static_cast<std::size_t>(lines), 0);
  for (Index k = 0; k < lines * gaps; ++k)
    if (!std::isnan(chords[k])) length[k / gaps] += chords[k];
  const double longest = lines > 0 ? *std::max_element(length.begin(), length.end()) : 0;
  for (Index k = 0; k < lines * gaps; ++k)
    if (!std::isnan(chords[k]) && length[k / gaps] <= kPole * longest) lengths[k] = 0;
}

ParameterizedPoints parameterize_grid(const PointRows& rows, Index columns, RowSpacing spacing) {
  const Window w = data_window(rows, columns);
  const auto lengths_of = [&](RowSpacing rule, bool of_rows) {
    std::vector<double> lengths;
    const auto add = [&](Index a, Index b) {
      lengths.push_back(hole(rows, a) || hole(rows, b)
                            ? (rule == RowSpacing::uniform ? 1 : kHole)
                            : spacing_length(&rows.xyz[3 * a], &rows.xyz[3 * b], rule));
    };
    if (of_rows) {
      for (Index r = w.first_row; r <= w.last_row; ++r)
        for (Index c = w.first_column; c < w.last_column; ++c) add(r * columns + c, r * columns + c + 1);
    } else {
      for (Index c = w.first_column; c <= w.last_column; ++c)
        for (Index r = w.first_row; r < w.last_row; ++r) add(r * columns + c, (r + 1) * columns + c);
    }
    return lengths;
  };
  std::vector<double> along = lengths_of(spacing, true), across = lengths_of(spacing, false);
  if (spacing != RowSpacing::uniform) {
    silence_poles(along, lengths_of(RowSpacing::chord, true), w.last_column - w.first_column);
    silence_poles(across, lengths_of(RowSpacing::chord, false), w.last_row - w.first_row);
  }
  const std::vector<double> u = averaged_parameters(along, w.last_column - w.first_column);
  const std::vector<double> v = averaged_parameters(across, w.last_row - w.first_row);
  if (u.empty())
    throw InvalidInput(
        "no two neighbouring points of a row, neither a hole, differ: the rows have no length");
  if (v.empty())
    throw InvalidInput(
        "no two neighbouring rows differ where both have points: there is no length from row to row");
  ParameterizedPoints points;
  for (Index r = w.first_row; r <= w.last_row; ++r)
    for (Index c = w.first_column; c <= w.last_column; ++c)
      if (!hole(rows, r * columns + c))
        add_point(points, rows, r * columns + c, u[c - w.first_column], v[r - w.first_row]);
  return points;
}

// One row without its holes, and the place on it at any u.
struct Row {
  std::vector<Index> point;
  std::vector<double> u;  // empty: the row is one point
  double length = 0;      // of its chords
};

Row own_parameters(const PointRows& rows, Index r, RowSpacing spacing) {
  Row row;
  for (Index k = rows.row_start[r]; k < rows.row_start[r + 1]; ++k)
    if (!hole(rows, k)) row.point.push_back(k);
  if (row.point.size() < 2)
    throw InvalidInput(fmt::format("{} has {} points that are no holes: a row needs at least 2",
                                   row_name(rows, r), row.point.size()));
  std::vector<double> lengths;
  for (std::size_t i = 1; i < row.point.size(); ++i) {
    const double *a = &rows.xyz[3 * row.point[i - 1]], *b = &rows.xyz[3 * row.point[i]];
    lengths.push_back(spacing_length(a, b, spacing));
    row.length += spacing_length(a, b, RowSpacing::chord);
  }
  row.u = cumulative_parameters(lengths);
  return row;
}

// A row that is one point goes with its neighbour: the same parameters where both have as many points.
void take_neighbours(const PointRows& rows, std::vector<Row>& own, RowSpacing spacing) {
  double longest = 0;
  for (const Row& row : own) longest = std::max(longest, row.length);
  if (spacing != RowSpacing::uniform)
    for (Row& row : own)
      if (row.length <= kPole * longest) row.u.clear();
  const std::vector<Row> given = own;
  const auto n = static_cast<Index>(own.size());
  for (Index r = 0; r < n; ++r) {
    if (!given[r].u.empty()) continue;
    Index from = -1;
    for (Index step = 1; step < n && from < 0; ++step) {
      if (r + step < n && !given[r + step].u.empty()) from = r + step;
      if (r - step >= 0 && !given[r - step].u.empty() && from < 0) from = r - step;
    }
    if (from < 0) no_length(rows, r);
    const std::vector<double>& u = given[from].u;
    const auto count = static_cast<Index>(own[r].point.size()), last = static_cast<Index>(u.size()) - 1;
    for (Index i = 0; i < count; ++i) {
      const double at = static_cast<double>(i * last) / static_cast<double>(count - 1);
      const Index k = std::min(static_cast<Index>(at), last - 1);
      own[r].u.push_back(std::lerp(u[k], u[k + 1], at - static_cast<double>(k)));
    }
  }
}

std::vector<double> place_on(const PointRows& rows, const Row& row, double u) {
  const auto above = std::upper_bound(row.u.begin(), row.u.end() - 1, u);
  const std::size_t i = std::max<std::size_t>(1, static_cast<std::size_t>(above - row.u.begin()));
  const double width = row.u[i] - row.u[i - 1], t = width > 0 ? (u - row.u[i - 1]) / width : 0;
  std::vector<double> place(3);
  for (int d = 0; d < 3; ++d)
    place[d] = (1 - t) * rows.xyz[3 * row.point[i - 1] + d] + t * rows.xyz[3 * row.point[i] + d];
  return place;
}

ParameterizedPoints parameterize_ragged(const PointRows& rows, RowSpacing spacing) {
  std::vector<Row> own;
  for (Index r = 0; r < rows.rows(); ++r) own.push_back(own_parameters(rows, r, spacing));
  take_neighbours(rows, own, spacing);
  // Places between points carry their rounding: distances below it are none.
  double rounding = 0;
  for (double x : rows.xyz)
    if (!std::isnan(x))
      rounding = std::max(rounding, 8 * std::numeric_limits<double>::epsilon() * std::abs(x));
  std::vector<double> across;
  for (Index s = 0; s < kSections; ++s) {
    const double u = static_cast<double>(s) / static_cast<double>(kSections - 1);
    std::vector<double> before = place_on(rows, own[0], u);
    for (std::size_t r = 1; r < own.size(); ++r) {
      std::vector<double> here = place_on(rows, own[r], u);
      const bool apart = spacing_length(before.data(), here.data(), RowSpacing::chord) > rounding;
      across.push_back(
          apart || spacing == RowSpacing::uniform ? spacing_length(before.data(), here.data(), spacing) : 0);
      before.swap(here);
    }
  }
  const std::vector<double> v = averaged_parameters(across, rows.rows() - 1);
  if (v.empty()) throw InvalidInput("all rows are equal: there is no length from row to row");
  ParameterizedPoints points;
  for (std::size_t r = 0; r < own.size(); ++r)
    for (std::size_t i = 0; i < own[r].point.size(); ++i)
      add_point(points, rows, own[r].point[i], own[r].u[i], v[r]);
  return points;
}

}  // namespace

ParameterizedPoints parameterize_rows(const PointRows& rows, RowSpacing spacing) {
  check_rows(rows);
  const Index columns = rows.common_length();
  ParameterizedPoints points =
      columns > 0 ? parameterize_grid(rows, columns, spacing) : parameterize_ragged(rows, spacing);
  points.dimension = 3;
  if (rows.line.empty() && points.size() == rows.size()) points.source.clear();  // index + 1 everywhere
  return points;
}

}  // namespace knotfit
