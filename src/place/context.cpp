#include "place/context.h"

#include <algorithm>
#include <cmath>
#include <set>

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

PlacementContext::PlacementContext(MovingFit& problem, PlacementOptions options, const Control& control)
    : PlacementContext(static_cast<FitProblem&>(problem), std::move(options), control) {
  moving_ = &problem;
}

MovingFit& PlacementContext::moving() {
  if (moving_) return *moving_;
  if (own_moving_) return *own_moving_;
  LeastSquaresOptions fit;
  fit.smoothing = options_.smoothing;
  fit.refinement_steps = 0;
  fit.estimate_condition = false;
  fit.energy = options_.energy;
  return own_moving_.emplace(problem_.points(), problem_.degree_u(), problem_.degree_v(), fit);
}

InteriorKnots PlacementContext::pre_fit_knots(double share) const {
  const ParameterizedPoints& points = problem_.points();
  constexpr std::size_t kFew = 8;  // lines
  const auto few_lines = [&](int axis) -> double {
    std::set<double> lines;
    for (Index k = 0; k < points.size() && lines.size() <= kFew; ++k) lines.insert(points.uv[2 * k + axis]);
    return lines.size() <= kFew ? static_cast<double>(lines.size()) : 0;
  };
  const double n = static_cast<double>(points.size()), root = std::sqrt(n);
  const double lines_u = few_lines(0), lines_v = few_lines(1);
  const auto knots = [&](double lines, int degree) {
    const int most = std::max(1, static_cast<int>(lines) - degree);
    return uniform_knots(std::min(std::clamp(static_cast<int>(share * lines), 8, 60), most) - 1);
  };
  if (lines_u > 0 || lines_v > 0)
    return {lines_u > 0 ? std::vector<double>{} : knots(n / lines_v, problem_.degree_u()),
            lines_v > 0 ? std::vector<double>{} : knots(n / lines_u, problem_.degree_v())};
  const int degree = std::max(problem_.degree_u(), problem_.degree_v());
  return {knots(root, degree), knots(root, degree)};
}

const FeatureMap& PlacementContext::features() {
  if (!features_)
    features_ = options_.user_features.empty() ? measure_features(*this) : options_.user_features;
  return *features_;
}

const RowGrid& PlacementContext::row_grid() {
  if (!row_grid_) {
    row_grid_ = make_row_grid(problem_, pre_fit_knots(0.6));
    if (!row_grid_->note.empty()) note(row_grid_->note);
  }
  return *row_grid_;
}

void PlacementContext::note(std::string sentence) {
  if (std::find(notes_.begin(), notes_.end(), sentence) == notes_.end())
    notes_.push_back(std::move(sentence));
}

const FineModel& PlacementContext::fine_model() {
  if (!fine_model_) fine_model_ = fit_fine_model(problem_, pre_fit_knots(0.4), control_);
  return *fine_model_;
}

}  // namespace knotfit
