#include "place/relocate.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

#include "fit/knot_gain.h"
#include "fit/knot_loss.h"
namespace knotfit {
namespace {

std::vector<double>& line(InteriorKnots& knots, bool along_v) {
  return along_v ? knots.v : knots.u;
}

/// Middles of the spans where the gain of a knot peaks in the present fit, the greatest first; one at least, at most so
/// many.
std::vector<double> gain_peaks(MovingFit& problem, bool along_v, std::size_t most) {
  const std::vector<double> gain = knot_gains(problem, along_v);
  std::vector<Index> spans;
  const auto n = static_cast<Index>(gain.size());
  for (Index i = 0; i < n; ++i)
    if ((i == 0 || !(gain[i] <= gain[i - 1])) && (i + 1 == n || !(gain[i] < gain[i + 1]))) spans.push_back(i);
  std::stable_sort(spans.begin(), spans.end(), [&](Index a, Index b) { return gain[a] > gain[b]; });
  spans.resize(std::min(spans.size(), most));
  const Axis& axis = along_v ? problem.axis_v() : problem.axis_u();
  std::vector<double> middles;
  middles.reserve(spans.size());
  for (const Index i : spans) middles.push_back(axis.low(i) + axis.length(i) / 2);
  return middles;
}

void insert(InteriorKnots& knots, bool along_v, double at) {
  auto& k = line(knots, along_v);
  k.insert(std::lower_bound(k.begin(), k.end(), at), at);
}

/// What each knot of a direction is worth; all alike where these knots cannot be fitted.
std::vector<double> losses(MovingFit& problem, const InteriorKnots& knots, bool along_v) {
  if (problem.solve(knots)) return knot_losses(problem, along_v);
  return std::vector<double>((along_v ? knots.v : knots.u).size(), 0.0);
}

LevenbergOptions with_steps(LevenbergOptions options, int steps) {
  options.steps = steps;
  return options;
}

/// Drops a knot and tries it at the peaks of the gain. \return true where one lowers phi by more than options.gain, and
/// is taken
bool relocate_knot(MovingFit& problem, InteriorKnots& knots, double& phi, bool along_v, std::size_t dropped,
                   const LevenbergOptions& levenberg, const RelocationOptions& options) {
  InteriorKnots fewer = knots;
  auto& k = line(fewer, along_v);
  k.erase(k.begin() + static_cast<Index>(dropped));
  minimize_over_knots(problem, fewer, with_steps(levenberg, 3));
  LevenbergOptions towards = levenberg;
  towards.target = phi * (1 - options.gain);
  for (const double at : gain_peaks(problem, along_v, options.peaks)) {
    InteriorKnots trial = fewer;
    insert(trial, along_v, at);
    const double after = minimize_over_knots(problem, trial, towards);
    if (!(after < towards.target)) continue;
    phi = after;
    knots = std::move(trial);
    return true;
  }
  return false;
}

}  // namespace

double relocate_knots(MovingFit& problem, InteriorKnots& knots, double phi, const LevenbergOptions& levenberg,
                      const RelocationOptions& options) {
  for (int pass = 0; pass < options.passes; ++pass) {
    bool moved = false;
    for (bool along_v : {false, true}) {
      if (line(knots, along_v).size() < 2 || (levenberg.stop && levenberg.stop())) continue;
      const std::vector<double> loss = losses(problem, knots, along_v);
      std::vector<std::size_t> order(loss.size());
      std::iota(order.begin(), order.end(), 0);
      std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return loss[a] < loss[b]; });
      order.resize(std::min<std::size_t>(order.size(), options.candidates));
      for (const std::size_t c : order)
        if (relocate_knot(problem, knots, phi, along_v, c, levenberg, options)) {
          moved = true;
          break;
        }
    }
    if (!moved) break;
  }
  problem.solve(knots);
  return phi;
}

namespace {

/// Ties the first of the nearest pairs of distinct knots of a direction that lowers phi. \return whether one did
bool tie_a_pair(MovingFit& problem, InteriorKnots& knots, double& phi, bool along_v,
                const LevenbergOptions& levenberg) {
  constexpr std::size_t kPairs = 3;  // tried
  const int degree = along_v ? problem.degree_v() : problem.degree_u();
  const std::vector<double> k = line(knots, along_v);
  const double near = 0.5 / static_cast<double>(k.size() + 1);
  std::vector<std::pair<double, std::size_t>> pairs;
  for (std::size_t i = 0; i + 1 < k.size(); ++i)
    if (k[i] < k[i + 1] && k[i + 1] - k[i] < near) pairs.push_back({k[i + 1] - k[i], i});
  std::sort(pairs.begin(), pairs.end());
  pairs.resize(std::min(pairs.size(), kPairs));
  for (const auto& [distance, i] : pairs) {
    InteriorKnots trial = knots;
    auto& t = line(trial, along_v);
    const double low = k[i], high = k[i + 1], middle = (low + high) / 2;
    for (double& x : t)
      if (x == low || x == high) x = middle;  // doubles may tie into triples
    if (std::count(t.begin(), t.end(), middle) > degree) continue;
    if (const double after = minimize_over_knots(problem, trial, levenberg); after < phi) {
      phi = after;
      knots = trial;
      return true;
    }
  }
  return false;
}

}  // namespace

double tie_knots(MovingFit& problem, InteriorKnots& knots, double phi, const LevenbergOptions& levenberg) {
  // Another pass after a pair was tied: what the other direction gains shows once this one's error is gone.
  for (bool tied = true; tied;) {
    tied = false;
    for (bool along_v : {false, true})
      while (!(levenberg.stop && levenberg.stop()) && tie_a_pair(problem, knots, phi, along_v, levenberg))
        tied = true;
  }
  problem.solve(knots);
  return phi;
}

InteriorKnots adapt_knots(MovingFit& problem, InteriorKnots knots, std::size_t count_u, std::size_t count_v,
                          const LevenbergOptions& levenberg, int steps) {
  const LevenbergOptions few = with_steps(levenberg, steps);
  for (bool along_v : {false, true}) {
    const std::size_t wanted = along_v ? count_v : count_u;
    while (line(knots, along_v).size() > wanted) {
      const std::vector<double> loss = losses(problem, knots, along_v);
      auto& k = line(knots, along_v);
      k.erase(k.begin() + (std::min_element(loss.begin(), loss.end()) - loss.begin()));
      minimize_over_knots(problem, knots, few);
    }
    while (line(knots, along_v).size() < wanted) {
      problem.solve(knots);
      insert(knots, along_v, gain_peaks(problem, along_v, 1).front());
      minimize_over_knots(problem, knots, few);
    }
  }
  return knots;
}

}  // namespace knotfit
