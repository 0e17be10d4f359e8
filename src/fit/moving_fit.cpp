#include "fit/moving_fit.h"

namespace knotfit {
namespace {

LeastSquaresOptions scattered(LeastSquaresOptions options) {
  options.use_grid = false;
  return options;
}

}  // namespace

MovingFit::MovingFit(const ParameterizedPoints& points, int degree_u, int degree_v,
                     const LeastSquaresOptions& options)
    : FitProblem(points, degree_u, degree_v, scattered(options)) {}

bool MovingFit::factor(const InteriorKnots& knots) {
  ++fits_;
  set_knots(knots);
  return system_->factor(u_, v_, options_.smoothing);
}

void MovingFit::restore(std::vector<double> net, std::vector<double> residual) {
  net_ = std::move(net);
  take(banded().set_residual(std::move(residual)));
}

KnotJacobian MovingFit::jacobian(bool golub_pereyra) const {
  return knot_jacobian(system(), net_, golub_pereyra);
}

void MovingFit::count_first(Index points) {
  counted_ = points;
  banded().count_first(points);
}

}  // namespace knotfit
