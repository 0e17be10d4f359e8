#include "correct/rounds.h"

#include <algorithm>
#include <cmath>

#include "correct/batch.h"
#include "correct/minimax_rounds.h"
namespace knotfit::correction {
namespace {

// Shares of the tangential distance, and how a round's success changes them.
constexpr double kFirstTangential = 0.3, kLaterTangential = 0.05, kLeastTangential = 1e-2, kShrink = 0.6,
                 kGrow = 4;
constexpr int kBatch = 6;         // rounds between halvings of long edges
constexpr double kLongest = 0.6;  // of an edge, in spans

/// What is charged of the fairness: ruffles form early, and the distances have the last word.
double fairness_after(double share_of_rounds) {
  return share_of_rounds < 0.5 ? 1 : kLaterFairness;
}

}  // namespace

Rounds run_rounds(HoldingMesh mesh, const KnotVector& knots_u, const KnotVector& knots_v,
                  const CorrectionOptions& options, const Stage& stage, bool keep_start) {
  const SpanTable u(knots_u), v(knots_v);
  const TangentSystem system(knots_u, knots_v, options.aspect);
  Rounds result;
  std::vector<double> hinge_weights(static_cast<std::size_t>(u.spans() * v.spans()), 1.0);
  std::optional<Surface> last = options.start;
  double first_tangential = options.start ? kLaterTangential : kFirstTangential;
  const Index given = mesh.size();
  const auto keep = [&](const Verdict& verdict, const Surface& surface) {
    if (!(merit_of(verdict.error, verdict.folded) < result.merit())) return;
    result.surface = surface;
    result.uv.assign(mesh.uv.begin(), mesh.uv.begin() + 2 * given);
    result.best = static_cast<Index>(result.rounds.size()) - 1;
    result.error = verdict.error;
    result.folded = verdict.folded;
  };
  const auto enough = [&] {
    return options.keep_by.value > 0 && result.error <= options.keep_by.value &&
           result.folded <= kMostBlurredFold;
  };
  for (int done = 0; done == 0 || done < options.rounds; done += kBatch) {
    const int rounds = std::min(options.rounds - done, kBatch);
    halve_long_edges(mesh, kLongest * u.mean_length(), kLongest * v.mean_length());
    Batch batch(mesh, system, u, v, options);
    batch.begin_round();
    Surface surface;
    {
      std::optional<Surface> start = last ? last : batch.plain_fit();
      if (!start) return result;
      surface = std::move(*start);
    }
    Verdict verdict = batch.judge(CellPolynomials(surface));
    Surface best = surface;
    std::vector<double> best_uv = mesh.uv;
    double best_merit = verdict.merit, merit = verdict.merit, tangential = first_tangential;
    if (done == 0) {
      result.rounds.push_back({verdict.rms, verdict.max, verdict.folded, 1, 1, 0, 0});
      if (keep_start) keep(verdict, surface);
    }
    int bad = 0;
    for (int round = 0; round < rounds && !enough(); ++round) {
      if (stage.report(static_cast<double>(done + round) / options.rounds, result.rounds[result.best].rms)) {
        result.stopped = true;
        return result;
      }
      const CellPolynomials now(surface);
      CorrectionRound record;
      record.tangential = tangential;
      record.held = batch.move(now);
      batch.begin_round();
      const HingeState hinge =
          batch.hinge(now, hinge_weights, done + round > 0,
                      fairness_after(static_cast<double>(done + round) / options.rounds));
      record.hinge_rows = static_cast<Index>(hinge.rows.size());
      const double reweighting = 2 * (done + round) >= options.rounds ? options.reweighting : 0;
      const std::optional<Surface> solved =
          batch.step(now, tangential, hinge, batch.weights(reweighting, verdict.squared));
      if (!solved) {
        result.rounds.push_back(record);
        break;
      }
      // Shorter steps while the merit rises; the least of them is taken.
      Surface next = *solved;
      verdict = batch.judge(CellPolynomials(next));
      double share = 1;
      for (int shorter = 0; shorter < 3 && verdict.merit > merit; ++shorter) {
        share *= 0.4;
        const Surface trial = between(surface, *solved, share);
        Verdict of_trial = batch.judge(CellPolynomials(trial));
        if (!(of_trial.merit < verdict.merit)) continue;
        verdict = std::move(of_trial);
        next = trial;
        record.step = share;
      }
      surface = std::move(next);
      record.rms = verdict.rms;
      record.max = verdict.max;
      record.folded = verdict.folded;
      result.rounds.push_back(record);
      keep(verdict, surface);
      if (verdict.merit < best_merit) {
        best_merit = verdict.merit;
        best = surface;
        best_uv = mesh.uv;
      }
      if (verdict.merit < merit * 1.0001) {
        tangential = std::max(kLeastTangential, tangential * kShrink);
        bad = 0;
      } else {
        tangential = std::min(1.0, tangential * kGrow);
        if (verdict.merit > 1.5 * best_merit || ++bad > 3) {
          surface = best;
          batch.set_parameters(best_uv);
          verdict.merit = best_merit;
          bad = 0;
        }
      }
      merit = verdict.merit;
    }
    batch.set_parameters(best_uv);
    batch.move(CellPolynomials(best));
    last = best;
    first_tangential = std::max(kLeastTangential, first_tangential * std::pow(kShrink, rounds));
    if (enough()) return result;
  }
  if (options.minimax_rounds > 0) {
    halve_long_edges(mesh, kLongest * u.mean_length(), kLongest * v.mean_length());
    Batch batch(mesh, system, u, v, options);
    batch.begin_round();
    result.stopped =
        !minimax_rounds(batch, *last, options, hinge_weights, stage,
                        [&](const CorrectionRound& record, const Verdict& verdict, const Surface& s) {
                          result.rounds.push_back(record);
                          keep(verdict, s);
                          return !enough();
                        });
  }
  return result;
}

std::optional<KnotJacobian> knot_jacobian(HoldingMesh mesh, const Surface& surface,
                                          const CorrectionOptions& options) {
  const SpanTable u(surface.knots_u()), v(surface.knots_v());
  const TangentSystem system(surface.knots_u(), surface.knots_v(), options.aspect);
  halve_long_edges(mesh, kLongest * u.mean_length(), kLongest * v.mean_length());
  Batch batch(mesh, system, u, v, options);
  const CellPolynomials cells(surface);
  batch.begin_round();
  batch.move(cells);
  batch.begin_round();
  std::vector<double> cell_weights(static_cast<std::size_t>(u.spans() * v.spans()), 1.0);
  const Verdict verdict = batch.judge(cells);
  const HingeState hinge = batch.hinge(cells, cell_weights, false, kLaterFairness);
  return batch.knot_jacobian(surface, kLeastTangential, hinge, batch.weights(0, verdict.squared));
}

}  // namespace knotfit::correction
