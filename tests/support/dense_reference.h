// A fit by the book: full matrices, basis functions by their definition, nothing of src/fit.
#pragma once
#include <Eigen/Dense>
#include <vector>

#include "knotfit/points.h"
#include "knotfit/surface.h"
#include "spline/reference.h"
#include "support/random_splines.h"
namespace knotfit::test {

/// n x size: the r-th derivatives of every basis function at every parameter.
inline Eigen::MatrixXd basis_matrix(const KnotVector& t, const std::vector<double>& x, int r = 0) {
  Eigen::MatrixXd b = Eigen::MatrixXd::Zero(static_cast<Index>(x.size()), t.size());
  for (std::size_t k = 0; k < x.size(); ++k) {
    const Reference at{t, reference_span(t, x[k]), x[k]};
    for (Index i = at.span - t.degree(); i <= at.span; ++i)
      b(static_cast<Index>(k), i) = static_cast<double>(at(i, t.degree(), r));
  }
  return b;
}

/// Gauss-Legendre nodes and weights on [-1,1] as eigenvalues of the Jacobi matrix [Golub-Welsch].
struct GaussNodes {
  Eigen::VectorXd node, weight;
  explicit GaussNodes(int n) {
    Eigen::MatrixXd jacobi = Eigen::MatrixXd::Zero(n, n);
    for (int k = 1; k < n; ++k) jacobi(k, k - 1) = jacobi(k - 1, k) = k / std::sqrt(4.0 * k * k - 1);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(jacobi);
    node = solver.eigenvalues();
    weight = 2 * solver.eigenvectors().row(0).transpose().array().square();
  }
};

/// size x size: int B_i^(r) B_j^(r), span by span.
inline Eigen::MatrixXd gram_matrix(const KnotVector& t, int r) {
  const GaussNodes rule(t.degree() + 1);
  Eigen::MatrixXd g = Eigen::MatrixXd::Zero(t.size(), t.size());
  for (Index s = t.degree(); s < t.size(); ++s) {
    const double h = t[s + 1] - t[s];
    if (h <= 0) continue;
    for (Index k = 0; k < rule.node.size(); ++k) {
      const Reference at{t, s, t[s] + h * (rule.node[k] + 1) / 2};
      Eigen::VectorXd b = Eigen::VectorXd::Zero(t.size());
      for (Index i = s - t.degree(); i <= s; ++i) b[i] = static_cast<double>(at(i, t.degree(), r));
      g += rule.weight[k] * h / 2 * b * b.transpose();
    }
  }
  return g;
}

inline Eigen::MatrixXd kronecker(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd k(a.rows() * b.rows(), a.cols() * b.cols());
  for (Index i = 0; i < a.rows(); ++i)
    for (Index j = 0; j < a.cols(); ++j)
      k.block(i * b.rows(), j * b.cols(), b.rows(), b.cols()) = a(i, j) * b;
  return k;
}

/// J [METHOD 1.2]: thin plate, or the membrane where a degree is 1.
inline Eigen::MatrixXd energy_matrix(const KnotVector& u, const KnotVector& v) {
  if (u.degree() == 1 || v.degree() == 1)
    return kronecker(gram_matrix(u, 1), gram_matrix(v, 0)) + kronecker(gram_matrix(u, 0), gram_matrix(v, 1));
  return kronecker(gram_matrix(u, 2), gram_matrix(v, 0)) +
         2 * kronecker(gram_matrix(u, 1), gram_matrix(v, 1)) +
         kronecker(gram_matrix(u, 0), gram_matrix(v, 2));
}

/// Everything of one least-squares problem in full matrices; control point (i, j) is row i size_v + j.
struct DenseProblem {
  Eigen::MatrixXd a;       ///< points x control points
  Eigen::VectorXd w;       ///< weights
  Eigen::MatrixXd data;    ///< points x dimension
  Eigen::MatrixXd normal;  ///< A^T W A
  Eigen::MatrixXd energy;  ///< J
  double lambda = 0;       ///< relative floor tr(A^T W A) / tr(J)
  Eigen::MatrixXd g;       ///< A^T W A + lambda J
  Eigen::MatrixXd rhs;     ///< A^T W P

  DenseProblem(const ParameterizedPoints& points, const KnotVector& u, const KnotVector& v, double floor) {
    const Index n = points.size();
    std::vector<double> pu, pv;
    for (Index k = 0; k < n; ++k) {
      pu.push_back(points.u(k));
      pv.push_back(points.v(k));
    }
    const Eigen::MatrixXd bu = basis_matrix(u, pu), bv = basis_matrix(v, pv);
    a.resize(n, u.size() * v.size());
    w.resize(n);
    data.resize(n, points.dimension);
    for (Index k = 0; k < n; ++k) {
      a.row(k) = kronecker(bu.row(k), bv.row(k));
      w[k] = points.weight(k);
      for (int d = 0; d < points.dimension; ++d) data(k, d) = points.value(k)[d];
    }
    normal = a.transpose() * w.asDiagonal() * a;
    energy = energy_matrix(u, v);
    lambda = floor * normal.trace() / energy.trace();
    g = normal + lambda * energy;
    rhs = a.transpose() * w.asDiagonal() * data;
  }
};

inline Eigen::MatrixXd as_matrix(const std::vector<double>& net, int dimension) {
  return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
      net.data(), static_cast<Index>(net.size()) / dimension, dimension);
}

/// Random interior knots of an axis on [0,1]: gaps over a decade, some of them multiple.
inline std::vector<double> random_interior(Random& random, int breaks, int most_multiplicity = 1) {
  std::vector<double> gaps, knots;
  double sum = 0;
  for (int k = 0; k <= breaks; ++k) {
    gaps.push_back(random.log_uniform(0.1, 1));
    sum += gaps.back();
  }
  double at = 0;
  for (int k = 0; k < breaks; ++k) {
    at += gaps[static_cast<std::size_t>(k)] / sum;
    const int copies = random.integer(0, 2) > 0 ? 1 : random.integer(1, most_multiplicity);
    knots.insert(knots.end(), static_cast<std::size_t>(copies), at);
  }
  return knots;
}

/// n points at random parameters, values in [-1,1], weights over two decades where asked.
inline ParameterizedPoints random_points(Random& random, Index n, int dimension, bool weighted = false) {
  ParameterizedPoints points;
  points.dimension = dimension;
  points.uv = random_numbers(random, 2 * n);
  for (double& x : points.uv) x = (x + 1) / 2;
  points.values = random_numbers(random, n * dimension);
  if (weighted)
    for (Index k = 0; k < n; ++k) points.weights.push_back(random.log_uniform(0.1, 10));
  return points;
}

}  // namespace knotfit::test
