#include "place/damped_step.h"

#include <Eigen/Dense>
namespace knotfit {
namespace {

using Vector = Eigen::Map<const Eigen::VectorXd>;

using Square = Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

Square square(std::span<const double> matrix, Eigen::Index n) {
  return {matrix.data(), n, n};
}

}  // namespace

bool damped_step(std::span<const double> matrix, std::span<const double> gradient, double mu, double most,
                 std::span<double> step) {
  const auto n = static_cast<Eigen::Index>(gradient.size());
  const Square h = square(matrix, n);
  const double trace = h.trace();
  Eigen::MatrixXd damped = h;
  damped.diagonal().array() +=
      mu * (h.diagonal().array() + 1e-6 * trace / static_cast<double>(n)) + 1e-13 * trace;
  Eigen::Map<Eigen::VectorXd> s(step.data(), n);
  s = -damped.ldlt().solve(Vector(gradient.data(), n));
  const double largest = s.cwiseAbs().maxCoeff();
  if (!std::isfinite(largest)) return false;
  if (largest > most) s *= most / largest;
  return true;
}

double predicted_fall(std::span<const double> matrix, std::span<const double> gradient,
                      std::span<const double> step) {
  const auto n = static_cast<Eigen::Index>(gradient.size());
  const Vector s(step.data(), n), g(gradient.data(), n);
  return -(2 * s.dot(g) + s.dot(square(matrix, n) * s));
}

}  // namespace knotfit
