#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "knotfit/basis.h"
#include "place/context.h"
#include "place/row_knots.h"
#include "place/shares.h"
namespace knotfit {
namespace {

using Matrix = Eigen::MatrixXd;

constexpr int kComponents = 12;  // of the rows kept: the ones of most variance
constexpr int kRounds = 120;     // of ADMM at one weight
constexpr int kWeights = 16;     // tried, each from the solution before

/// The lines of one direction as points of one curve: the rows' components, turned to their principal axes (a
/// rotation, which changes neither residuals nor norms of jumps) and cut to the first few.
Matrix curve_of_rows(const RowGrid& grid, bool along_v) {
  const Index lines = static_cast<Index>(grid.lines(along_v).size());
  const Index rows = static_cast<Index>(grid.lines(!along_v).size());
  const int d = grid.dimension;
  Matrix x(lines, rows * d);
  for (Index i = 0; i < lines; ++i)
    for (Index j = 0; j < rows; ++j)
      for (int e = 0; e < d; ++e) x(i, j * d + e) = grid.at(along_v, i, j)[e];
  x.rowwise() -= x.colwise().mean().eval();
  const Eigen::SelfAdjointEigenSolver<Matrix> eigen(x * x.transpose());
  const Index kept = std::min<Index>(kComponents, lines);
  Matrix y(lines, kept);
  for (Index c = 0; c < kept; ++c)
    y.col(c) = eigen.eigenvectors().col(lines - 1 - c) *
               std::sqrt(std::max(0.0, eigen.eigenvalues()[lines - 1 - c]));
  const double scale = y.cwiseAbs().maxCoeff();
  return scale > 0 ? Matrix(y / scale) : y;
}

/// Least squares with the norms of the jumps of the m-th derivative as penalty, by ADMM [Boyd11 6.4, group lasso].
class JumpLasso {
 public:
  JumpLasso(const std::vector<double>& t, const Matrix& data, int degree, const KnotVector& knots)
      : data_(data) {
    const Index n = knots.size(), inner = n - degree - 1;
    basis_ = Matrix::Zero(static_cast<Index>(t.size()), n);
    std::vector<double> b(degree + 1), table((degree + 1) * (degree + 1));
    for (std::size_t k = 0; k < t.size(); ++k) {
      const Index span = knots.find_span(t[k]);
      basis_functions(knots, span, t[k], b);
      for (int i = 0; i <= degree; ++i) basis_(static_cast<Index>(k), span - degree + i) = b[i];
    }
    jumps_ = Matrix::Zero(inner, n);
    const double h = (knots.last() - knots.first()) / static_cast<double>(inner + 1);
    const double unit = std::pow(h, degree);
    for (Index s = 0; s <= inner; ++s) {
      const Index span = s + degree;
      basis_derivatives(knots, span, knots[span] + h / 2, degree, table);
      for (int i = 0; i <= degree; ++i) {
        const double x = unit * table[degree * (degree + 1) + i];
        if (s < inner) jumps_(s, s + i) -= x;  // the knot after the span
        if (s > 0) jumps_(s - 1, s + i) += x;
      }
    }
    Matrix g = basis_.transpose() * basis_ + jumps_.transpose() * jumps_;
    g.diagonal().array() += 1e-10 * g.trace() / static_cast<double>(n);
    factor_.compute(g);
    right_ = basis_.transpose() * data_;
    z_ = Matrix::Zero(inner, data_.cols());
    y_ = z_;
  }
  /// Norm of the jump left at each knot; 0 where the penalty took it.
  std::vector<double> solve(double weight) {
    for (int round = 0; round < kRounds; ++round) {
      const Matrix c = factor_.solve(right_ + jumps_.transpose() * (z_ - y_));
      const Matrix j = jumps_ * c;
      for (Index k = 0; k < z_.rows(); ++k) {
        const Eigen::RowVectorXd a = j.row(k) + y_.row(k);
        const double norm = a.norm();
        z_.row(k) = norm > weight ? Eigen::RowVectorXd(a * (1 - weight / norm)) : Eigen::RowVectorXd(0 * a);
      }
      y_ += j - z_;
    }
    std::vector<double> norms;
    for (Index k = 0; k < z_.rows(); ++k) norms.push_back(z_.row(k).norm());
    return norms;
  }

 private:
  Matrix data_, basis_, jumps_, right_, z_, y_;
  Eigen::LDLT<Matrix> factor_;
};

struct Active {
  double place, jump;
};

/// Neighbouring knots that kept a jump stand for one: at the mean of their places by their jumps.
std::vector<Active> groups_of(const std::vector<double>& knots, const std::vector<double>& jumps) {
  std::vector<Active> groups;
  for (std::size_t k = 0; k < knots.size();) {
    if (!(jumps[k] > 0)) {
      ++k;
      continue;
    }
    // One rise and fall of the jumps is a group; a valley between two peaks parts them.
    double sum = 0, moment = 0;
    bool falling = false;
    do {
      sum += jumps[k];
      moment += jumps[k] * knots[k];
      ++k;
      if (k < knots.size() && jumps[k] < jumps[k - 1]) falling = true;
    } while (k < knots.size() && jumps[k] > 0 && !(falling && jumps[k] > jumps[k - 1]));
    groups.push_back({moment / sum, sum});
  }
  return groups;
}

std::vector<double> sparse_knots(const RowGrid& grid, bool along_v, int degree, int count,
                                 const std::function<bool()>& stop) {
  const std::vector<double>& t = grid.lines(along_v);
  const int most = static_cast<int>(t.size()) - degree - 1;
  if (count == 0 || most < 2) return uniform_knots(count);
  const int dense = std::min(most, std::max(60, 3 * count));
  const std::vector<double> knots = uniform_knots(dense);
  JumpLasso lasso(t, curve_of_rows(grid, along_v), degree, KnotVector::clamped(degree, knots));
  // From a weight that takes every jump downwards: the first that leaves enough groups.
  std::vector<Active> groups;
  double weight = 1;
  for (int i = 0; i < kWeights && !stop(); ++i, weight *= 0.4) {
    groups = groups_of(knots, lasso.solve(weight));
    if (static_cast<int>(groups.size()) >= count) break;
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Active& a, const Active& b) { return a.jump > b.jump; });
  groups.resize(std::min<std::size_t>(groups.size(), count));
  std::vector<double> result;
  result.reserve(groups.size());
  for (const Active& g : groups) result.push_back(g.place);
  return result;
}

}  // namespace

/// Knots where a sparse fit keeps its jumps [Kang15]. The paper: from a dense knot vector, the l1 norm of the jumps of
/// the m-th derivative is minimised under a bound on the error; knots with a jump are active; redundant ones are
/// removed and the rest adjusted. Here, for a direction of a surface, ours:
///  1. the lines of the rows are points of one curve whose components are all the rows' components, and a knot's jump
///     is one vector: its norm is penalised (group lasso), so that a knot line is kept or dropped as a whole;
///  2. the weight falls by 0.4 from 1 (data scaled to 1, jumps by h^m) until enough groups of neighbouring active
///     knots are left; ADMM, each weight from the solution before;
///  3. the groups of largest jumps are the knots, each at its jumps' mean place; where there are fewer groups than
///     knots wanted, the longest spans are halved.
Placement place_sparse(PlacementContext& context, int interior_u, int interior_v) {
  const RowGrid& grid = context.row_grid();
  const auto stop = [&] { return context.stop_requested(); };
  Placement placement;
  placement.knots = {sparse_knots(grid, false, context.problem().degree_u(), interior_u, stop),
                     sparse_knots(grid, true, context.problem().degree_v(), interior_v, stop)};
  settle_knots(placement.knots, interior_u, interior_v);
  placement.status = stop() ? PlacementStatus::stopped : PlacementStatus::converged;
  return placement;
}

}  // namespace knotfit
