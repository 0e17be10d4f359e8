// Gauss-Legendre quadrature.
#pragma once
#include <vector>
namespace knotfit {

/// Nodes and weights on [-1,1], and the Legendre polynomials P_0 .. P_{n-1} at the nodes.
struct GaussRule {
  std::vector<double> node, weight, legendre;  ///< legendre: n x n, a node a row
  explicit GaussRule(int n);
};

/// The rule of 2 degree + 1 nodes: exact for products of two splines' pieces with P_{2 degree}.
const GaussRule& gauss_rule(int degree);

}  // namespace knotfit
