#include "search/mesh_rounds.h"

#include <utility>

#include "fit/error_measure.h"
#include "place/levenberg.h"
#include "search/mesh_knots.h"
namespace knotfit {

using correction::CorrectionRun;

namespace {

InteriorKnots knots_of(const Surface& s) {
  return {s.knots_u().interior(), s.knots_v().interior()};
}

}  // namespace

MeshRounds::MeshRounds(const correction::PreparedMesh& prepared, int degree_u, int degree_v,
                       const Tolerance& tolerance, const Control& control, bool of_search)
    : prepared_(prepared),
      degree_u_(degree_u),
      degree_v_(degree_v),
      tolerance_(tolerance),
      control_(control),
      fairness_(of_search ? 0 : prepared.options().fairness),
      stage_(control_, "correction") {
  if (of_search) control_.progress = nullptr;
}

CorrectionRun MeshRounds::after(CorrectionRun earlier, CorrectionRun later) {
  later.best += static_cast<Index>(earlier.rounds.size());
  earlier.rounds.insert(earlier.rounds.end(), later.rounds.begin(), later.rounds.end());
  later.rounds = std::move(earlier.rounds);
  return later;
}

CorrectionOptions MeshRounds::options(int rounds, const Tolerance& keep_by) const {
  CorrectionOptions o = prepared_.options();
  o.rounds = rounds;
  o.keep_by = keep_by;
  o.fairness = fairness_;
  return o;
}

CorrectionRun MeshRounds::run(const std::vector<double>& uv, const InteriorKnots& knots, const Surface* start,
                              CorrectionOptions options, bool keep_start) const {
  const KnotVector u = KnotVector::clamped(degree_u_, knots.u), v = KnotVector::clamped(degree_v_, knots.v);
  if (start) options.start = carried_over(*start, u, v);
  CorrectionRun r = prepared_.run(uv, u, v, options, stage_, keep_start);
  fits_ += static_cast<long>(r.rounds.size());
  return r;
}

CorrectionRun MeshRounds::correct(const std::vector<double>& uv, const InteriorKnots& knots,
                                  const Surface* start, int rounds, double enough, int minimax) const {
  CorrectionOptions o = options(rounds, {enough, tolerance_.measure, tolerance_.share});
  o.minimax_rounds = minimax;
  return run(uv, knots, start, std::move(o));
}

CorrectionRun MeshRounds::faired(const CorrectionRun& base) const {
  constexpr int kRounds = 6;
  CorrectionOptions o = options(kRounds, {0, tolerance_.measure, tolerance_.share});
  o.fairness = prepared_.options().fairness;
  CorrectionRun fair = run(base.uv, knots_of(*base.surface), &*base.surface, std::move(o), false);
  return polished(after(base, std::move(fair)));
}

CorrectionRun MeshRounds::polished(CorrectionRun base) const {
  constexpr int kLastRounds = 6, kMinimaxRounds = 15;
  if (!base.surface || meets(base)) return base;
  CorrectionRun last =
      correct(base.uv, knots_of(*base.surface), &*base.surface, kLastRounds, tolerance_.value,
              row_of(tolerance_.measure).by_least_squares ? 0 : kMinimaxRounds);
  return last.penalised_error() < base.penalised_error() ? after(std::move(base), std::move(last))
                                                         : std::move(base);
}

CorrectionRun MeshRounds::with_knots_anew(CorrectionRun base, int rounds) const {
  if (!base.surface || base.stopped) return base;
  const Surface& s = *base.surface;
  const InteriorKnots knots = knots_anew(s, static_cast<int>(s.knots_u().interior().size()),
                                         static_cast<int>(s.knots_v().interior().size()));
  CorrectionRun next = correct(base.uv, knots, &s, rounds);
  return next.penalised_error() < base.penalised_error() ? after(std::move(base), std::move(next))
                                                         : std::move(base);
}

CorrectionRun MeshRounds::with_knots_moved(CorrectionRun base, int steps) const {
  constexpr int kTries = 3, kRoundsAStep = 3;
  constexpr double kMostStep = 0.3;  // of a logarithm of a span: the parameters have to follow
  if (!base.surface || base.stopped) return base;
  const Tolerance by_rms{.value = 0, .measure = ErrorMeasure::rms};
  CorrectionRun now = run(base.uv, knots_of(*base.surface), &*base.surface, options(1, by_rms));
  double mu = 0.1;
  bool moved = false;
  for (int step = 0; step < steps && now.surface && !stage_.over(); ++step) {
    const std::optional<KnotJacobian> jacobian = prepared_.knots(now.uv, *now.surface);
    if (!jacobian || jacobian->knots == 0) break;
    SpacingStep model(*jacobian, knots_of(*now.surface));
    bool accepted = false;
    for (int trial = 0; trial < kTries && !accepted; ++trial) {
      if (model.solve(mu, kMostStep)) {
        CorrectionRun next =
            run(now.uv, model.moved(kLeastMeshSpan), &*now.surface, options(kRoundsAStep, by_rms));
        accepted = next.penalised_error() < now.penalised_error() * (1 - 1e-3);
        if (accepted) now = after(std::move(now), std::move(next));
      }
      mu *= accepted ? 0.3 : 6;
    }
    if (!accepted) break;
    moved = true;
  }
  if (!moved || !now.surface) return base;
  CorrectionRun judged = correct(now.uv, knots_of(*now.surface), &*now.surface, 1);
  if (!(judged.penalised_error() < base.penalised_error())) return base;
  return after(std::move(base), after(std::move(now), std::move(judged)));
}

}  // namespace knotfit
