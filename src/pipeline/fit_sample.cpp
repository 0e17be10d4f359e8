#include "knotfit/fit_sample.h"

#include <algorithm>
#include <cmath>

#include "base/deadline.h"
#include "base/uniform_cell.h"
#include "fit/error_measure.h"
#include "knotfit/distance.h"
#include "knotfit/exceptions.h"
#include "pipeline/corrected_fit.h"
#include "pipeline/mesh_verdict.h"
#include "pipeline/request.h"
namespace knotfit {
namespace {

constexpr int kMostExchanges = 4;
constexpr Index kCells = 32;        // a direction of the square: the worst point of each joins
constexpr double kJoinAbove = 0.9;  // of the tolerance
constexpr double kTighter = 0.99;   // of what is missing
constexpr double kTightest = 0.97;  // a round, where points join

/// Numbers, from 0, of the points that are no vertices of real triangles.
std::vector<Index> beside(const ParameterizedPoints& fitted, Index count) {
  std::vector<char> there(static_cast<std::size_t>(count), 0);
  for (const Index line : fitted.source) there[line - 1] = 1;
  std::vector<Index> others;
  for (Index k = 0; k < count; ++k)
    if (there[k] == 0) others.push_back(k);
  return others;
}

/// Of the vertices of the whole mesh: those of their points. Vertices that are no points, of virtual faces alone, have none
/// that counts.
std::vector<double> parameters_of_vertices(const MeshFit& fit, const Mesh& mesh) {
  std::vector<Index> at(fit.points.source.size() + 1, -1);
  for (Index k = 0; k < fit.points.size(); ++k) at[fit.points.source[k]] = k;
  std::vector<double> uv(static_cast<std::size_t>(2 * mesh.vertex_count()), 0.5);
  for (Index v = 0; v < mesh.vertex_count(); ++v)
    if (const Index number = mesh.vertex_line[v]; number > 0)
      std::copy_n(&fit.points.uv[2 * at[number]], 2, &uv[2 * v]);
  return uv;
}

/// Of each cell of the square the worst of the points from `first` on, where it is beyond what is allowed: its number in the
/// cloud, from 0.
std::vector<Index> worst_of_cells(const MeshFit& fit, Index first, double allowed) {
  std::vector<Index> worst(static_cast<std::size_t>(kCells * kCells), -1);
  for (Index k = first; k < fit.points.size(); ++k) {
    const double error = fit.result.errors[k];
    if (!(error > allowed)) continue;
    Index& w = worst[uniform_cell(fit.foot_uv[2 * k], kCells) * kCells +
                     uniform_cell(fit.foot_uv[2 * k + 1], kCells)];
    if (w < 0 || error > fit.result.errors[w]) w = k;
  }
  std::vector<Index> joining;
  for (const Index k : worst)
    if (k >= 0) joining.push_back(fit.points.source[k] - 1);
  return joining;
}

/// Fits samples that grow, each judged by all.
class SampleRun {
 public:
  SampleRun(const SampleSource& source, Index most, const FitOptions& options,
            const CorrectionOptions& correction, const Control& control)
      : source_(source), most_(most), options_(options), correction_(correction), deadline_(control) {
    ParameterizedPoints all;
    all.dimension = 3;
    all.values.assign(source.points.begin(), source.points.end());
    all.uv.resize(2 * all.values.size() / 3);
    diagonal_ = bounding_diagonal(all);
    if (!options_.tolerance) return;
    asked_ = absolute_tolerance(*options_.tolerance, all, diagonal_, 0);
    options_.tolerance->relative = false;
    options_.tolerance->value = asked_.value;
  }

  SampleFit run(CloudMap map) {
    SampleFit best = fit(std::move(map));
    bool again = exchange(best);
    int rounds = 1;
    while (again && rounds <= kMostExchanges) {
      try {
        map = map_sample(source_, most_, also_);
      } catch (const InvalidInput&) {
        break;  // the points that joined make no sheet
      }
      SampleFit next = fit(std::move(map));
      ++rounds;
      again = exchange(next);
      const FitResult &r = next.fit.result, &b = best.fit.result;
      if (r.reached || (!b.reached && r.measured < b.measured)) best = std::move(next);
    }
    best.rounds = rounds;
    return best;
  }

 private:
  SampleFit fit(CloudMap map) {
    SampleFit made;
    made.map = std::move(map);
    CorrectedFit found = corrected_fit(made.map.mesh, made.map.map, options_, correction_, deadline_.left());
    made.fit = std::move(found.fit);
    FitResult& r = made.fit.result;
    r.sample = made.map.sample;
    r.diagonal = diagonal_;
    holds_on_sample_ = holds_tolerance(made.fit) && !folds_over(made.fit.correction.folds);
    mapped_ = made.fit.points.size();
    if (r.surface.empty() || r.status == Status::failed) return made;
    r.asked = asked_;
    r.tolerance = asked_.value;
    ParameterizedPoints all = made.fit.points;
    for (const Index k : beside(all, made.map.points)) {
      all.values.insert(all.values.end(), &source_.points[3 * k], &source_.points[3 * k] + 3);
      all.source.push_back(k + 1);
    }
    PointDistances distances = point_distances(r.surface, all.values);
    all.uv.insert(all.uv.end(), distances.uv.begin() + 2 * mapped_, distances.uv.end());
    made.fit.correction.distance = distances.summary;
    if (!take_distances(made.fit, std::move(all), std::move(distances.signed_distances),
                        std::move(distances.uv)))
      return made;
    if (source_.mesh && !deadline_.stopped())
      made.fit.to_mesh =
          mesh_distances(r.surface, *source_.mesh, parameters_of_vertices(made.fit, *source_.mesh), 300);
    give_verdict(made.fit, options_);
    return made;
  }

  /// Prepares the next round. \return false: there is none
  bool exchange(const SampleFit& last) {
    const FitResult& r = last.fit.result;
    if (!(asked_.value > 0) || r.reached || !holds_on_sample_ || r.status == Status::failed ||
        last.map.sample == 0 || deadline_.over())
      return false;
    const bool every_point = row_of(asked_.measure).every_point;
    // What is missing: of a maximum a little, since what joins brings the rest.
    const double missing = asked_.value / r.measured;
    options_.tolerance->value *= std::max(kTighter * missing, every_point ? kTightest : 0);
    if (!every_point) return true;
    const std::vector<Index> joining = worst_of_cells(last.fit, mapped_, kJoinAbove * asked_.value);
    also_.insert(also_.end(), joining.begin(), joining.end());
    return !joining.empty();
  }

  const SampleSource& source_;
  Index most_;
  FitOptions options_;
  CorrectionOptions correction_;
  Deadline deadline_;
  double diagonal_ = 0;
  Tolerance asked_{.value = 0};
  std::vector<Index> also_;
  // Of the last round:
  bool holds_on_sample_ = false;
  Index mapped_ = 0;  ///< the first so many points are of the map
};

}  // namespace

SampleFit fit_sample(const SampleSource& source, Index most, CloudMap map, const FitOptions& options,
                     const CorrectionOptions& correction, const Control& control) {
  return SampleRun(source, most, options, correction, control).run(std::move(map));
}

}  // namespace knotfit
