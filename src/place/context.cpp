#include "place/context.h"

#include <algorithm>
#include <cmath>

#include "place/error_model.h"
#include "place/shares.h"
namespace knotfit {

std::vector<double> FineModel::breaks_u() const {
  return with_ends(knots.u);
}
std::vector<double> FineModel::breaks_v() const {
  return with_ends(knots.v);
}

PlacementContext::PlacementContext(FitProblem& problem, PlacementOptions options, const Control& control)
    : problem_(problem), options_(std::move(options)), control_(control) {
  if (!options_.user_features.empty()) validate(options_.user_features);
}

int PlacementContext::pre_fit_spans(double share) const {
  const double root = std::sqrt(static_cast<double>(problem_.points().size()));
  const int most = std::max(1, static_cast<int>(root) - std::max(problem_.degree_u(), problem_.degree_v()));
  return std::min(std::clamp(static_cast<int>(share * root), 8, 60), most);
}

const FeatureMap& PlacementContext::features() {
  if (!features_) {
    if (!options_.user_features.empty()) {
      features_ = options_.user_features;
    } else {
      const int interior = pre_fit_spans(0.6) - 1;
      if (problem_.solve({uniform_knots(interior), uniform_knots(interior)})) {
        const Surface s = problem_.surface();
        features_ =
            options_.feature == FeatureMeasure::curvature ? curvature_features(s) : hessian_features(s);
      } else {  // no fit to measure: no place is better than another
        features_ = FeatureMap{1, 1, {1.0}};
      }
    }
  }
  return *features_;
}

const FineModel& PlacementContext::fine_model() {
  if (!fine_model_) fine_model_ = fit_fine_model(problem_, pre_fit_spans(0.4) - 1, control_);
  return *fine_model_;
}

}  // namespace knotfit
