#include "correct/minimax_rounds.h"

#include <algorithm>
#include <cmath>
namespace knotfit::correction {
namespace {

constexpr double kEps = 3e-3;         // of the squares beside the powers
constexpr double kTangential = 1e-2;  // share of the distance in the tangent plane
constexpr double kPowers[] = {4, 6, 9, 13, 20, 30, 45};

/// q by point; 0 where it is no data.
std::vector<double> shares(const Batch& batch, const Verdict& verdict, double scale, bool capped) {
  std::vector<double> q(verdict.squared.size(), 0.0);
  for (std::size_t i = 0; i < q.size(); ++i)
    if (batch.is_data(i)) q[i] = std::sqrt(verdict.squared[i]) / scale;
  if (capped)
    for (double& x : q) x = std::min(x, 1.0);
  return q;
}

double phi_of(const std::vector<double>& q, double power) {
  double sum = 0;
  for (const double x : q) sum += std::pow(x, power) / power + kEps * x * x / 2;
  return sum;
}

}  // namespace

bool minimax_rounds(
    Batch& batch, Surface surface, const CorrectionOptions& options, std::vector<double>& hinge_weights,
    const Stage& stage,
    const std::function<bool(const CorrectionRound&, const Verdict&, const Surface&)>& visit) {
  const bool capped = options.keep_by.measure == ErrorMeasure::percentile;
  Verdict verdict = batch.judge(CellPolynomials(surface));
  double share = 1;
  std::size_t at = 0;
  int small = 0;
  for (int round = 0; round < options.minimax_rounds && at < std::size(kPowers); ++round) {
    if (stage.report(static_cast<double>(round) / options.minimax_rounds, verdict.rms)) return false;
    const double power = kPowers[at], scale = verdict.error;
    if (!(scale > 0)) break;
    const CellPolynomials now(surface);
    CorrectionRound record;
    record.tangential = kTangential;
    record.held = batch.move(now);
    batch.begin_round();
    verdict = batch.judge(now);
    const HingeState hinge = batch.hinge(now, hinge_weights, true, 0);
    record.hinge_rows = static_cast<Index>(hinge.rows.size());
    const std::vector<double> q = shares(batch, verdict, scale, capped);
    std::vector<double> factor(q.size());
    for (std::size_t i = 0; i < q.size(); ++i) factor[i] = std::pow(q[i], power - 2) + kEps;
    const std::optional<Surface> solved = batch.step(now, kTangential, hinge, batch.weights(factor));
    if (!solved) break;
    const double before = phi_of(q, power);
    double after = before;
    share = std::min(1.0, share / 0.36);
    for (int shorter = 0; shorter < 5; ++shorter, share *= 0.5) {
      const Surface trial = between(surface, *solved, share);
      Verdict of_trial = batch.judge(CellPolynomials(trial));
      after = phi_of(shares(batch, of_trial, scale, capped), power);
      if (!(after < before) || of_trial.folded > std::max(kMostBlurredFold, 1.2 * verdict.folded)) continue;
      surface = trial;
      verdict = std::move(of_trial);
      break;
    }
    record.step = share;
    record.rms = verdict.rms;
    record.max = verdict.max;
    record.folded = verdict.folded;
    if (!visit(record, verdict, surface)) return true;
    small = after > 0.97 * before ? small + 1 : 0;
    if (small > 0 || round % 3 == 2) ++at, small = 0;
  }
  return true;
}

}  // namespace knotfit::correction
