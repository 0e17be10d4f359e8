#include "search/whole_data.h"

#include <algorithm>
#include <vector>

#include "base/uniform_cell.h"
namespace knotfit {
namespace {

constexpr Index kCells = 32;  // a direction: worst points nearer to each other say the same
constexpr Index kMost = 300;  // points that join at once

}  // namespace

const FitProblem& WholeData::measure(const FitProblem& sampled) {
  if (all_.knots() == sampled.knots() && all_.net() == sampled.net()) return all_;
  all_.evaluate(sampled.knots(), sampled.net());
  return all_;
}

Index WholeData::join_worst(JoinedPoints& joined) const {
  const ParameterizedPoints& points = all_.points();
  const std::vector<double> errors = all_.errors();
  std::vector<Index> worst(kCells * kCells, -1);
  for (Index k = 0; k < points.size(); ++k) {
    if (errors[k] <= tolerance_.value) continue;
    Index& w = worst[uniform_cell(points.u(k), kCells) * kCells + uniform_cell(points.v(k), kCells)];
    if (w < 0 || errors[k] > errors[w]) w = k;
  }
  std::erase(worst, -1);
  std::sort(worst.begin(), worst.end(),
            [&](Index a, Index b) { return errors[a] != errors[b] ? errors[a] > errors[b] : a < b; });
  if (static_cast<Index>(worst.size()) > kMost) worst.resize(kMost);
  for (Index k : worst) joined.join(points.u(k), points.v(k), points.value(k), 1, 1);
  return static_cast<Index>(worst.size());
}

}  // namespace knotfit
