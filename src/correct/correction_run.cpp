#include "correct/correction_run.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "correct/mesh_at_parameters.h"
#include "correct/minimax_rounds.h"
namespace knotfit::correction {
namespace {

// The values are set where nothing is said; the measured ones have their figures in [METHOD 8.1].
constexpr int kSeries = 6;            // rounds between two halvings of long edges
constexpr double kFirstShare = 0.3;   // of the tangential distance: the first from the plain fit
constexpr double kLaterShare = 0.05;  // the first from a surface given
constexpr double kLeastShare = 1e-2;  // measured: 1e-3 and 1e-4 gain nothing steady
constexpr double kShrink = 0.6;       // of the share, after a round that gains
constexpr double kGrow = 4;           // of the share, after one that loses
constexpr double kGains = 1.0001;     // times the penalised error before: up to here a round gains
constexpr int kShorterSteps = 3;
constexpr double kShorter = 0.4;   // a step by the one before it
constexpr double kFarWorse = 1.5;  // times the best's penalised error: back to the best at once
constexpr int kLosses = 3;         // in a row: more lead back to the best

/// Share of the fairness that is charged. Ruffles form early; the distances have the last word.
double fairness_after(double share_of_rounds) {
  return share_of_rounds < 0.5 ? 1 : kLaterFairness;
}

std::vector<double> equal_weights(const FixedKnots& knots) {
  return std::vector<double>(static_cast<std::size_t>(knots.u.spans() * knots.v.spans()), 1.0);
}

class Schedule {
 public:
  Schedule(HoldingMesh mesh, const KnotVector& knots_u, const KnotVector& knots_v,
           const CorrectionOptions& options, const Stage& stage, bool keep_start)
      : given_(mesh.size()),
        mesh_(std::move(mesh)),
        knots_(knots_u, knots_v, options.aspect),
        options_(options),
        stage_(stage),
        keep_start_(keep_start),
        hinge_weights_(equal_weights(knots_)),
        first_share_(options.start ? kLaterShare : kFirstShare),
        best_{options.start ? *options.start : Surface{}, {}, INFINITY} {}

  CorrectionRun run() {
    for (int first = 0; first == 0 || first < options_.rounds; first += kSeries) {
      refresh_mesh();
      if (!begin_series(first == 0)) return std::move(run_);
      const int end = std::min(options_.rounds, first + kSeries);
      for (round_ = first; round_ < end && !enough(); ++round_) {
        if (stopped()) return std::move(run_);
        if (!take_round()) break;
      }
      end_series(end - first);
      if (enough()) return std::move(run_);
    }
    if (options_.minimax_rounds > 0) lower_the_maximum();
    return std::move(run_);
  }

 private:
  /// A surface, and the parameters of the mesh that it belongs to.
  struct State {
    Surface surface;
    std::vector<double> uv;
    double penalised_error;
  };

  double share_of_rounds() const { return static_cast<double>(round_) / options_.rounds; }
  bool enough() const {
    return run_.surface && options_.keep_by.value > 0 && run_.error <= options_.keep_by.value &&
           run_.folded <= kMostBlurredFold;
  }
  bool stopped() {
    run_.stopped = stage_.report(share_of_rounds(), run_.rounds[run_.best].rms);
    return run_.stopped;
  }

  void refresh_mesh() { at_.emplace(mesh_, knots_, options_); }

  /// From the best of the last series; the first from the surface given or the plain fit.
  /// \return false where there is none
  bool begin_series(bool first) {
    if (best_.surface.empty()) {
      std::optional<Surface> plain = at_->plain_fit();
      if (!plain) return false;
      best_.surface = std::move(*plain);
    }
    surface_ = best_.surface;
    judgement_ = at_->judge(CellPolynomials(surface_));
    best_ = {surface_, mesh_.uv, judgement_.penalised_error};
    before_ = judgement_.penalised_error;
    share_ = first_share_;
    losses_ = 0;
    if (first) {
      CorrectionRound start;
      start.tangential = 1;
      record(start, judgement_);
      if (keep_start_) keep_if_best(judgement_, surface_);
    }
    return true;
  }

  /// \return false where the control points cannot be solved for
  bool take_round() {
    const CellPolynomials cells(surface_);
    CorrectionRound round;
    round.tangential = share_;
    round.held = at_->move(cells);
    at_->begin_round();
    const std::optional<Surface> full = whole_step(cells, round);
    if (!full) {
      run_.rounds.push_back(round);
      return false;
    }
    take_share_of(*full, round);
    record(round, judgement_);
    keep_if_best(judgement_, surface_);
    accept_or_return();
    return true;
  }

  std::optional<Surface> whole_step(const CellPolynomials& cells, CorrectionRound& round) {
    const HingeState hinge = at_->hinge(cells, hinge_weights_, round_ > 0, fairness_after(share_of_rounds()));
    round.hinge_rows = static_cast<Index>(hinge.rows.size());
    const double reweighting = 2 * round_ >= options_.rounds ? options_.reweighting : 0;
    return at_->step(cells, share_, hinge, at_->weights(reweighting, judgement_.squared));
  }

  /// Shortens the step up to three times while the penalised error rises, and takes the best trial.
  void take_share_of(const Surface& full, CorrectionRound& round) {
    Surface next = full;
    judgement_ = at_->judge(CellPolynomials(next));
    double share = 1;
    for (int shorter = 0; shorter < kShorterSteps && judgement_.penalised_error > before_; ++shorter) {
      share *= kShorter;
      Surface trial = between(surface_, full, share);
      Judgement of_trial = at_->judge(CellPolynomials(trial));
      if (!(of_trial.penalised_error < judgement_.penalised_error)) continue;
      judgement_ = std::move(of_trial);
      next = std::move(trial);
      round.step = share;
    }
    surface_ = std::move(next);
  }

  /// Charges less of the tangential distance after a gain, more after a loss. Goes back to the best of the series after a
  /// heavy loss or several in a row.
  void accept_or_return() {
    if (judgement_.penalised_error < best_.penalised_error)
      best_ = {surface_, mesh_.uv, judgement_.penalised_error};
    if (judgement_.penalised_error < before_ * kGains) {
      share_ = std::max(kLeastShare, share_ * kShrink);
      losses_ = 0;
    } else {
      share_ = std::min(1.0, share_ * kGrow);
      if (judgement_.penalised_error > kFarWorse * best_.penalised_error || ++losses_ > kLosses) {
        surface_ = best_.surface;
        at_->set_parameters(best_.uv);
        judgement_.penalised_error = best_.penalised_error;
        losses_ = 0;
      }
    }
    before_ = judgement_.penalised_error;
  }

  void end_series(int rounds) {
    at_->set_parameters(best_.uv);
    at_->move(CellPolynomials(best_.surface));
    first_share_ = std::max(kLeastShare, first_share_ * std::pow(kShrink, rounds));
  }

  void lower_the_maximum() {
    refresh_mesh();
    run_.stopped = !minimax_rounds(*at_, best_.surface, options_, hinge_weights_, stage_,
                                   [&](const CorrectionRound& round, const Judgement& j, const Surface& s) {
                                     record(round, j);
                                     keep_if_best(j, s);
                                     return !enough();
                                   });
  }

  void record(CorrectionRound round, const Judgement& judgement) {
    round.rms = judgement.rms;
    round.max = judgement.max;
    round.folded = judgement.folded;
    run_.rounds.push_back(round);
  }

  /// The surface of the round recorded last.
  void keep_if_best(const Judgement& judgement, const Surface& surface) {
    if (!(penalised_error(judgement.error, judgement.folded) < run_.penalised_error())) return;
    run_.surface = surface;
    run_.uv.assign(mesh_.uv.begin(), mesh_.uv.begin() + 2 * given_);
    run_.best = static_cast<Index>(run_.rounds.size()) - 1;
    run_.error = judgement.error;
    run_.folded = judgement.folded;
  }

  Index given_;  ///< vertices of the mesh given; those after them were added
  HoldingMesh mesh_;
  FixedKnots knots_;
  const CorrectionOptions& options_;
  const Stage& stage_;
  bool keep_start_;
  std::vector<double> hinge_weights_;  ///< by cell
  CorrectionRun run_;
  std::optional<MeshAtParameters> at_;

  int round_ = 0;
  double first_share_;   ///< of the tangential distance, as the next series begins
  State best_;           ///< of the series, by the RMS
  Surface surface_;      ///< of the last round
  Judgement judgement_;  ///< of that surface
  double before_ = 0;    ///< its penalised error
  double share_ = 0;     ///< of the tangential distance
  int losses_ = 0;       ///< in a row
};

}  // namespace

CorrectionRun run_correction(HoldingMesh mesh, const KnotVector& knots_u, const KnotVector& knots_v,
                             const CorrectionOptions& options, const Stage& stage, bool keep_start) {
  return Schedule(std::move(mesh), knots_u, knots_v, options, stage, keep_start).run();
}

std::optional<KnotJacobian> knot_jacobian(HoldingMesh mesh, const Surface& surface,
                                          const CorrectionOptions& options) {
  const FixedKnots knots(surface.knots_u(), surface.knots_v(), options.aspect);
  MeshAtParameters at(mesh, knots, options);
  const CellPolynomials cells(surface);
  at.move(cells);
  at.begin_round();
  std::vector<double> hinge_weights = equal_weights(knots);
  const HingeState hinge = at.hinge(cells, hinge_weights, false, kLaterFairness);
  return at.knot_jacobian(surface, kLeastShare, hinge, at.weights());
}

}  // namespace knotfit::correction
