#include "correct/minimax_rounds.h"

#include <algorithm>
#include <cmath>

#include "fit/error_measure.h"
namespace knotfit::correction {
namespace {

// Set, as [METHOD 8.10] has them.
constexpr double kEps = 3e-3;         // of the squares beside the powers
constexpr double kTangential = 1e-2;  // share of the distance in the tangent plane
constexpr double kPowers[] = {4, 6, 9, 13, 20, 30, 45};
constexpr int kRoundsAPower = 3;
constexpr double kLittle = 0.97;    // of Phi before: a smaller fall leads to the next power
constexpr double kLonger = 0.36;    // the first share tried is the last round's over this
constexpr int kTrials = 5;          // each half the one before it
constexpr double kMoreFolds = 1.2;  // times the folded share before: a step may lead there

/// q by point; 0 where the point is no data.
std::vector<double> shares(const MeshAtParameters& mesh, const Judgement& judgement, double scale,
                           bool capped) {
  std::vector<double> q(judgement.squared.size(), 0.0);
  for (std::size_t i = 0; i < q.size(); ++i)
    if (mesh.is_data(i)) q[i] = std::sqrt(judgement.squared[i]) / scale;
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
    MeshAtParameters& mesh, Surface surface, const CorrectionOptions& options,
    std::vector<double>& hinge_weights, const Stage& stage,
    const std::function<bool(const CorrectionRound&, const Judgement&, const Surface&)>& visit) {
  const bool capped = row_of(options.keep_by.measure).spares_worst;
  Judgement judgement = mesh.judge(CellPolynomials(surface));
  double share = 1;
  std::size_t at = 0;  // of the powers
  for (int round = 0; round < options.minimax_rounds && at < std::size(kPowers); ++round) {
    if (stage.report(static_cast<double>(round) / options.minimax_rounds, judgement.rms)) return false;
    const double power = kPowers[at], scale = judgement.error;
    if (!(scale > 0)) break;
    const CellPolynomials now(surface);
    CorrectionRound record;
    record.tangential = kTangential;
    record.held = mesh.move(now);
    mesh.begin_round();
    judgement = mesh.judge(now);
    const HingeState hinge = mesh.hinge(now, hinge_weights, true, 0);
    record.hinge_rows = static_cast<Index>(hinge.rows.size());
    const std::vector<double> q = shares(mesh, judgement, scale, capped);
    std::vector<double> factor(q.size());
    for (std::size_t i = 0; i < q.size(); ++i) factor[i] = std::pow(q[i], power - 2) + kEps;
    const std::optional<Surface> solved = mesh.step(now, kTangential, hinge, mesh.weights(factor));
    if (!solved) break;
    const double before = phi_of(q, power);
    double after = before;
    share = std::min(1.0, share / kLonger);
    for (int shorter = 0; shorter < kTrials; ++shorter, share *= 0.5) {
      const Surface trial = between(surface, *solved, share);
      Judgement of_trial = mesh.judge(CellPolynomials(trial));
      after = phi_of(shares(mesh, of_trial, scale, capped), power);
      if (!(after < before) || of_trial.folded > std::max(kMostBlurredFold, kMoreFolds * judgement.folded))
        continue;
      surface = trial;
      judgement = std::move(of_trial);
      break;
    }
    record.step = share;
    if (!visit(record, judgement, surface)) return true;
    if (after > kLittle * before || (round + 1) % kRoundsAPower == 0) ++at;
  }
  return true;
}

}  // namespace knotfit::correction
