// The points that knots are placed or moved on: the data, or a sample of it [METHOD 6.4].
#pragma once
#include <optional>

#include "data/sample.h"
#include "fit/fit_problem.h"
#include "place/sample_size.h"
#include "search/routes.h"
namespace knotfit {

class Searched {
 public:
  /// \param data            outlives this
  /// \param control_points  expected
  Searched(FitProblem& data, const RefineOptions& options, double control_points) : data_(data) {
    const Index size = sample_size(data.points().size(), control_points, options.engine);
    if (size == 0) return;
    sample_ = stratified_sample(data.points(), size);
    problem_.emplace(*sample_, options.degree_u, options.degree_v, search_fits(options));
  }
  Searched(const Searched&) = delete;  // the problem refers to the sample inside
  Searched& operator=(const Searched&) = delete;

  bool sampled() const { return sample_.has_value(); }
  const ParameterizedPoints& points() const { return sample_ ? *sample_ : data_.points(); }
  FitProblem& problem() { return problem_ ? *problem_ : data_; }
  /// Whether the points are enough for a surface of so many control points.
  bool enough_for(Index control_points) const {
    return !sampled() || points_needed(static_cast<double>(control_points)) <=
                             kAbout * static_cast<double>(sample_->size());
  }

 private:
  static constexpr double kAbout = 1.25;  ///< a sample has about as many points as were asked for
  FitProblem& data_;
  std::optional<ParameterizedPoints> sample_;
  std::optional<FitProblem> problem_;
};

}  // namespace knotfit
