#include "search/size_solver.h"

#include <algorithm>
#include <cmath>
namespace knotfit {

const SizeOutcome* SizeSolver::seen(const Spans& spans) const {
  const auto it = outcomes_.find(spans);
  return it == outcomes_.end() ? nullptr : &it->second;
}

bool SizeSolver::hopeless(const Spans& c, double tolerance) const {
  return std::any_of(outcomes_.begin(), outcomes_.end(), [&](const auto& tried) {
    const auto& [spans, outcome] = tried;
    if (outcome.holds || spans.first < c.first || spans.second < c.second) return false;
    double margin = outcome.tries > 1 ? policy_.hopeless_twice : policy_.hopeless;
    if (policy_.growth > 0)  // the smaller net is expected to be worse by a power of its size
      margin /= std::pow(
          static_cast<double>(spans.first) * spans.second / (static_cast<double>(c.first) * c.second),
          policy_.growth);
    return outcome.error > margin * tolerance;
  });
}

}  // namespace knotfit
