#include "fit/curve_problem.h"

#include <Eigen/Sparse>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "knotfit/basis.h"
#include "knotfit/fit_least_squares.h"
#include "solve/gauss_rule.h"
namespace knotfit {
namespace {

using Sparse = Eigen::SparseMatrix<double>;

KnotVector periodic_knots(int degree, const std::vector<double>& period) {
  const Index n = static_cast<Index>(period.size());
  std::vector<double> knots;
  for (Index j = 0; j <= n + 2 * degree; ++j) {
    const Index i = j - degree, turn = (i >= 0 ? i : i - n + 1) / n;
    knots.push_back(period[i - turn * n] + static_cast<double>(turn));
  }
  return KnotVector(degree, std::move(knots));
}

/// tr-scaled second derivatives (first, for degree 1), squared and integrated.
Sparse energy(const KnotVector& knots, Index n) {
  const int m = knots.degree(), order = m > 1 ? 2 : 1, w = m + 1;
  const GaussRule& rule = gauss_rule(m);
  std::vector<Eigen::Triplet<double>> entries;
  std::vector<double> table((order + 1) * w);
  for (Index s = m; s < knots.size(); ++s) {
    const double h = knots[s + 1] - knots[s];
    if (!(h > 0)) continue;
    for (std::size_t g = 0; g < rule.node.size(); ++g) {
      basis_derivatives(knots, s, knots[s] + h * (rule.node[g] + 1) / 2, order, table);
      for (int a = 0; a < w; ++a)
        for (int b = 0; b < w; ++b)
          entries.emplace_back((s - m + a) % n, (s - m + b) % n,
                               rule.weight[g] * h / 2 * table[order * w + a] * table[order * w + b]);
    }
  }
  Sparse j(n, n);
  j.setFromTriplets(entries.begin(), entries.end());
  return j;
}

/// The data energy of the curve of a strip, which counts twice what the curve counts once.
struct HeldTerms {
  Sparse matrix;
  Eigen::MatrixXd right;
  HeldTerms(const DataEnergy& energy, const KnotVector& knots, Index n, double factor, int dimension)
      : matrix(n, n), right(Eigen::MatrixXd::Zero(n, dimension)) {
    const int m = knots.degree(), w = m + 1, most = std::min(m, 2);
    const GaussRule& rule = gauss_rule(m);
    std::vector<Eigen::Triplet<double>> entries;
    std::vector<double> table((most + 1) * w), weight(DataEnergy::kKinds), goal(energy.goal_size()),
        scratch(energy.scratch_size());
    for (Index s = m; s < knots.size(); ++s) {
      const double low = knots[s], h = knots[s + 1] - low;
      if (!(h > 0)) continue;
      energy.integrate(low, low + h, 0, 1, weight.data(), goal.data(), scratch.data());
      for (int order = 1; order <= most; ++order) {
        const int kind = order == 1 ? DataRaster::kU : DataRaster::kUu;
        Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(w, w);                       // means of products
        Eigen::MatrixXd legendre = Eigen::MatrixXd::Zero(DataEnergy::kOrder, w);  // coefficients
        for (std::size_t g = 0; g < rule.node.size(); ++g) {
          basis_derivatives(knots, s, low + h * (rule.node[g] + 1) / 2, order, table);
          const Eigen::Map<const Eigen::RowVectorXd> of(table.data() + order * w, w);
          gram += rule.weight[g] / 2 * of.transpose() * of;
          legendre.row(0) += rule.weight[g] / 2 * of;
          legendre.row(1) += 1.5 * rule.weight[g] * rule.node[g] * of;
        }
        for (int a = 0; a < w; ++a) {
          const Index row = (s - m + a) % n;
          for (int b = 0; b < w; ++b)
            entries.emplace_back(row, (s - m + b) % n, factor / 2 * weight[kind] * gram(a, b));
          for (int x = 0; x < DataEnergy::kOrder; ++x)
            for (int e = 0; e < dimension; ++e)
              right(row, e) +=
                  factor / 2 * legendre(x, a) *
                  goal[(Index{x * DataEnergy::kOrder} * DataEnergy::kKinds + kind) * energy.dimension() + e];
        }
      }
    }
    matrix.setFromTriplets(entries.begin(), entries.end());
  }
};

}  // namespace

CurveProblem::CurveProblem(CurvePoints points, int degree, double smoothing,
                           std::shared_ptr<const DataEnergy> energy)
    : points_(std::move(points)), degree_(degree), smoothing_(smoothing), energy_(std::move(energy)) {
  double sum = 0;
  for (Index k = 0; k < points_.size(); ++k) sum += points_.weight(k);
  mean_weight_ = sum / static_cast<double>(points_.size());
}

double CurveProblem::on_curve(double t) const {
  return points_.closed && t < curve_.knots().first() ? t + 1 : t;
}

bool CurveProblem::solve(const std::vector<double>& knots) {
  ++fits_;
  phi_ = std::numeric_limits<double>::infinity();
  knots_ = knots;
  const int m = degree_, w = m + 1, d = points_.dimension;
  if (points_.closed && static_cast<int>(knots.size()) < w) return false;
  const KnotVector vector = points_.closed ? periodic_knots(m, knots) : KnotVector::clamped(m, knots);
  const Index n = points_.closed ? static_cast<Index>(knots.size()) : vector.size(), count = points_.size();
  std::vector<Eigen::Triplet<double>> entries;
  std::array<double, kMaxDegree + 1> basis{};
  for (Index k = 0; k < count; ++k) {
    const double t = points_.closed && points_.t[k] < vector.first() ? points_.t[k] + 1 : points_.t[k];
    const Index span = vector.find_span(t);
    basis_functions(vector, span, t, std::span(basis).first(w));
    const double root = std::sqrt(points_.weight(k));
    for (int a = 0; a < w; ++a) entries.emplace_back(k, (span - m + a) % n, root * basis[a]);
  }
  Eigen::SparseMatrix<double, Eigen::RowMajor> a(count, n);
  a.setFromTriplets(entries.begin(), entries.end());
  Eigen::MatrixXd p(count, d);
  for (Index k = 0; k < count; ++k)
    for (int e = 0; e < d; ++e) p(k, e) = std::sqrt(points_.weight(k)) * points_.value(k)[e];
  const Sparse g = Sparse(a.transpose() * a), j = energy(vector, n);
  const auto trace = [](const Sparse& x) { return x.diagonal().sum(); };
  std::optional<HeldTerms> held;
  if (energy_) held.emplace(*energy_, vector, n, mean_weight_, d);
  Eigen::SimplicialLDLT<Sparse> factor;
  for (double floor = smoothing_; floor <= std::max(1e-5, smoothing_); floor = std::max(100 * floor, 1e-14)) {
    Sparse matrix = g + floor * trace(g) / trace(j) * j;
    if (held) matrix += held->matrix;
    factor.compute(matrix);
    if (factor.info() == Eigen::Success && factor.vectorD().minCoeff() > 0) break;
  }
  if (factor.info() != Eigen::Success) return false;
  Eigen::MatrixXd right = a.transpose() * p;
  if (held) right += held->right;
  Eigen::MatrixXd c = factor.solve(right);
  Eigen::MatrixXd r = a * c - p;
  Eigen::MatrixXd gradient = a.transpose() * r;
  if (held) gradient += held->matrix * c - held->right;
  c -= factor.solve(gradient);
  r = a * c - p;
  if (!c.allFinite() || !r.allFinite()) return false;
  phi_ = r.squaredNorm();
  r_.resize(static_cast<std::size_t>(count * d));
  for (Index k = 0; k < count; ++k)
    for (int e = 0; e < d; ++e) r_[k * d + e] = r(k, e);
  std::vector<double> net(static_cast<std::size_t>(vector.size() * d));
  for (Index i = 0; i < vector.size(); ++i)
    for (int e = 0; e < d; ++e) net[i * d + e] = c(i % n, e);
  curve_ = Curve(vector, d, std::move(net));
  return true;
}

std::vector<double> CurveProblem::errors() const {
  std::vector<double> errors(static_cast<std::size_t>(points_.size()));
  const int d = points_.dimension;
  for (Index k = 0; k < points_.size(); ++k) {
    double sum = 0;
    for (int e = 0; e < d; ++e) sum += r_[k * d + e] * r_[k * d + e];
    errors[k] = std::sqrt(sum / points_.weight(k));
  }
  return errors;
}

double CurveProblem::measured(const Tolerance& tolerance) const {
  return std::isfinite(phi_) ? measured_error(errors(), tolerance) : phi_;
}

}  // namespace knotfit
