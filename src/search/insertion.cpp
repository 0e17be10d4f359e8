// The paper's framework: isolines inserted where features or errors are large, all knots placed anew,
// until the tolerance holds; then knots dropped while it still does [Zhang16; METHOD 4.6].
#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/deadline.h"
#include "fit/error_measure.h"
#include "fit/knot_loss.h"
#include "fit/moving_fit.h"
#include "place/error_model.h"
#include "place/levenberg.h"
#include "place/shares.h"
#include "search/attempts.h"
#include "search/guard.h"
#include "search/minimax.h"
#include "search/noise_plateau.h"
#include "search/routes.h"
#include "solve/data_energy.h"
namespace knotfit {
namespace {

/// Cumulative marginal of a feature map along one direction.
class Marginal {
 public:
  Marginal(const FeatureMap& map, bool v) : cumulative_((v ? map.size_v : map.size_u) + 1, 0.0) {
    for (Index i = 0; i < map.size_u; ++i)
      for (Index j = 0; j < map.size_v; ++j) cumulative_[(v ? j : i) + 1] += map.f[i * map.size_v + j];
    std::partial_sum(cumulative_.begin(), cumulative_.end(), cumulative_.begin());
  }
  /// The parameter that halves the mass between low and high; their middle where there is no mass.
  double halving(double low, double high) const {
    const double below = at(low), wanted = (below + at(high)) / 2;
    const double middle = (low + high) / 2;
    if (!(at(high) - below > 0)) return middle;
    double a = low, b = high;
    for (int i = 0; i < 60; ++i) {
      const double x = (a + b) / 2;
      (at(x) < wanted ? a : b) = x;
    }
    // Not closer than a tenth of the span to its ends: a knot there adds next to nothing.
    return std::clamp((a + b) / 2, low + 0.1 * (high - low), high - 0.1 * (high - low));
  }

 private:
  double at(double x) const {
    const double t = x * static_cast<double>(cumulative_.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(t), cumulative_.size() - 2);
    return cumulative_[i] + (t - static_cast<double>(i)) * (cumulative_[i + 1] - cumulative_[i]);
  }
  std::vector<double> cumulative_;
};

class Insertion {
 public:
  /// \param data     the points themselves
  /// \param problem  what is fitted: the data, or the guard's points, which begin with the data
  /// \param moving   the problem where its knots are moved to where the error is least; or null
  Insertion(FitProblem& data, FitProblem& problem, MovingFit* moving, Guard* guard,
            const RefineOptions& options, const Control& control)
      : attempts_(data, options, control, 3000),
        data_(data),
        guard_(guard),
        options_(options),
        problem_(problem),
        context_(problem, placement_options(options), control),
        moving_(moving),
        plateau_(options.noise, data.points().size(), data.points().dimension) {
    if (&data != &problem) attempts_.count(problem);
  }

  RefineResult run() {
    attempts_.set_stage("features");
    const FeatureMap geometry = context_.features();
    attempts_.set_stage("insertion");
    const Status unmet = insert(geometry);
    if (attempts_.reached() && !attempts_.interrupted()) {
      prune();
      if (moving_ && movable(attempts_.best())) prune_moving();
    }
    RefineResult result = attempts_.finish(unmet);
    if (!moving_) result.method = "insert";
    if (!attempts_.interrupted()) result.metric = context_.fine_model().knots;
    return result;
  }

 private:
  static constexpr double kLeastSpan = 1e-4;  ///< a span of this length is not cut again

  Status insert(const FeatureMap& geometry) {
    const int start = 3;  // p = q = 4
    const int start_u =
        static_cast<int>(std::min<Index>(start, problem_.most_functions_u() - problem_.degree_u() - 1));
    const int start_v =
        static_cast<int>(std::min<Index>(start, problem_.most_functions_v() - problem_.degree_v() - 1));
    InteriorKnots knots = by_criterion(geometry, std::max(0, start_u), std::max(0, start_v));
    while (!allowed(knots) && !(knots.u.empty() && knots.v.empty()))
      (knots.u.size() >= knots.v.size() ? knots.u : knots.v).pop_back();
    double error = attempts_.fit(problem_, knots);
    attempts_.list(problem_.axis_u().functions(), problem_.axis_v().functions(), error);
    while (!attempts_.holds(error)) {
      if (attempts_.interrupted()) return attempts_.interruption();
      if (plateau_.add(problem_.control_points(), problem_.rms())) return Status::tolerance_below_noise;
      const std::vector<double> errors = problem_.errors();
      const FeatureMap f = mixed(geometry, residual_features(data_.points(), errors));
      const InteriorKnots inserted = with_isolines(problem_.knots(), f, errors);
      if (inserted == problem_.knots())
        return attempts_.own_limit() ? Status::limit_reached : Status::data_too_sparse;
      const int count_u = static_cast<int>(inserted.u.size()), count_v = static_cast<int>(inserted.v.size());
      InteriorKnots best = inserted;
      error = attempts_.fit(problem_, inserted);
      auto consider = [&](const InteriorKnots& candidate) {
        if (attempts_.holds(error) || attempts_.interrupted()) return;
        if (const double e = attempts_.fit(problem_, candidate); e < error) {
          error = e;
          best = candidate;
        }
      };
      if (std::isfinite(error)) consider(knots_of_density(problem_, count_u, count_v));
      consider(by_criterion(f, count_u, count_v));
      if (moving_ && !attempts_.holds(error) && movable(best)) {
        InteriorKnots moved = best;
        minimize_over_knots(*moving_, moved, levenberg(kStepsARound));
        consider(moved);
      }
      if (!(problem_.knots() == best)) problem_.solve(best);
      error = hold_between(best, error);
      attempts_.list(problem_.axis_u().functions(), problem_.axis_v().functions(), error);
    }
    return Status::reached;
  }

  /// Where a surface holds at the points and was refused between them: adds the places where it is off to the points and fits
  /// the same knots again.
  double hold_between(const InteriorKnots& knots, double error) {
    for (int round = 0; round < 4 && guard_ && !attempts_.holds(error) && !attempts_.interrupted() &&
                        attempts_.holds(problem_.measured(attempts_.tolerance()));
         ++round) {
      if (guard_->exchange(*moving_) == 0) break;
      moving_->take_new_points();
      moving_->set_weights(guard_->joined().shares(*moving_).base);
      error = attempts_.fit(problem_, knots);
    }
    return error;
  }

  /// Whether a fit of these knots is cheap enough to move them: one step takes the time of many fits.
  bool movable(const InteriorKnots& k) const {
    return problem_.operations(static_cast<Index>(k.u.size()) + problem_.degree_u() + 1,
                               static_cast<Index>(k.v.size()) + problem_.degree_v() + 1) <= kMostOperations;
  }

  bool allowed(const InteriorKnots& k) const {
    return attempts_.allowed(static_cast<Index>(k.u.size()) + problem_.degree_u() + 1,
                             static_cast<Index>(k.v.size()) + problem_.degree_v() + 1);
  }

  InteriorKnots by_criterion(const FeatureMap& f, int count_u, int count_v) const {
    InteriorKnots knots = descend_criterion(f, equal_share(f, count_u, count_v)).knots;
    widen_spans(knots.u, 0.01);
    widen_spans(knots.v, 0.01);
    return knots;
  }

  /// f_geometry / mean + f_residual / mean.
  static FeatureMap mixed(const FeatureMap& geometry, const FeatureMap& residual) {
    auto mean = [](const FeatureMap& map) {
      const double sum = std::accumulate(map.f.begin(), map.f.end(), 0.0);
      return sum > 0 ? sum / static_cast<double>(map.f.size()) : 1.0;
    };
    const double g = mean(geometry), r = mean(residual);
    FeatureMap map = residual;
    for (Index i = 0; i < map.size_u; ++i)
      for (Index j = 0; j < map.size_v; ++j) {  // a user's map may have cells of its own
        const Index gi = (2 * i + 1) * geometry.size_u / (2 * map.size_u);
        const Index gj = (2 * j + 1) * geometry.size_v / (2 * map.size_v);
        double& f = map.f[i * map.size_v + j];
        f = geometry.f[gi * geometry.size_v + gj] / g + f / r;
      }
    return map;
  }

  /// A span below it is not cut: it is too short, or the data would not see its halves.
  double least_span(double low, double length, bool v) const {
    return options_.energy ? std::max(kLeastSpan, options_.energy->finest_spacing(low, low + length, v))
                           : kLeastSpan;
  }

  /// Isolines in the spans of both directions with the largest shares of the squared excess over the
  /// tolerance: at most a fifth of the knots, at least one.
  InteriorKnots with_isolines(InteriorKnots knots, const FeatureMap& f,
                              const std::vector<double>& errors) const {
    const double tolerance = attempts_.tolerance().value;
    const ParameterizedPoints& points = data_.points();
    std::vector<double> excess_u(problem_.axis_u().spans(), 0.0), excess_v(problem_.axis_v().spans(), 0.0);
    for (Index k = 0; k < points.size(); ++k) {
      if (!(errors[k] > tolerance)) continue;
      const double square = (errors[k] - tolerance) * (errors[k] - tolerance);
      excess_u[problem_.axis_u().span(points.u(k))] += square;
      excess_v[problem_.axis_v().span(points.v(k))] += square;
    }
    struct Span {
      double excess;
      bool v;
      Index index;
    };
    std::vector<Span> order;
    auto gather = [&](const Axis& axis, const std::vector<double>& excess, bool v) {
      for (Index s = 0; s < axis.spans(); ++s)
        if (excess[s] > 0 && axis.length(s) > least_span(axis.low(s), axis.length(s), v))
          order.push_back({excess[s], v, s});
    };
    gather(problem_.axis_u(), excess_u, false);
    gather(problem_.axis_v(), excess_v, true);
    std::stable_sort(order.begin(), order.end(),
                     [](const Span& a, const Span& b) { return a.excess > b.excess; });
    const auto most = std::max<std::size_t>(1, (knots.u.size() + knots.v.size()) / 5);
    const Marginal marginal_u(f, false), marginal_v(f, true);
    std::size_t added = 0;
    for (const Span& span : order) {
      if (added == most) break;
      const Axis& axis = span.v ? problem_.axis_v() : problem_.axis_u();
      const double low = axis.low(span.index), high = low + axis.length(span.index);
      InteriorKnots next = knots;
      auto& line = span.v ? next.v : next.u;
      const double x = (span.v ? marginal_v : marginal_u).halving(low, high);
      line.insert(std::upper_bound(line.begin(), line.end(), x), x);
      if (!allowed(next)) continue;
      knots = std::move(next);
      ++added;
    }
    return knots;
  }

  /// Drops knots of least loss first while the tolerance still holds. One pass of fits orders the knots
  /// by loss; each is then tried in that order on what is left, and passes go on until one drops none.
  void prune() {
    attempts_.set_stage("prune");
    InteriorKnots knots = attempts_.best();
    double operations = 0;
    for (bool dropped = true; dropped;) {
      dropped = false;
      struct Candidate {
        double error;
        bool v;
        double knot;
      };
      std::vector<Candidate> order;
      auto without = [](InteriorKnots k, bool v, double knot) {
        auto& line = v ? k.v : k.u;
        line.erase(std::find(line.begin(), line.end(), knot));
        return k;
      };
      auto try_without = [&](bool v, double knot) {
        operations += problem_.operations(problem_.axis_u().functions(), problem_.axis_v().functions());
        return attempts_.fit(problem_, without(knots, v, knot));
      };
      for (bool v : {false, true})
        for (double knot : v ? knots.v : knots.u) {
          if (attempts_.interrupted() || operations > kPruneOperations) return;
          order.push_back({try_without(v, knot), v, knot});
        }
      // A u-knot takes a whole column of control points: count what goes, then what it costs.
      const auto gain = [&](const Candidate& c) { return c.v ? knots.u.size() : knots.v.size(); };
      std::stable_sort(order.begin(), order.end(), [&](const Candidate& a, const Candidate& b) {
        const bool ha = attempts_.holds(a.error), hb = attempts_.holds(b.error);
        if (ha != hb) return ha;
        if (gain(a) != gain(b)) return gain(a) > gain(b);
        return a.error < b.error;
      });
      for (const Candidate& c : order) {
        if (!attempts_.holds(c.error)) break;
        if (attempts_.interrupted() || operations > kPruneOperations) return;
        const double error = dropped ? try_without(c.v, c.knot) : c.error;
        if (!attempts_.holds(error)) continue;
        knots = without(knots, c.v, c.knot);
        dropped = true;
        attempts_.list(static_cast<Index>(knots.u.size()) + problem_.degree_u() + 1,
                       static_cast<Index>(knots.v.size()) + problem_.degree_v() + 1, error);
      }
    }
  }

  /// Drops a knot, moves the others to where the error is least (for a maximum by minimax too), and goes on while the
  /// tolerance holds.
  void prune_moving() {
    attempts_.set_stage("prune, knots moving");
    const bool minimax = row_of(attempts_.tolerance().measure).every_point;
    InteriorKnots knots = attempts_.best();
    for (bool dropped = true; dropped;) {
      dropped = false;
      const bool v_first = knots.u.size() > knots.v.size();  // a v-knot takes more control points then
      for (bool v : {v_first, !v_first}) {
        if ((v ? knots.v : knots.u).empty() || attempts_.interrupted() || !problem_.solve(knots)) continue;
        const std::vector<double> loss = knot_losses(*moving_, v);
        InteriorKnots fewer = knots;
        auto& line = v ? fewer.v : fewer.u;
        line.erase(line.begin() + (std::min_element(loss.begin(), loss.end()) - loss.begin()));
        minimize_over_knots(*moving_, fewer, levenberg(40));
        double error = problem_.measured(attempts_.tolerance());
        bool squares = true;
        const PointShares shares = guard_ ? guard_->joined().shares(*moving_) : PointShares{};
        if (minimax && !attempts_.holds(error) && error < kMinimaxReach * attempts_.tolerance().value) {
          MinimaxOptions options;
          options.enough = attempts_.tolerance().value;
          options.patience = 1;
          options.stop = [this] { return attempts_.stopped(); };
          const NetState state = minimize_maximum(*moving_, shares, options);
          fewer = state.knots;
          error = state.max;
          squares = false;
        }
        attempts_.list(problem_.axis_u().functions(), problem_.axis_v().functions(), error);
        if (!attempts_.holds(error) || !attempts_.holds(attempts_.offer(problem_, error, squares))) continue;
        knots = fewer;
        dropped = true;
        break;
      }
    }
  }

  LevenbergOptions levenberg(int steps) const {
    LevenbergOptions options;
    options.steps = steps;
    options.fall = 2e-3;
    options.stop = [this] { return attempts_.stopped(); };
    return options;
  }

  static constexpr double kMostOperations = 1e9;  ///< of a fit
  static constexpr double kPruneOperations = 6e10;
  static constexpr int kStepsARound = 8;        ///< of all knots, after isolines were inserted
  static constexpr double kMinimaxReach = 2.5;  ///< what minimax may gain

  Attempts attempts_;
  FitProblem& data_;
  Guard* guard_;  ///< or null; then the problem moves
  const RefineOptions& options_;
  FitProblem& problem_;
  PlacementContext context_;
  MovingFit* moving_;  ///< or null
  NoisePlateau plateau_;
};

}  // namespace

bool can_optimise_insertion(const ParameterizedPoints& points) {
  return points.size() * points.dimension <= 200'000;
}

RefineResult insert_isolines(FitProblem& data, const RefineOptions& options, const Control& control) {
  const bool optimal =
      placement_method(options.method).traits.moves_knots && can_optimise_insertion(data.points());
  if (!optimal) return Insertion(data, data, nullptr, nullptr, options, control).run();
  const Deadline deadline(control);
  const LeastSquaresOptions fit = search_fits(options);
  MovingFit plain(data.points(), options.degree_u, options.degree_v, fit);
  if (!options.guard) return Insertion(data, plain, &plain, nullptr, options, control).run();
  const InteriorKnots metric =
      PlacementContext(plain, placement_options(options), control).fine_model().knots;
  JoinedPoints joined(data.points());
  Guard guard(joined, options.tolerance.value, row_of(options.tolerance.measure).guard_looseness, metric,
              [&] { return deadline.over(); });
  MovingFit guarded(joined.points(), options.degree_u, options.degree_v, fit);
  guarded.count_first(data.points().size());
  RefineResult result = Insertion(data, guarded, &guarded, &guard, options, deadline.left()).run();
  result.fits += plain.fits();
  result.fill_points = guard.fill_count();
  if (result.fill_points > 0) result.least_squares = false;
  return result;
}

}  // namespace knotfit
