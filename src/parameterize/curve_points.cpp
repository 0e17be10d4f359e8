#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "knotfit/exceptions.h"
#include "knotfit/parameterize_curve.h"
#include "parameterize/row_parameters.h"
namespace knotfit {
namespace {

double spacing_of(const double* a, const double* b, int dimension, RowSpacing spacing) {
  if (spacing == RowSpacing::uniform) return 1;
  double largest = 0, sum = 0;
  for (int e = 0; e < dimension; ++e) largest = std::max(largest, std::abs(b[e] - a[e]));
  if (!(largest > 0)) return 0;
  for (int e = 0; e < dimension; ++e) sum += (b[e] - a[e]) / largest * ((b[e] - a[e]) / largest);
  const double chord = largest * std::sqrt(sum);
  return spacing == RowSpacing::chord ? chord : std::sqrt(chord);
}

/// x, y and, where they are not all NaN, z.
CurvePoints of_table(const PointTable& table, RowSpacing spacing, bool closed, bool function) {
  if (table.x.empty()) throw InvalidInput("a curve needs columns x and y (and z in space)");
  const bool planar = std::all_of(table.z.begin(), table.z.end(), [](double z) { return std::isnan(z); });
  const Index n = table.size();
  std::vector<double> values;
  CurvePoints points;
  if (function) {
    if (n < 2) throw InvalidInput(fmt::format("{} points: a curve needs at least 2", n));
    if (!planar) throw InvalidInput("a function y over x needs columns x and y alone");
    for (Index k = 1; k < n; ++k)
      if (!(table.x[k] > table.x[k - 1]))
        throw InvalidInput(
            fmt::format("x must increase: point {} has {} after {}", k, table.x[k], table.x[k - 1]));
    points.dimension = 1;
    points.function = true;
    points.x0 = table.x.front();
    points.x1 = table.x.back();
    for (Index k = 0; k < n; ++k) points.t.push_back((table.x[k] - points.x0) / (points.x1 - points.x0));
    points.values = table.y;
  } else {
    for (Index k = 0; k < n; ++k) {
      values.insert(values.end(), {table.x[k], table.y[k]});
      if (!planar) values.push_back(table.z[k]);
    }
    points = parameterize_curve(values, planar ? 2 : 3, spacing, closed);
  }
  points.source = table.line;
  points.weights = table.weight;
  points.source.resize(std::min(points.source.size(), points.t.size()));
  points.weights.resize(std::min(points.weights.size(), points.t.size()));
  return points;
}

}  // namespace

CurvePoints parameterize_curve(std::span<const double> values, int dimension, RowSpacing spacing,
                               bool closed) {
  if (dimension < 1 || values.size() % static_cast<std::size_t>(dimension) != 0)
    throw InvalidInput(fmt::format("{} numbers are no points of {} coordinates", values.size(), dimension));
  Index n = static_cast<Index>(values.size()) / dimension;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i]))
      throw InvalidInput(
          fmt::format("point {} has a value that is not finite", static_cast<Index>(i) / dimension));
  const auto at = [&](Index k) { return values.data() + k * dimension; };
  if (closed && n > 1 && std::equal(at(0), at(0) + dimension, at(n - 1))) --n;
  const Index least = closed ? 3 : 2;
  if (n < least)
    throw InvalidInput(
        fmt::format("{} points: a {}curve needs at least {}", n, closed ? "closed " : "", least));
  CurvePoints points;
  points.dimension = dimension;
  points.closed = closed;
  points.values.assign(at(0), at(0) + n * dimension);
  std::vector<double> lengths;
  for (Index k = 1; k < n; ++k) lengths.push_back(spacing_of(at(k - 1), at(k), dimension, spacing));
  if (closed) lengths.push_back(spacing_of(at(n - 1), at(0), dimension, spacing));
  points.t = parameterize::cumulative_parameters(lengths);
  if (points.t.empty()) throw InvalidInput("all points are equal: there is no curve to fit");
  if (closed) points.t.pop_back();
  // Lengths of nothing at the end: their points stand at the start.
  for (double& t : points.t)
    if (closed && t >= 1) t = 0;
  return points;
}

CurvePoints curve_points_of(const SourceData& data, RowSpacing spacing, bool closed, bool function) {
  if (const auto* table = std::get_if<PointTable>(&data.content))
    return of_table(*table, spacing, closed, function);
  if (const auto* rows = std::get_if<PointRows>(&data.content)) {
    if (rows->rows() != 1) throw InvalidInput(fmt::format("{} rows of points: a curve is one", rows->rows()));
    if (function) throw InvalidInput("a function y over x needs columns x and y alone");
    std::vector<double> values;
    for (double x : rows->xyz)
      if (!std::isnan(x)) values.push_back(x);  // a hole is NaN in all three
    return parameterize_curve(values, 3, spacing, closed);
  }
  throw InvalidInput("this is no curve: ordered points are needed, x,y or x,y,z on each line");
}

}  // namespace knotfit
