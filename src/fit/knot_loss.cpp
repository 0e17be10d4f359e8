#include "fit/knot_loss.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace knotfit {

KnotFunctional knot_functional(const KnotVector& knots, Index knot) {
  const int m = knots.degree();
  std::vector<double> u = knots.knots();
  const Index at = knot + m + 1;
  const double x = u[at];
  u.erase(u.begin() + at);
  const Index k = std::upper_bound(u.begin(), u.end(), x) - u.begin() - 1;  // u_k <= x < u_{k+1}
  // Inserting x gives c_i = a_i c'_i + (1 - a_i) c'_{i-1}: d^T c = 0 for all c' where
  // d_i a_i + d_{i+1} (1 - a_{i+1}) = 0.
  auto a = [&](Index i) { return i <= k - m ? 1.0 : i > k ? 0.0 : (x - u[i]) / (u[i + m] - u[i]); };
  KnotFunctional functional;
  functional.first = k - m;
  functional.entry = {1.0};
  for (Index i = k - m; i <= k && a(i) != 0; ++i)
    functional.entry.push_back(-functional.entry.back() * a(i) / (1 - a(i + 1)));
  double most = 0;
  for (double e : functional.entry) most = std::max(most, std::abs(e));
  for (double& e : functional.entry) e /= most;
  return functional;
}

std::vector<double> knot_losses(const MovingFit& fitted, bool along_v) {
  const BandedSystem& system = fitted.system();
  const std::vector<double>& net = fitted.net();
  const bool swapped = system.swapped(), along_outer = along_v == swapped;
  const Axis &along = along_outer ? system.outer() : system.inner(),
             &across = along_outer ? system.inner() : system.outer();
  const Index no = system.outer().functions(), ni = system.inner().functions(), n = no * ni,
              nj = across.functions();
  const int d = system.points().dimension();
  std::vector<double> losses(along.spans() - 1);
  for (Index l = 0; l < static_cast<Index>(losses.size()); ++l) {
    const KnotFunctional f = knot_functional(along.knots(), l);
    Panel constraint(n, nj);
    Eigen::MatrixXd z = Eigen::MatrixXd::Zero(nj, d);
    for (Index j = 0; j < nj; ++j)
      for (std::size_t i = 0; i < f.entry.size(); ++i) {
        const Index a = along_outer ? f.first + static_cast<Index>(i) : j,
                    b = along_outer ? j : f.first + static_cast<Index>(i);
        constraint(a * ni + b, j) = f.entry[i];
        for (int e = 0; e < d; ++e) z(j, e) += f.entry[i] * net[(swapped ? b * no + a : a * ni + b) * d + e];
      }
    system.matrix().forward(constraint);
    Eigen::MatrixXd s = Eigen::MatrixXd::Zero(nj, nj);
    constraint.add_gram(0, nj, 1, s.data());
    losses[l] = z.cwiseProduct(s.ldlt().solve(z)).sum();
  }
  return losses;
}

}  // namespace knotfit
