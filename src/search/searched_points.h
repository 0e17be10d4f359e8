// The points that knots are placed or moved on: the data, or a sample of it [METHOD 6.4].
#pragma once
#include <optional>

#include "data/sample.h"
#include "fit/fit_problem.h"
#include "place/sample_size.h"
#include "search/routes.h"
namespace knotfit {

class SearchedPoints {
 public:
  /// \param data     outlives this, and so do the options
  /// \param sampled  about so many points; 0: all of them (sample_size)
  SearchedPoints(FitProblem& data, const RefineOptions& options, Index sampled)
      : data_(data), options_(options), asked_(sampled) {
    if (sampled > 0) sample_ = stratified_sample(data.points(), sampled);
  }
  SearchedPoints(const SearchedPoints&) = delete;  // the problem refers to the sample inside
  SearchedPoints& operator=(const SearchedPoints&) = delete;

  bool sampled() const { return asked_ > 0; }
  const ParameterizedPoints& points() const { return sample_ ? *sample_ : data_.points(); }
  Index asked() const { return asked_; }  ///< as given
  /// The fits of a search on them.
  FitProblem& problem() {
    if (!sample_) return data_;
    if (!problem_) problem_.emplace(*sample_, options_.degree_u, options_.degree_v, search_fits(options_));
    return *problem_;
  }
  /// Whether the points are enough for a surface of so many control points.
  bool enough_for(Index control_points) const {
    return asked_ == 0 || points_needed(static_cast<double>(control_points)) <= static_cast<double>(asked_);
  }

 private:
  FitProblem& data_;
  const RefineOptions& options_;
  Index asked_;
  std::optional<ParameterizedPoints> sample_;
  std::optional<FitProblem> problem_;
};

}  // namespace knotfit
