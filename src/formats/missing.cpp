#include "formats/missing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "formats/columns.h"
#include "formats/nodata.h"
#include "formats/text_lines.h"
#include "knotfit/remedy.h"
namespace knotfit {

bool is_missing_word(std::string_view token) {
  token = trimmed(token);
  if (token.size() >= 2 && token.front() == '"' && token.back() == '"')
    token = trimmed(token.substr(1, token.size() - 2));
  constexpr std::array<std::string_view, 29> kWords = {
      "",    "nan",    "+nan",    "-nan",    "na",      "n/a",      "#n/a",   "<na>",    "null",  "none",
      "nil", "nodata", "no data", "no_data", "no-data", "missing",  "void",   "nd",      "*",     "-",
      "--",  "---",    "?",       ".",       "1.#qnan", "-1.#qnan", "1.#ind", "-1.#ind", "1.#nan"};
  if (token.size() > 8) return false;
  const std::string word = lower_case(token);
  return std::find(kWords.begin(), kWords.end(), word) != kWords.end();
}

std::string leave_out_hint() {
  return remedy_text(Remedy::nodata, "nan") + " leaves out the points that miss a value";
}

bool misses_value(double coordinate, bool all_finite, std::optional<double> nodata) {
  if (!nodata) return false;
  return std::isnan(*nodata) ? !all_finite : is_nodata(coordinate, *nodata);
}

void drop_points(PointTable& table, const std::vector<Index>& points) {
  if (points.empty()) return;
  const auto drop = [&](auto& column) {
    if (column.empty()) return;
    std::size_t kept = static_cast<std::size_t>(points.front()), next = 0;
    for (std::size_t k = kept; k < column.size(); ++k)
      if (next < points.size() && static_cast<std::size_t>(points[next]) == k)
        ++next;
      else
        column[kept++] = column[k];
    column.resize(kept);
  };
  for (int r = 0; r < kRoles; ++r) drop(*column_of(table, static_cast<Role>(r)));
  drop(table.line);
}

Index drop_far_nodata(PointTable& table, std::optional<double> nodata) {
  if (!nodata || std::isnan(*nodata)) return 0;
  std::vector<Index> dropped;
  for (const Role role : {Role::x, Role::y, Role::u, Role::v, Role::w}) {
    const std::vector<double>& column = *column_of(table, role);
    double least = std::numeric_limits<double>::infinity(), most = -least;
    std::vector<Index> equal;
    for (std::size_t k = 0; k < column.size(); ++k)
      if (is_nodata(column[k], *nodata))
        equal.push_back(static_cast<Index>(k));
      else if (std::isfinite(column[k]))
        least = std::min(least, column[k]), most = std::max(most, column[k]);
    if (equal.empty() || least > most) continue;
    const double beyond = std::max(least - *nodata, *nodata - most);
    // Numbers such as -9999 are no values once they lie outside the others; 0 may be.
    const double enough = std::abs(*nodata) >= 99 ? 0 : 10 * (most - least);
    if (beyond > enough) dropped.insert(dropped.end(), equal.begin(), equal.end());
  }
  std::sort(dropped.begin(), dropped.end());
  dropped.erase(std::unique(dropped.begin(), dropped.end()), dropped.end());
  drop_points(table, dropped);
  return static_cast<Index>(dropped.size());
}

std::string left_out_note(Index count, double nodata) {
  const std::string points = fmt::format("{} point{} left out", count, count == 1 ? "" : "s");
  return std::isnan(nodata)
             ? fmt::format("{}: a value is missing ({})", points, remedy_text(Remedy::nodata, "nan"))
             : fmt::format("{}: the value {} stands for none ({})", points, nodata,
                           remedy_text(Remedy::nodata));
}

}  // namespace knotfit
