#include "search/mesh_search.h"

#include <algorithm>
#include <cmath>

#include "place/shares.h"
#include "search/mesh_rounds.h"
#include "search/mesh_sizes.h"
namespace knotfit {
namespace {

using correction::CorrectionRun;

constexpr double kGrow = 1.4, kStep = 1.05;  // of the product of the spans, coarse and fine
constexpr long kMostRounds = 6000;
constexpr Index kMostControlPoints = 5000;  // by default: the system's factor grows with the square
constexpr double kBeyond = 3;  // a size that holds but folds is passed by sizes up to this many times larger

/// The path from size to size, which does not depend on the tolerance: a looser one does not ask for more.
class MeshPath {
 public:
  MeshPath(MeshSizes& sizes, double ratio, Index most, Status above_most)
      : sizes_(sizes), ratio_(ratio), most_(most), above_most_(above_most) {}

  /// From small to the first size that holds. \return the status where none does
  Status grow() {
    std::optional<Spans> last;
    for (double product = 4;; product *= kGrow) {
      const Spans at = spans(product);
      if (last && at == *last) continue;
      if (last && sizes_.size(at) > most_) return folded_or(above_most_);
      if (last && sizes_.interrupted()) return folded_or(Status::limit_reached);
      if (sizes_.folded() > 0 &&
          static_cast<double>(sizes_.size(at)) > kBeyond * static_cast<double>(sizes_.folded()))
        return Status::folded;
      if (sizes_.solve(at, last ? &*last : nullptr).holds) {
        if (last) narrow_down(*last, product / kGrow, product);
        return Status::reached;
      }
      last = at;
    }
  }

 private:
  Spans spans(double product) const {
    const auto whole = [](double x) { return std::max(1, static_cast<int>(std::lround(x))); };
    return {whole(std::sqrt(product * ratio_)), whole(std::sqrt(product / ratio_))};
  }
  Status folded_or(Status otherwise) const { return sizes_.folded() > 0 ? Status::folded : otherwise; }

  /// Between a size that failed and one that holds.
  void narrow_down(Spans last, double low, double high) {
    const Index held = sizes_.size(spans(high));
    for (double product = low * kStep; product < high && !sizes_.interrupted(); product *= kStep) {
      const Spans at = spans(product);
      if (at == last || sizes_.size(at) >= held) continue;
      if (sizes_.solve(at, &last).holds) return;
      last = at;
    }
  }

  MeshSizes& sizes_;
  double ratio_;
  Index most_;
  Status above_most_;
};

std::string name_of(MeshKnots knots) {
  for (const PlacementMethod& m : placement_methods())
    if (m.traits.on_mesh == knots) return std::string(m.name);
  return "";
}

}  // namespace

MeshSearch search_mesh_sizes(const correction::PreparedMesh& prepared, const SearchOptions& options,
                             const Tolerance& tolerance, const Control& control) {
  SearchRun run(control, tolerance, options.max_fits > 0 ? options.max_fits : kMostRounds,
                prepared.frame().scale());
  MeshSizes sizes(prepared, options, run, control);
  const Index most = options.max_control_points > 0 ? options.max_control_points
                                                    : std::min(prepared.data() / 2, kMostControlPoints);
  const bool limited = options.max_control_points > 0 || most == kMostControlPoints;
  MeshPath path(sizes,
                std::clamp(options.span_ratio > 0 ? options.span_ratio : prepared.options().aspect, 0.2, 5.0),
                most, limited ? Status::limit_reached : Status::data_too_sparse);
  const Status status = path.grow();
  if (status == Status::reached && prepared.options().fairness > 0 && !sizes.interrupted()) sizes.make_fair();
  MeshSearch found;
  found.correction = sizes.result();
  found.status = run.cut_or(status);
  found.tried = run.tried();
  found.fits = sizes.fits();
  const MeshKnots knots = placement_method(options.method).traits.on_mesh;
  found.method = name_of(knots == MeshKnots::placed_once ? MeshKnots::moved : knots);
  return found;
}

MeshSearch fit_mesh_size(const correction::PreparedMesh& prepared, const SearchOptions& options, int size_u,
                         int size_v, const Tolerance& tolerance, const Control& control) {
  constexpr int kAnew = 2, kSteps = 12;
  const MeshRounds rounds(prepared, options.degree_u, options.degree_v, tolerance, control, false);
  const int all = prepared.options().rounds;
  const InteriorKnots uniform{uniform_knots(size_u - options.degree_u - 1),
                              uniform_knots(size_v - options.degree_v - 1)};
  // Moved knots may gain distance by a fold: the last stage that does not fold counts, else the one that does least.
  std::vector<CorrectionRun> stages{rounds.correct(prepared.first(), uniform, nullptr, all)};
  const auto add = [&](CorrectionRun next) {
    if (next.rounds.size() > stages.back().rounds.size()) stages.push_back(std::move(next));
  };
  const MeshKnots knots = placement_method(options.method).traits.on_mesh;
  if (knots == MeshKnots::anew || knots == MeshKnots::moved) {
    CorrectionRun best = stages.back();
    for (int k = 0; k < kAnew; ++k) best = rounds.with_knots_anew(std::move(best), (all + 1) / 2);
    add(std::move(best));
  }
  if (knots == MeshKnots::moved) add(rounds.with_knots_moved(stages.back(), kSteps));
  MeshSearch found;
  for (std::size_t k = stages.size(); k-- > 0;) {
    const bool first = k + 1 == stages.size();
    if (tolerance.value > 0) stages[k] = rounds.polished(std::move(stages[k]));
    CorrectionResult result = prepared.finish(stages[k], false, control);
    if (first || result.folds.blurred < found.correction.folds.blurred) found.correction = std::move(result);
    if (!folds_over(found.correction.folds) || control.stop.stop_requested()) break;
  }
  found.status = control.stop.stop_requested() ? Status::stopped : Status::fixed_size;
  found.fits = rounds.fits();
  found.method = options.method;
  return found;
}

}  // namespace knotfit
