// The table of feature measures: a new one is its value of FeatureMeasure and a row here.
#include <algorithm>
#include <array>

#include "place/context.h"
#include "place/shares.h"
namespace knotfit {
namespace {

/// Where there is no fit to measure, no place is better than another.
FeatureMap flat() {
  return {1, 1, {1.0}};
}

/// Of the surface that uniform knots give.
template <FeatureMap (*of_surface)(const Surface&, Index)>
FeatureMap on_pre_fit(PlacementContext& context) {
  FitProblem& problem = context.problem();
  return problem.solve(context.pre_fit_knots(0.6)) ? of_surface(problem.surface(), 200) : flat();
}

FeatureMap of_higher_degree(PlacementContext& context) {
  const FitProblem& problem = context.problem();
  LeastSquaresOptions fit;
  fit.smoothing = context.options().smoothing;
  fit.refinement_steps = 0;
  fit.estimate_condition = false;
  fit.energy = context.options().energy;
  FitProblem higher(problem.points(), std::min(problem.degree_u() + 1, kMaxDegree),
                    std::min(problem.degree_v() + 1, kMaxDegree), fit);
  const bool solved = higher.solve(context.pre_fit_knots(0.6));
  context.count_other_fits(1);
  return solved ? derivative_features(higher.surface()) : flat();
}

FeatureMap of_residual(PlacementContext& context) {
  FitProblem& problem = context.problem();
  const PlacementOptions& o = context.options();
  return problem.solve({uniform_knots(o.interior_u), uniform_knots(o.interior_v)})
             ? residual_features(problem.points(), problem.errors())
             : flat();
}

struct Row {
  FeatureMeasureInfo info;
  FeatureMap (*measure)(PlacementContext& context);
};

constexpr std::array kRows{
    Row{{FeatureMeasure::hessian, "hessian", "second derivatives of the surface of uniform knots"},
        on_pre_fit<hessian_features>},
    Row{{FeatureMeasure::curvature, "curvature", "curvature of the surface of uniform knots"},
        on_pre_fit<curvature_features>},
    Row{{FeatureMeasure::derivative, "derivative", "the derivatives that a spline of these degrees misses"},
        of_higher_degree},
    Row{{FeatureMeasure::residual, "residual", "errors of the surface of uniform knots of this size"},
        of_residual}};

constexpr auto kInfos = [] {
  std::array<FeatureMeasureInfo, kRows.size()> infos{};
  for (std::size_t i = 0; i < kRows.size(); ++i) infos[i] = kRows[i].info;
  return infos;
}();

}  // namespace

std::span<const FeatureMeasureInfo> feature_measures() {
  return kInfos;
}

FeatureMap measure_features(PlacementContext& context) {
  const auto row = std::find_if(kRows.begin(), kRows.end(),
                                [&](const Row& r) { return r.info.measure == context.options().feature; });
  return row->measure(context);
}

}  // namespace knotfit
