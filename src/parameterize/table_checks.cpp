#include "parameterize/table_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/place_text.h"
#include "data/strays.h"
#include "knotfit/exceptions.h"
#include "knotfit/remedy.h"
namespace knotfit::parameterize {
namespace {

constexpr double kLine = 1e-5;
constexpr Index kMostNames = 10, kFirstNames = 8;

void check_length(const std::vector<double>& column, const char* name, Index n) {
  if (static_cast<Index>(column.size()) != n)
    throw InvalidInput(fmt::format("column {} has {} values, column z has {}: they must be as many", name,
                                   column.size(), n));
}

void check_finite(const PointTable& table, const std::vector<double>& column, const char* name) {
  for (Index k = 0; k < static_cast<Index>(column.size()); ++k)
    if (!std::isfinite(column[k]))
      throw InvalidInput(
          fmt::format("{}: {} = {} is not a finite number", point_name(table.line, k), name, column[k]));
}

}  // namespace

std::string point_name(const std::vector<Index>& line, Index k) {
  return line.empty() ? fmt::format("point {}", k + 1) : fmt::format("line {}", line[k]);
}

std::string point_names(const std::vector<Index>& line, std::span<const Index> points) {
  if (points.size() == 1) return point_name(line, points[0]);
  const Index count = static_cast<Index>(points.size()), shown = count > kMostNames ? kFirstNames : count;
  std::string text = line.empty() ? "points " : "lines ";
  for (Index i = 0; i < shown; ++i) {
    if (i > 0) text += i + 1 == count ? " and " : ", ";
    text += std::to_string(line.empty() ? points[i] + 1 : line[points[i]]);
  }
  if (shown < count) text += fmt::format(" and {} more", count - shown);
  return text;
}

void check_table(const PointTable& table) {
  const Index n = table.size();
  if (n == 0) throw InvalidInput("no points: column z is empty");
  if (!table.x.empty() || !table.y.empty()) check_length(table.x, "x", n), check_length(table.y, "y", n);
  if (!table.u.empty() || !table.v.empty()) check_length(table.u, "u", n), check_length(table.v, "v", n);
  if (!table.weight.empty()) check_length(table.weight, "weight", n);
  if (!table.nx.empty() || !table.ny.empty() || !table.nz.empty())
    check_length(table.nx, "nx", n), check_length(table.ny, "ny", n), check_length(table.nz, "nz", n);
  if (!table.line.empty() && static_cast<Index>(table.line.size()) != n)
    throw InvalidInput(fmt::format("{} line numbers for {} points", table.line.size(), n));
  check_finite(table, table.x, "x");
  check_finite(table, table.y, "y");
  check_finite(table, table.z, "z");
  check_finite(table, table.u, "u");
  check_finite(table, table.v, "v");
  for (Index k = 0; k < static_cast<Index>(table.weight.size()); ++k)
    if (!(table.weight[k] > 0 && std::isfinite(table.weight[k])))
      throw InvalidInput(fmt::format("{}: weight {}: weights must be positive and finite",
                                     point_name(table.line, k), table.weight[k]));
}

Range range_of(const std::vector<double>& column, const char* name) {
  const auto [low, high] = std::minmax_element(column.begin(), column.end());
  if (!std::isfinite(*high - *low))
    throw InvalidInput(fmt::format("{} runs from {} to {}: a range that no double can hold; change its unit",
                                   name, *low, *high));
  return {*low, *high};
}

void check_strays(std::span<const double> values, int dimension, const std::vector<Index>& line) {
  const std::vector<Index> strays = far_strays(values, dimension);
  if (strays.empty()) return;
  const double* first = values.data() + strays.front() * dimension;
  std::string place;
  for (int d = 0; d < dimension; ++d) place += (d > 0 ? ", " : "") + place_text(first[d]);
  throw InvalidInput(
      fmt::format("{}: {}({}) stands more than 1000 times as far away as the farthest of the others: a "
                  "stray; leave {} out of the "
                  "file, or name a number that stands for missing data with {}",
                  point_names(line, strays), strays.size() == 1 ? "" : "each of these, such as ", place,
                  strays.size() == 1 ? "it" : "them", remedy_text(Remedy::nodata)));
}

void check_plane(const std::vector<double>& a, const std::vector<double>& b, const char* name_a,
                 const char* name_b, const std::vector<Index>& lines) {
  const Range ra = range_of(a, name_a), rb = range_of(b, name_b);
  const Index n = static_cast<Index>(a.size());
  const double wa = ra.high - ra.low, wb = rb.high - rb.low;
  if (wa == 0 && wb == 0)
    throw InvalidInput(fmt::format("all {} points have {} = {} and {} = {}: they span no surface", n, name_a,
                                   ra.low, name_b, rb.low));
  const std::string line =
      fmt::format("they lie on one straight line in ({}, {}) and span no surface", name_a, name_b);
  if (wa == 0) throw InvalidInput(fmt::format("all {} points have {} = {}: {}", n, name_a, ra.low, line));
  if (wb == 0) throw InvalidInput(fmt::format("all {} points have {} = {}: {}", n, name_b, rb.low, line));
  std::vector<double> both;
  both.reserve(2 * a.size());
  for (std::size_t k = 0; k < a.size(); ++k) both.insert(both.end(), {a[k], b[k]});
  check_strays(both, 2, lines);
  // The line through two points far apart: the farthest from the first, and the farthest from that.
  auto at = [&](Index k) { return std::pair((a[k] - ra.low) / wa, (b[k] - rb.low) / wb); };
  auto farthest = [&](Index from) {
    Index best = from;
    double most = 0;
    for (Index k = 0; k < n; ++k) {
      const double d = std::hypot(at(k).first - at(from).first, at(k).second - at(from).second);
      if (d > most) most = d, best = k;
    }
    return best;
  };
  const Index p = farthest(0), q = farthest(p);
  const auto [pa, pb] = at(p);
  const double da = at(q).first - pa, db = at(q).second - pb, length = std::hypot(da, db);
  for (Index k = 0; k < n; ++k) {
    const auto [ka, kb] = at(k);
    if (std::abs((ka - pa) * db - (kb - pb) * da) > kLine * length) return;
  }
  throw InvalidInput(fmt::format("{} points: {}", n, line));
}

}  // namespace knotfit::parameterize
