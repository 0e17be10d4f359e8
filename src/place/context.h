// What the methods share while knots are placed for one set of points at one count or many.
#pragma once
#include <chrono>
#include <memory>
#include <optional>

#include "fit/moving_fit.h"
#include "knotfit/control.h"
#include "knotfit/place.h"
#include "place/row_grid.h"
namespace knotfit {

/// Knots of the error model on a fine net, and the masses (knot density times length) of its spans.
struct FineModel {
  InteriorKnots knots;
  std::vector<double> mass_u, mass_v;     ///< a span
  double integral_u = 1, integral_v = 1;  ///< I_u, I_v: integrals of the densities [METHOD 4.1]
  std::vector<double> breaks_u() const;
  std::vector<double> breaks_v() const;
};

class PlacementContext {
 public:
  /// \param problem  set to the degrees of `options`; outlives the context
  PlacementContext(FitProblem& problem, PlacementOptions options, const Control& control);
  PlacementContext(MovingFit& problem, PlacementOptions options, const Control& control);

  FitProblem& problem() { return problem_; }
  /// For knots that move: the problem, or one of its own of the same points where that cannot.
  MovingFit& moving();
  const PlacementOptions& options() const { return options_; }
  PlacementOptions& options() { return options_; }
  /// Stopped, or out of time.
  bool stop_requested() const { return control_.stop.stop_requested() || out_of_time(control_, start_); }

  /// The feature measure of the options, from a uniform pre-fit; made once.
  const FeatureMap& features();
  /// The error model's fine stage [METHOD 2.1]; made once.
  const FineModel& fine_model();
  void set_fine_model(FineModel model) { fine_model_ = std::move(model); }
  /// The points as rows; made once. What it did to them becomes a note of the placement.
  const RowGrid& row_grid();
  /// Linear fits made on problems of its own.
  long other_fits() const { return other_fits_ + (own_moving_ ? own_moving_->fits() : 0); }
  void count_other_fits(long fits) { other_fits_ += fits; }
  /// Sentences for the user, gathered while placing.
  const std::vector<std::string>& notes() const { return notes_; }
  void note(std::string sentence);
  /// Uniform knots of a pre-fit: clamp(share * sqrt(points), 8, 60) spans a direction, fewer where the points are
  /// few. Points on a handful of lines of one direction, as a curve's strip has them, get one span across the lines
  /// and those of a row along them.
  InteriorKnots pre_fit_knots(double share) const;

 private:
  FitProblem& problem_;
  MovingFit* moving_ = nullptr;  ///< the problem, where it is one
  std::optional<MovingFit> own_moving_;
  PlacementOptions options_;
  const Control& control_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::optional<FeatureMap> features_;
  std::optional<FineModel> fine_model_;
  std::optional<RowGrid> row_grid_;
  std::vector<std::string> notes_;
  long other_fits_ = 0;
};

/// The feature measure of the options; feature_measures.cpp lists them.
FeatureMap measure_features(PlacementContext& context);

/// The body of a method: knots at counts (interior_u, interior_v).
using PlaceFunction = Placement (*)(PlacementContext& context, int interior_u, int interior_v);

// Every method; methods.cpp lists them.
Placement place_uniform(PlacementContext& context, int interior_u, int interior_v);
Placement place_quantile(PlacementContext& context, int interior_u, int interior_v);
Placement place_criterion(PlacementContext& context, int interior_u, int interior_v);
Placement place_error_model(PlacementContext& context, int interior_u, int interior_v);
Placement place_optimal(PlacementContext& context, int interior_u, int interior_v);
Placement place_nktp(PlacementContext& context, int interior_u, int interior_v);
Placement place_dominant(PlacementContext& context, int interior_u, int interior_v);
Placement place_averaging(PlacementContext& context, int interior_u, int interior_v);
Placement place_equal_share(PlacementContext& context, int interior_u, int interior_v);
Placement place_centroid(PlacementContext& context, int interior_u, int interior_v);
Placement place_derivative_share(PlacementContext& context, int interior_u, int interior_v);
Placement place_fitpack(PlacementContext& context, int interior_u, int interior_v);
Placement place_sparse(PlacementContext& context, int interior_u, int interior_v);
Placement place_full_lspia(PlacementContext& context, int interior_u, int interior_v);
Placement place_conjugate_gradient(PlacementContext& context, int interior_u, int interior_v);

/// The error model iterated at the counts of `start`; the best round by RMS.
InteriorKnots error_model_from(PlacementContext& context, const InteriorKnots& start, int rounds);

/// The body of the method of that name. \throws InvalidInput  unknown; lists those there are
PlaceFunction find_method(std::string_view name);

}  // namespace knotfit
