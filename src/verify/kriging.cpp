#include "verify/kriging.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
namespace knotfit::verify {
namespace {

using Eigen::ArrayXd;
using Eigen::Lower;
using Eigen::MatrixXd;
using Eigen::Upper;
using Eigen::VectorXd;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kEpsilon = std::numeric_limits<double>::epsilon();
// Pivots of the QR below this share of the largest: polynomials that the points cannot tell apart.
// Monomials on 80 points of a half disk (a border) keep 1e-3; rows off their lines by 1e-6 lose 1e-9.
constexpr double kRank = 1e-6;
// Pivots of G below this share of its trace, 2^8 roundings: rounding makes up what it holds.
constexpr double kLeastPivot = 256 * kEpsilon;
// Weights in one stencil are held this near to each other, so that rows scaled by them stay comparable.
constexpr double kWeightRatio = 1e4;
// The nugget's grid: half decades of the kernel matrix's norm [METHOD 5.3].
constexpr int kNuggets = 37;
constexpr double kFirstNugget = -14, kNuggetStep = 0.5;

Index polynomials(int degree) {
  return (degree + 1) * (degree + 2) / 2;
}

}  // namespace

Index least_points(int degree) {
  return polynomials(degree) + std::max<Index>(8, polynomials(degree));
}

struct Kriging::Work {
  Index k = 0, q = 0;  // points, polynomials
  MatrixXd values;     // k x components, rows times the root of their weight where those differ
  ArrayXd x, y;
  double noise_unit = 1;  // noise of a row of `values` over that of a point of weight 1
  MatrixXd kernel;        // K, lower half
  VectorXd to_place;      // b
  MatrixXd basis;         // P
  Eigen::ColPivHouseholderQR<MatrixXd> qr;
  MatrixXd reflectors, block;  // Q = I - V T V^T
  MatrixXd projected;          // G = Q_2^T K Q_2, lower half; Q_2 spans the complement of P's columns
  MatrixXd turned;             // Q^T values; rows q.. are the projected values
  VectorXd alpha;              // Q_1^T a, a the least-norm weights that reproduce the polynomials at 0
  VectorXd right;              // c = Q_2^T (b - K a)
  double a_kernel = 0;         // a^T K a - 2 a^T b
  // What predict() leaves for surprise().
  MatrixXd factor, whitened;  // L and L^-1 of the projected values; no noise
  double sigma2 = 0, nugget = 0;
  // Tridiagonal form of G, computed where noise is asked for.
  bool tridiagonal = false;
  std::optional<Eigen::Tridiagonalization<MatrixXd>> form;
  VectorXd diagonal, off;
  MatrixXd rotated;  // projected values in its basis
  VectorXd rotated_right;

  void fill_basis(int degree);
  int choose_degree(int degree);
  void fill_kernel(int degree);
  void project();
  void apply_q_transposed(Eigen::Ref<MatrixXd> m) const {
    m.noalias() -=
        reflectors * (block.triangularView<Upper>().transpose() * (reflectors.transpose() * m)).eval();
  }
  void make_tridiagonal();
  double norm() const;
  double profile(double noise, double& nugget_variance) const;
  double solve_tridiagonal(const VectorXd& from, Eigen::Ref<VectorXd> products, double& least) const;
  double finish(double right_squares, double rounding, std::span<double> value) const;
};

Kriging::Kriging() : work_(std::make_unique<Work>()) {}
Kriging::~Kriging() = default;
Kriging::Kriging(Kriging&&) noexcept = default;

void Kriging::Work::fill_basis(int degree) {
  q = polynomials(degree);
  basis.resize(k, q);
  basis.col(0).setOnes();
  // Column of x^a y^b from that of one degree less.
  Index column = 1, before = 0;
  for (int d = 1; d <= degree; ++d) {
    for (int a = 0; a < d; ++a) basis.col(column++) = basis.col(before + a).array() * y;
    basis.col(column++) = basis.col(before + d - 1).array() * x;
    before += d;
  }
}

int Kriging::Work::choose_degree(int degree) {
  while (degree > 0 && k < least_points(degree)) --degree;
  for (; degree > 0; --degree) {
    fill_basis(degree);
    qr.setThreshold(kRank);
    qr.compute(basis);
    if (qr.rank() == q) return degree;
  }
  return 0;
}

void Kriging::Work::fill_kernel(int degree) {
  const double sign = degree % 2 == 0 ? -1 : 1;
  auto phi = [&](const auto& squared, auto out) {
    out = sign * squared.sqrt();
    for (int i = 0; i < degree; ++i) out *= squared;
  };
  kernel.resize(k, k);
  ArrayXd squared(k);
  for (Index j = 0; j < k; ++j) {
    const Index rest = k - j;
    squared.head(rest) = (x.tail(rest) - x[j]).square() + (y.tail(rest) - y[j]).square();
    phi(squared.head(rest), kernel.col(j).tail(rest).array());
  }
  to_place.resize(k);
  squared = x.square() + y.square();
  phi(squared, to_place.array());
}

// G and all that predictions share, from one QR of P.
void Kriging::Work::project() {
  // Q = H_0 H_1 ... = I - V T V^T (compact form, [Golub13 5.1.7]).
  reflectors = qr.matrixQR().triangularView<Eigen::UnitLower>();
  block.setZero(q, q);
  for (Index j = 0; j < q; ++j) {
    const double tau = qr.hCoeffs()[j];
    block(j, j) = tau;
    const VectorXd overlap = reflectors.leftCols(j).transpose() * reflectors.col(j);
    block.col(j).head(j) = -tau * (block.topLeftCorner(j, j).triangularView<Upper>() * overlap).eval();
  }
  // Q^T K Q = K - V X^T - X V^T with X = K V T - V (T^T V^T K V T)/2; only rows and columns q.. are needed.
  const MatrixXd kvt = (kernel.selfadjointView<Lower>() * reflectors) * block.triangularView<Upper>();
  const MatrixXd inner = block.triangularView<Upper>().transpose() * (reflectors.transpose() * kvt);
  const Index m = k - q;
  MatrixXd left(m, 2 * q), other(m, 2 * q);
  left.leftCols(q) = reflectors.bottomRows(m);
  left.rightCols(q) = kvt.bottomRows(m) - 0.5 * (reflectors.bottomRows(m) * inner);
  other.leftCols(q) = left.rightCols(q);
  other.rightCols(q) = left.leftCols(q);
  projected = kernel.bottomRightCorner(m, m);
  projected.triangularView<Lower>() -= left * other.transpose();

  turned = values;
  apply_q_transposed(turned);

  // R^T alpha = permuted p, p = (1, 0, ..., 0) at the place: the polynomials' values there.
  VectorXd p = VectorXd::Zero(q);
  p[0] = 1;
  alpha = qr.matrixR().topLeftCorner(q, q).triangularView<Upper>().transpose().solve(
      (qr.colsPermutation().transpose() * p).eval());
  MatrixXd a = MatrixXd::Zero(k, 1);  // Q (alpha, 0)
  a.topRows(q) = alpha;
  a -= reflectors * (block.triangularView<Upper>() * (reflectors.topRows(q).transpose() * alpha)).eval();
  const VectorXd ka = kernel.selfadjointView<Lower>() * a.col(0);
  MatrixXd c = to_place - ka;
  a_kernel = a.col(0).dot(ka - 2 * to_place);
  apply_q_transposed(c);
  right = c.col(0).tail(m);
  tridiagonal = false;
}

int Kriging::set(const Stencil& stencil, int degree) {
  Work& w = *work_;
  w.k = static_cast<Index>(stencil.x.size());
  w.x = Eigen::Map<const ArrayXd>(stencil.x.data(), w.k);
  w.y = Eigen::Map<const ArrayXd>(stencil.y.data(), w.k);
  degree = w.choose_degree(degree);
  if (degree == 0) return 0;
  w.values = Eigen::Map<const MatrixXd>(stencil.values.data(), stencil.components, w.k).transpose();
  w.fill_kernel(degree);
  const std::span<const double> weights = stencil.weights;
  w.noise_unit = weights.empty() ? 1 : 1 / std::sqrt(weights[0]);
  if (std::ranges::any_of(weights, [&](double t) { return t != weights[0]; })) {
    // Rows times the root of the weight have noise of one variance: the same problem with D K D, D P, D Z.
    const auto all = Eigen::Map<const ArrayXd>(weights.data(), w.k);
    const VectorXd d = all.max(all.maxCoeff() / kWeightRatio).sqrt();
    w.kernel = d.asDiagonal() * w.kernel * d.asDiagonal();
    w.to_place = d.asDiagonal() * w.to_place;
    w.values = d.asDiagonal() * w.values;
    w.qr.compute(d.asDiagonal() * w.basis);
    w.noise_unit = 1;
  }
  w.project();
  return degree;
}

// e and the last part of the value, from the square |L^-1 c|^2 and its rounding (as a share of it).
double Kriging::Work::finish(double right_squares, double rounding, std::span<double> value) const {
  for (std::size_t d = 0; d < value.size(); ++d)
    value[d] += alpha.dot(turned.col(static_cast<Index>(d)).head(q));
  const double start = a_kernel + nugget * alpha.squaredNorm();
  // The variance is what the stencil leaves of its start: never below the rounding of that difference, which
  // grows as the points crowd (on a mesh map it was 1e-3 of the start, and e a thousandth of the error).
  const double variance = std::max(start - right_squares, std::max(rounding, 4 * kEpsilon) * std::abs(start));
  const double e = std::sqrt(std::max(0.0, sigma2) * variance);
  return std::isfinite(e) ? e : kInfinity;
}

double Kriging::predict(double noise, std::span<double> value) {
  Work& w = *work_;
  const Index m = w.k - w.q;
  noise *= w.noise_unit;
  if (noise > 0) {
    w.make_tridiagonal();
    w.profile(noise, w.nugget);
    w.sigma2 = static_cast<double>(w.values.cols()) * noise * noise / w.nugget;
    VectorXd products(w.values.cols());
    double least = 0;
    const double right_squares = w.solve_tridiagonal(w.rotated_right, products, least);
    std::copy_n(products.data(), products.size(), value.begin());
    return w.finish(right_squares, kEpsilon * w.norm() / least, value);
  }
  // Points that nearly coincide leave eigenvalues below rounding: a nugget of that size keeps the
  // factor alive and moves nothing that the data could tell.
  const double trace = w.projected.trace();
  w.nugget = 0;
  for (double jitter = 0; jitter < 1e-9; jitter = jitter == 0 ? kEpsilon : 16 * jitter) {
    w.factor = w.projected;
    w.factor.diagonal().array() += jitter * trace;
    const Eigen::LLT<Eigen::Ref<MatrixXd>, Lower> factor(w.factor);
    if (factor.info() != Eigen::Success) continue;
    const double least = w.factor.diagonal().cwiseAbs2().minCoeff() / trace;
    if (least < kLeastPivot) continue;
    const VectorXd c = factor.matrixL().solve(w.right);
    w.whitened = factor.matrixL().solve(w.turned.bottomRows(m));
    for (Index d = 0; d < w.whitened.cols(); ++d) value[d] = c.dot(w.whitened.col(d));
    w.sigma2 = w.whitened.squaredNorm() / static_cast<double>(m);
    return w.finish(c.squaredNorm(), kEpsilon / least, value);
  }
  w.sigma2 = 0;
  std::ranges::fill(value, std::numeric_limits<double>::quiet_NaN());
  return kInfinity;
}

// Point i left out is off by W_i / B_ii, with the error bar sigma / sqrt(B_ii), B = Q_2 (G + g I)^-1 Q_2^T
// [Dubrule83]: their ratio needs row i of B and B Z alone.
double Kriging::surprise(Index nearest) {
  const Work& w = *work_;
  nearest = std::min(nearest, w.k);
  if (!(w.sigma2 > 0) || nearest <= 0) return 0;
  const Index m = w.k - w.q;
  MatrixXd units = MatrixXd::Zero(w.k, nearest);
  units.diagonal().setOnes();
  w.apply_q_transposed(units);
  MatrixXd rows = units.bottomRows(m);
  double most = 0;
  if (w.nugget > 0) {
    rows.applyOnTheLeft(w.form->matrixQ().adjoint());
    VectorXd products(w.rotated.cols());
    double least = 0;
    for (Index i = 0; i < nearest; ++i) {
      const double own = w.solve_tridiagonal(rows.col(i), products, least);
      most = std::max(most, products.squaredNorm() / own);
    }
  } else {
    w.factor.triangularView<Lower>().solveInPlace(rows);
    const MatrixXd products = w.whitened.transpose() * rows;
    for (Index i = 0; i < nearest; ++i)
      most = std::max(most, products.col(i).squaredNorm() / rows.col(i).squaredNorm());
  }
  const double ratio = std::sqrt(most / w.sigma2);
  return std::isfinite(ratio) ? ratio : kInfinity;
}

double Kriging::likely_noise() {
  work_->make_tridiagonal();
  double nugget = 0;
  return work_->profile(0, nugget) / work_->noise_unit;
}

void Kriging::Work::make_tridiagonal() {
  if (tridiagonal) return;
  const Index m = k - q;
  form.emplace(projected);
  diagonal = form->diagonal();
  off = form->subDiagonal();
  MatrixXd both(m, turned.cols() + 1);
  both.leftCols(turned.cols()) = turned.bottomRows(m);
  both.rightCols(1) = right;
  both.applyOnTheLeft(form->matrixQ().adjoint());
  rotated = both.leftCols(turned.cols());
  rotated_right = both.rightCols(1);
  tridiagonal = true;
}

// Gershgorin's bound on the largest eigenvalue of G.
double Kriging::Work::norm() const {
  double top = 0;
  for (Index i = 0; i < diagonal.size(); ++i)
    top = std::max(top, std::abs(diagonal[i]) + (i > 0 ? std::abs(off[i - 1]) : 0) +
                            (i < off.size() ? std::abs(off[i]) : 0));
  return top;
}

// Restricted likelihood of the nugget t = g over its grid, all of the grid side by side:
//   -2 log L = K log s^2 + d log det(G + t I) + y^T (G + t I)^-1 y / s^2,   K = d (k - q),
// from pivots of the tridiagonal G + t I. noise > 0 fixes s^2 = noise^2 / t, else s^2 is its most likely.
// Returns the standard deviation sqrt(t s^2) of the noise at the least.
double Kriging::Work::profile(double noise, double& most_likely) const {
  using Grid = Eigen::Array<double, kNuggets, 1>;
  const double top = norm();
  const Index m = diagonal.size(), components = rotated.cols();
  const double count = static_cast<double>(m * components);
  most_likely = top;
  if (!(top > 0)) return 0;
  Grid t, pivot, logs = Grid::Zero(), product = Grid::Ones(), squares = Grid::Zero();
  for (int i = 0; i < kNuggets; ++i) t[i] = std::pow(10, kFirstNugget + kNuggetStep * i);
  const double least = kEpsilon / 4;  // pivots are >= t but for rounding
  Eigen::Array<double, kNuggets, Eigen::Dynamic> forward(kNuggets, components);
  for (Index i = 0; i < m; ++i) {
    const double o = i > 0 ? off[i - 1] / top : 0;
    const Grid ratio = i > 0 ? Grid(o / pivot) : Grid(Grid::Zero());
    pivot = (diagonal[i] / top + t - o * ratio).max(least);
    for (Index d = 0; d < components; ++d) {
      forward.col(d) =
          i > 0 ? Grid(rotated(i, d) - ratio * forward.col(d)) : Grid(Grid::Constant(rotated(i, d)));
      squares += forward.col(d).square() / pivot;
    }
    product *= pivot;
    if (i % 8 == 7 || i == m - 1) logs += product.log(), product.setOnes();
  }
  double best = kInfinity, found = 0;
  for (int i = 0; i < kNuggets; ++i) {
    // In units of top: s^2 = variance / top.
    const double variance = noise > 0 ? noise * noise / t[i] : std::max(squares[i] / count, 1e-300);
    const double likelihood =
        count * std::log(variance) + static_cast<double>(components) * logs[i] + squares[i] / variance;
    // The least nugget there is means that none was found.
    if (likelihood < best)
      best = likelihood, most_likely = t[i] * top, found = i == 0 ? 0 : std::sqrt(t[i] * variance);
  }
  return found;
}

// products_d = c^T (G + nugget I)^-1 y_d for a vector c of the tridiagonal basis; returns
// c^T (G + nugget I)^-1 c and the least pivot.
double Kriging::Work::solve_tridiagonal(const VectorXd& from, Eigen::Ref<VectorXd> products,
                                        double& least) const {
  const double floor = kEpsilon / 4 * norm();
  double pivot = 0, c = 0, squares = 0;
  VectorXd z = VectorXd::Zero(rotated.cols());
  products.setZero();
  least = kInfinity;
  for (Index i = 0; i < diagonal.size(); ++i) {
    const double ratio = i > 0 ? off[i - 1] / pivot : 0;
    pivot = std::max(diagonal[i] + nugget - (i > 0 ? off[i - 1] * ratio : 0), floor);
    least = std::min(least, pivot);
    c = from[i] - ratio * c;
    squares += c * c / pivot;
    for (Index d = 0; d < z.size(); ++d) {
      z[d] = rotated(i, d) - ratio * z[d];
      products[d] += c * z[d] / pivot;
    }
  }
  return squares;
}

}  // namespace knotfit::verify
