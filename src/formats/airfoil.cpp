#include "formats/airfoil.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "formats/missing.h"
#include "formats/point_line.h"
#include "formats/text_opening.h"
namespace knotfit {

bool is_lednicer(LineReader lines, Index upper, Index lower) {
  std::vector<double> x, y;
  TextLine line;
  while (lines.next(line) && static_cast<Index>(x.size()) < upper + lower) {
    if (is_empty_line(line.text) || is_comment(line.text)) continue;
    double a = 0, b = 0;
    double* const into[] = {&a, &b};
    if (!parse_line(line, into, find_separator(line.text)) || !std::isfinite(a) || !std::isfinite(b))
      return false;
    x.push_back(a);
    y.push_back(b);
  }
  if (static_cast<Index>(x.size()) != upper + lower) return false;
  const auto [least, most] = std::minmax_element(x.begin(), x.end());
  const double slack = 0.01 * (*most - *least);
  const auto second = static_cast<std::size_t>(upper);
  if (!(slack > 0) || std::abs(x[0] - x[second]) > 2 * slack || std::abs(y[0] - y[second]) > 2 * slack)
    return false;
  for (std::size_t k = 1; k < x.size(); ++k)
    if (k != second && x[k] < x[k - 1] - slack) return false;
  return true;
}

std::string join_lednicer(PointTable& table, Index upper) {
  const auto turn = [&](auto& column) {
    if (!column.empty()) std::reverse(column.begin(), column.begin() + upper);
  };
  for (int r = 0; r < kRoles; ++r) turn(*column_of(table, static_cast<Role>(r)));
  turn(table.line);
  const auto nose = static_cast<std::size_t>(upper);
  const Index lower = static_cast<Index>(table.x.size()) - upper;
  const bool once = table.x[nose - 1] == table.x[nose] && table.y[nose - 1] == table.y[nose];
  if (once) drop_points(table, {upper});
  return fmt::format(
      "an airfoil in Lednicer's form: {} points of the upper surface from the tail to the nose and {} of "
      "the lower from the nose to the tail are joined to one profile{}",
      upper, lower, once ? "; the nose stands there once" : "");
}

}  // namespace knotfit
