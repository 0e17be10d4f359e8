#include "parameterize/mesh_candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "base/parallel.h"
#include "data/orientation.h"
#include "parameterize/mesh_corner_search.h"
#include "parameterize/mesh_mean_value.h"
#include "parameterize/mesh_newton.h"
namespace knotfit::mesh_map {
namespace {

struct Metric {
  double omega;
  std::vector<RestTriangle> rest;
};

Corners find_by_search(const DiskMesh& disk, const Border& border, const std::vector<RestTriangle>& rest,
                       const Elimination& elimination, const Corners& sharpest, const Choices& choices,
                       const Stage& stage) {
  ConvexMap map(disk, elimination);
  std::vector<double> uv(2 * disk.position.size(), 0);
  // One factor serves all corners: they only change the right sides.
  const auto search = [&](std::vector<Corners> starts) {
    return search_corners(border, {.starts = std::move(starts), .stop = [&] { return stage.over(); }},
                          [&](const Corners& corners) {
                            border.place(corners, uv);
                            map.solve(uv);
                            return measure_stretch(disk, rest, uv).cost();
                          });
  };
  if (!map.factor(mean_value_weights(disk, rest))) return sharpest;
  const Corners found = search({sharpest});
  if (!choices.newton) return found;
  // Again with weights that even out the stretch: what corners are worth once it is even.
  const EdgeWeights even =
      reweight(disk, rest, elimination, border, found, {.stop = [&] { return stage.over(); }}).weights;
  return map.factor(even) ? search({sharpest, found}) : found;
}

// One metric with one rule's corners on its way.
class Candidate {
 public:
  Candidate(const DiskMesh& disk, const Elimination& elimination, const Metric& metric, CornerRule rule,
            const Corners& corners, const Choices& choices, const Stage& stage)
      : disk_(disk), metric_(metric), rule_(rule), corners_(corners) {
    const Border border(disk, metric.rest);
    // Newton gets as far from six rounds of reweighting as from twelve.
    const ReweightOptions options{
        .exponent = 0.5, .slide = 0.5, .rounds = choices.newton ? 6 : 1, .stop = [&] {
          return stage.over();
        }};
    std::vector<double> start = reweight(disk, metric.rest, elimination, border, corners, options).uv;
    consider(start);
    if (choices.newton)
      newton_ = std::make_unique<NewtonMap>(disk, metric.rest, elimination, std::move(start));
  }

  void advance(int rounds, const Stage& stage) {
    if (!newton_ || newton_->converged() || rounds <= 0) return;
    newton_->advance(rounds, 1e-4, [&] { return stage.over(); });
    newton_->release();
    consider(newton_->square_parameters());
  }
  /// Flipped triangles first, then those of the mesh without its edges halved, then the fit.
  bool better_than(const Candidate& other) const {
    if (flipped_ != other.flipped_) return flipped_ < other.flipped_;
    if (own_flipped_ != other.own_flipped_) return own_flipped_ < other.own_flipped_;
    return fit_.trial_error() < other.fit_.trial_error();
  }
  int rounds() const { return newton_ ? newton_->rounds() : 0; }
  ChosenMap result() const { return {uv_, corners_, metric_.omega, rule_, fit_}; }

 private:
  // Newton's map is meant to replace its start; only rounding can turn a triangle over.
  void consider(std::vector<double> uv) {
    const Index flipped = count_flipped(disk_.face, uv);
    if (!uv_.empty() && flipped > flipped_) return;
    flipped_ = flipped;
    own_flipped_ = disk_.halved.empty() ? flipped : count_flipped(disk_.own_face, uv);
    uv_ = std::move(uv);
    fit_ = trial_fit(disk_, uv_);
  }
  const DiskMesh& disk_;
  const Metric& metric_;
  CornerRule rule_;
  Corners corners_;
  std::unique_ptr<NewtonMap> newton_;
  std::vector<double> uv_;
  Index flipped_ = 0, own_flipped_ = 0;
  TrialFit fit_;
};

using Candidates = std::vector<std::unique_ptr<Candidate>>;

void keep_best(Candidates& candidates, std::size_t most) {
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a->better_than(*b); });
  if (candidates.size() > most) candidates.resize(most);
}

}  // namespace

ChosenMap best_map(const DiskMesh& disk, const Choices& choices, const Stage& stage) {
  const Elimination elimination(disk.vertex_count(), disk.edge);
  std::vector<Metric> metrics;
  for (const double omega : choices.omegas) metrics.push_back({omega, rest_triangles(disk, omega)});
  // The metric hardly moves the best corners: they are looked for once, in the middle one.
  const std::vector<RestTriangle>& middle = metrics[metrics.size() / 2].rest;
  const Border border(disk, middle);
  const Corners sharpest =
      choices.corners ? *choices.corners : corners_at_ears(border, sharpest_corners(border));

  // The rounds after which only the better ones go on: the order of the fits hardly changes then.
  constexpr int first = 3, second = 7;
  const int rounds = choices.newton_rounds;
  Candidates candidates;
  const auto start = [&](std::size_t slot, std::size_t metric, CornerRule rule, const Corners& corners) {
    candidates[slot] =
        std::make_unique<Candidate>(disk, elimination, metrics[metric], rule, corners, choices, stage);
    candidates[slot]->advance(std::min(first, rounds), stage);
  };
  const bool search = !choices.corners && choices.rule != CornerRule::sharpest;
  const bool sharp = choices.corners || choices.rule != CornerRule::search;
  const std::size_t m = metrics.size(), by_sharp = sharp ? m : 0, by_search = search ? m : 0;
  candidates.resize(by_sharp + by_search);
  Corners searched = sharpest;
  parallel_for(static_cast<Index>(by_sharp + (search ? 1 : 0)), [&](Index task) {
    if (search && task == 0) {  // the longest task first
      searched = corners_at_ears(border,
                                 find_by_search(disk, border, middle, elimination, sharpest, choices, stage));
      return;
    }
    const auto k = static_cast<std::size_t>(task) - (search ? 1 : 0);
    start(k, k, choices.corners ? choices.rule : CornerRule::sharpest, sharpest);
  });
  stage.report(0.4);
  parallel_for(static_cast<Index>(by_search), [&](Index k) {
    start(by_sharp + static_cast<std::size_t>(k), static_cast<std::size_t>(k), CornerRule::search, searched);
  });
  stage.report(0.6);

  const auto go_on = [&](std::size_t most, int until, double done) {
    keep_best(candidates, most);
    parallel_for(static_cast<Index>(candidates.size()),
                 [&](Index k) { candidates[k]->advance(until - candidates[k]->rounds(), stage); });
    stage.report(done);
  };
  go_on(4, std::min(second, rounds), 0.8);
  go_on(2, rounds, 1);
  keep_best(candidates, 1);
  return candidates.front()->result();
}

}  // namespace knotfit::mesh_map
