#include "knotfit/fit_cloud.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/deadline.h"
#include "base/uniform_cell.h"
#include "data/spaced_sample.h"
#include "fit/error_measure.h"
#include "knotfit/distance.h"
#include "knotfit/exceptions.h"
#include "pipeline/distances.h"
#include "pipeline/message.h"
#include "pipeline/request.h"
#include "pipeline/verdict.h"
namespace knotfit {
namespace {

constexpr int kMostExchanges = 4;
constexpr Index kCells = 32;        // a direction of the square: the worst point of each joins
constexpr double kJoinAbove = 0.9;  // of the tolerance
constexpr double kTighter = 0.98;   // of what is missing

std::vector<Index> merged(std::vector<Index> sample, std::span<const Index> also) {
  sample.insert(sample.end(), also.begin(), also.end());
  std::sort(sample.begin(), sample.end());
  sample.erase(std::unique(sample.begin(), sample.end()), sample.end());
  return sample;
}

std::vector<double> gathered(std::span<const double> points, std::span<const Index> index) {
  std::vector<double> some;
  some.reserve(3 * index.size());
  for (const Index k : index) some.insert(some.end(), &points[3 * k], &points[3 * k] + 3);
  return some;
}

CloudMap lay_out(const CloudSource& cloud, std::span<const Index> index) {
  const std::vector<double> some = gathered(cloud.points, index);
  CloudMap map = cloud.lay(some, index);
  for (Index& line : map.mesh.vertex_line)
    if (line > 0) line = index[line - 1] + 1;
  map.points = static_cast<Index>(cloud.points.size()) / 3;
  map.sample = static_cast<Index>(index.size()) < map.points ? static_cast<Index>(index.size()) : 0;
  return map;
}

/// Numbers, from 0, of the points that are no vertices of real triangles.
std::vector<Index> beside(const ParameterizedPoints& fitted, Index count) {
  std::vector<char> there(static_cast<std::size_t>(count), 0);
  for (const Index line : fitted.source) there[line - 1] = 1;
  std::vector<Index> others;
  for (Index k = 0; k < count; ++k)
    if (there[k] == 0) others.push_back(k);
  return others;
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

/// One fit of a sample, judged by all.
class Rounds {
 public:
  Rounds(const CloudSource& cloud, Index most, const FitOptions& options, const CorrectionOptions& correction,
         const Control& control)
      : cloud_(cloud), most_(most), options_(options), correction_(correction), deadline_(control) {
    ParameterizedPoints all;
    all.dimension = 3;
    all.values.assign(cloud.points.begin(), cloud.points.end());
    all.uv.resize(2 * all.values.size() / 3);
    diagonal_ = bounding_diagonal(all);
    if (!options_.tolerance) return;
    asked_ = absolute_tolerance(*options_.tolerance, all, diagonal_, 0);
    options_.tolerance->relative = false;
    options_.tolerance->value = asked_.value;
  }

  CloudFit run(CloudMap map) {
    CloudFit last = fit(std::move(map)), best = last;
    int rounds = 1;
    while (rounds <= kMostExchanges && exchange(last)) {
      try {
        map = map_sample(cloud_, most_, also_);
      } catch (const InvalidInput&) {
        break;  // the points that joined make no sheet
      }
      last = fit(std::move(map));
      ++rounds;
      const FitResult &r = last.fit.result, &b = best.fit.result;
      if (r.reached || (!b.reached && r.measured < b.measured)) best = last;
    }
    best.rounds = rounds;
    return best;
  }

 private:
  CloudFit fit(CloudMap map) {
    CloudFit made;
    made.map = std::move(map);
    made.fit = fit_mesh(made.map.mesh, made.map.map, options_, correction_, deadline_.left());
    FitResult& r = made.fit.result;
    holds_on_sample_ = r.reached;
    mapped_ = made.fit.points.size();
    if (r.surface.empty() || r.status == Status::failed) return made;
    ParameterizedPoints all = made.fit.points;
    for (const Index k : beside(all, made.map.points)) {
      all.values.insert(all.values.end(), &cloud_.points[3 * k], &cloud_.points[3 * k] + 3);
      all.source.push_back(k + 1);
    }
    PointDistances distances = point_distances(r.surface, all.values);
    all.uv.insert(all.uv.end(), distances.uv.begin() + 2 * mapped_, distances.uv.end());
    r.sample = made.map.sample;
    r.diagonal = diagonal_;
    r.asked = asked_;
    r.tolerance = asked_.value;
    made.fit.correction.distance = distances.summary;
    if (!take_distances(made.fit, std::move(all), std::move(distances.signed_distances),
                        std::move(distances.uv))) {
      r.status = Status::failed;
      r.message = failed_check(r);
      return made;
    }
    const bool asked = asked_.value > 0, folded = folds_over(made.fit.correction.folds);
    r.measured = asked ? measured_error(r.errors, asked_) : r.error.max;
    const bool holds = asked && r.measured <= asked_.value;
    r.reached = holds && !folded;
    r.status = status_of({r.status, !has_size_or_knots(options_), asked, holds, false, folded});
    r.message = message_of(r, made.fit.points.size());
    return made;
  }

  /// Prepares the next round. \return false: there is none
  bool exchange(const CloudFit& last) {
    const FitResult& r = last.fit.result;
    if (!(asked_.value > 0) || r.reached || !holds_on_sample_ || r.status == Status::failed ||
        last.map.sample == 0 || deadline_.over())
      return false;
    if (!row_of(asked_.measure).every_point) {
      options_.tolerance->value *= kTighter * asked_.value / r.measured;
      return true;
    }
    const std::vector<Index> joining = worst_of_cells(last.fit, mapped_, kJoinAbove * asked_.value);
    also_ = merged(std::move(also_), joining);
    return !joining.empty();
  }

  const CloudSource& cloud_;
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

CloudMap map_sample(const CloudSource& cloud, Index most, std::span<const Index> also) {
  const auto n = static_cast<Index>(cloud.points.size()) / 3;
  if (cloud.points.size() % 3 != 0)
    throw InvalidInput(fmt::format("{} coordinates are no points in space", cloud.points.size()));
  for (std::size_t k = 0; k < cloud.points.size(); ++k)
    if (!(std::abs(cloud.points[k]) < 1e150))
      throw InvalidInput(
          fmt::format("point {} (from 1): coordinate {} is not finite or beyond what distances can hold",
                      k / 3 + 1, cloud.points[k]));
  if (most < 4) throw InvalidInput(fmt::format("a sample of {} points: a surface needs at least 4", most));
  for (const Index k : also)
    if (k < 0 || k >= n) throw InvalidInput(fmt::format("there is no point {} (from 0) among {}", k, n));
  return lay_out(cloud, merged(spaced_sample(cloud.points, most), also));
}

CloudFit fit_cloud(const CloudSource& cloud, Index most, CloudMap map, const FitOptions& options,
                   const CorrectionOptions& correction, const Control& control) {
  return Rounds(cloud, most, options, correction, control).run(std::move(map));
}

}  // namespace knotfit
