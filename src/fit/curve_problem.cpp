#include "fit/curve_problem.h"

#include <Eigen/Sparse>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fit/gauss_rule.h"
#include "knotfit/basis.h"
#include "knotfit/fit_least_squares.h"
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

}  // namespace

CurveProblem::CurveProblem(CurvePoints points, int degree, double smoothing)
    : points_(std::move(points)), degree_(degree), smoothing_(smoothing) {}

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
  Eigen::SimplicialLDLT<Sparse> factor;
  for (double floor = smoothing_; floor <= std::max(1e-5, smoothing_); floor = std::max(100 * floor, 1e-14)) {
    factor.compute(Sparse(g + floor * trace(g) / trace(j) * j));
    if (factor.info() == Eigen::Success && factor.vectorD().minCoeff() > 0) break;
  }
  if (factor.info() != Eigen::Success) return false;
  Eigen::MatrixXd c = factor.solve(a.transpose() * p);
  Eigen::MatrixXd r = a * c - p;
  c -= factor.solve(a.transpose() * r);
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
