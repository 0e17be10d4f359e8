#include "search/mesh_sizes.h"

#include <algorithm>

#include "place/shares.h"
namespace knotfit {

using correction::CorrectionRun;

namespace {

constexpr double kNear = 2;  // times the tolerance: what the last rounds may gain
constexpr int kKnotSteps = 4;

}  // namespace

MeshSizes::MeshSizes(const correction::PreparedMesh& prepared, const SearchOptions& options, SearchRun& run,
                     const Control& control)
    : prepared_(prepared),
      options_(options),
      control_(control),
      run_(run),
      knots_(placement_method(options.method).traits.on_mesh),
      mesh_rounds_(prepared, options.degree_u, options.degree_v, run.tolerance(), control, true),
      rounds_(std::max(1, prepared.options().rounds * 2 / 5)) {}

InteriorKnots MeshSizes::uniform(const Spans& s) {
  return {uniform_knots(s.first - 1), uniform_knots(s.second - 1)};
}

// On uniform knots first: the path from size to size is the same for every tolerance.
const SizeOutcome& MeshSizes::solve(const Spans& spans, const Spans* from) {
  const Surface* start = from && failed_ && failed_->rounds.surface ? &*failed_->rounds.surface : nullptr;
  State now{spans, mesh_rounds_.correct(start ? failed_->rounds.uv : prepared_.first(), uniform(spans), start,
                                        rounds_)};
  SizeOutcome& outcome = outcomes_[spans];
  outcome.tries = 1;
  outcome.holds = settle(now);
  if (!outcome.holds) failed_ = std::move(now);
  return outcome;
}

bool MeshSizes::near(const CorrectionRun& r) const {
  return r.surface && r.error <= kNear * run_.tolerance().value && !interrupted();
}

CorrectionRun MeshSizes::polished(CorrectionRun base) const {
  return near(base) ? mesh_rounds_.polished(std::move(base)) : std::move(base);
}

MeshSizes::Verdict MeshSizes::verify(State& state) {
  if (!mesh_rounds_.meets(state.rounds)) return Verdict::misses;
  CorrectionResult result = prepared_.finish(state.rounds, false, control_);
  const double error = prepared_.error(result, run_.tolerance());
  state.rounds.error = std::min(state.rounds.error, error);
  if (!run_.holds(error)) return Verdict::misses;
  const bool holds = !folds_over(result.folds);
  if (holds || !verified_) verified_ = std::move(result);
  if (holds) held_ = state.rounds;
  if (!holds && folded_ == 0) folded_ = size(state.spans);
  return holds ? Verdict::holds : Verdict::folds;
}

bool MeshSizes::settle(const State& state) {
  State last{state.spans, polished(state.rounds)};
  CorrectionRun moved = state.rounds;
  const auto improve = [&](CorrectionRun next) {
    moved = std::move(next);
    CorrectionRun polish = polished(moved);
    if (polish.penalised_error() < last.rounds.penalised_error()) last.rounds = std::move(polish);
  };
  const auto may_improve = [&] { return !mesh_rounds_.meets(last.rounds) && near(state.rounds); };
  if (knots_ != MeshKnots::uniform && may_improve()) improve(mesh_rounds_.with_knots_anew(moved, rounds_));
  if (knots_ != MeshKnots::uniform && knots_ != MeshKnots::anew && may_improve())
    improve(mesh_rounds_.with_knots_moved(moved, kKnotSteps));
  Verdict verdict = verify(last);
  if (verdict == Verdict::folds && !interrupted()) {
    // The folds may have come with the parameters of smaller sizes.
    State anew{state.spans, polished(mesh_rounds_.correct(prepared_.first(), uniform(state.spans), nullptr,
                                                          prepared_.options().rounds))};
    verdict = verify(anew);
    if (verdict == Verdict::holds) last = std::move(anew);
  }
  const bool holds = verdict == Verdict::holds;
  if (!best_.rounds.surface || last.rounds.penalised_error() < best_.rounds.penalised_error()) best_ = last;
  const int size_u = state.spans.first + options_.degree_u, size_v = state.spans.second + options_.degree_v;
  outcomes_[state.spans].error = last.rounds.error;
  run_.list(size_u, size_v, last.rounds.error, holds);
  run_.show(
      {best_.rounds.error, best_.spans.first + options_.degree_u, best_.spans.second + options_.degree_v},
      fits());
  return holds;
}

void MeshSizes::make_fair() {
  CorrectionRun fair = mesh_rounds_.faired(held_);
  if (!mesh_rounds_.meets(fair)) return;
  CorrectionResult result = prepared_.finish(std::move(fair), false, control_);
  if (run_.holds(prepared_.error(result, run_.tolerance())) && !folds_over(result.folds) &&
      result.folds.normal_angle < verified_->folds.normal_angle)
    verified_ = std::move(result);
}

CorrectionResult MeshSizes::result() {
  return verified_ ? std::move(*verified_) : prepared_.finish(best_.rounds, false, control_);
}

}  // namespace knotfit
