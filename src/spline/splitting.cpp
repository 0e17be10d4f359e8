#include "spline/splitting.h"

#include <algorithm>

#include "knotfit/exceptions.h"
namespace knotfit {

std::vector<Surface> split_u(const Surface& s, std::span<const double> cuts) {
  if (s.empty()) throw InvalidInput("the surface to split is empty");
  if (!s.knots_u().is_clamped()) throw InvalidInput("the surface to split is not clamped");
  const Index p = s.degree_u();
  std::vector<double> added;
  for (const double cut : cuts)
    for (Index copies = s.knots_u().multiplicity(cut); copies < p; ++copies) added.push_back(cut);
  const Surface whole = refine_u(s, added);
  const std::vector<double>& t = whole.knots_u().knots();
  const Index width = s.size_v() * s.dimension();

  std::vector<Surface> pieces;
  Index first_row = 0;  // of the piece, and the first knot after its start
  Index first_knot = std::upper_bound(t.begin(), t.end(), t.front()) - t.begin();
  double start = t.front();
  const auto add = [&](double end) {
    const auto [begin_end, end_end] = std::equal_range(t.begin(), t.end(), end);
    const Index before = begin_end - t.begin(), after = end_end - t.begin();
    std::vector<double> knots(static_cast<std::size_t>(p + 1), start);
    knots.insert(knots.end(), t.begin() + first_knot, begin_end);
    knots.insert(knots.end(), static_cast<std::size_t>(p + 1), end);
    const Index last_row = before - 1;  // its p arguments are the first p copies of `end`
    std::vector<double> net(whole.net().begin() + first_row * width,
                            whole.net().begin() + (last_row + 1) * width);
    pieces.emplace_back(KnotVector(static_cast<int>(p), std::move(knots)), s.knots_v(), s.dimension(),
                        std::move(net));
    first_row = after - p - 1;  // its arguments are the last p copies
    first_knot = after;
    start = end;
  };
  for (const double cut : cuts) add(cut);
  add(whole.knots_u().last());
  return pieces;
}

}  // namespace knotfit
