#include "spline/projection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "knotfit/basis.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

struct Node {
  double at, weight;  ///< on [-1,1]
};

/// Gauss-Legendre nodes by Newton from Chebyshev's [Abramowitz64 25.4.29].
std::vector<Node> gauss_nodes(int count) {
  std::vector<Node> nodes;
  for (int k = 0; k < count; ++k) {
    double x = std::cos(std::numbers::pi * (k + 0.75) / (count + 0.5)), slope = 1;
    for (int round = 0; round < 20; ++round) {
      double before = 1, value = x;
      for (int a = 2; a <= count; ++a)
        before = std::exchange(value, ((2 * a - 1) * x * value - (a - 1) * before) / a);
      slope = count * (x * value - before) / (x * x - 1);
      const double move = value / slope;
      x -= move;
      if (std::abs(move) < 1e-15) break;
    }
    nodes.push_back({x, 2 / ((1 - x * x) * slope * slope)});
  }
  return nodes;
}

using Basis = std::array<double, kMaxDegree + 1>;

/// sum_a basis_a row_{span - degree + a} of control points with `width` numbers a row.
void blend(const KnotVector& knots, Index span, double x, const double* rows, Index width, double sign,
           double* out) {
  Basis basis;
  basis_functions(knots, span, x, basis);
  for (int a = 0; a <= knots.degree(); ++a) {
    const double* row = rows + (span - knots.degree() + a) * width;
    for (Index c = 0; c < width; ++c) out[c] += sign * basis[static_cast<std::size_t>(a)] * row[c];
  }
}

/// Symmetric positive definite band matrix, lower part: entry (i, i - k) at [i * (half + 1) + k].
struct Band {
  Index size, half;
  std::vector<double> entries = std::vector<double>(static_cast<std::size_t>(size * (half + 1)), 0.0);
  double& at(Index i, Index j) { return entries[static_cast<std::size_t>(i * (half + 1) + i - j)]; }

  /// Cholesky, then both substitutions on rows of right sides.
  void solve(double* rows, Index width) {
    for (Index i = 0; i < size; ++i) {
      const Index first = std::max<Index>(0, i - half);
      for (Index j = first; j <= i; ++j) {
        double sum = at(i, j);
        for (Index k = std::max(first, j - half); k < j; ++k) sum -= at(i, k) * at(j, k);
        at(i, j) = i == j ? std::sqrt(sum) : sum / at(j, j);
      }
    }
    for (Index i = 0; i < size; ++i) {
      for (Index k = std::max<Index>(0, i - half); k < i; ++k) subtract(rows, i, k, at(i, k), width);
      divide(rows, i, at(i, i), width);
    }
    for (Index i = size - 1; i >= 0; --i) {
      for (Index k = i + 1; k <= std::min(size - 1, i + half); ++k) subtract(rows, i, k, at(k, i), width);
      divide(rows, i, at(i, i), width);
    }
  }

 private:
  static void subtract(double* rows, Index to, Index from, double factor, Index width) {
    for (Index c = 0; c < width; ++c) rows[to * width + c] -= factor * rows[from * width + c];
  }
  static void divide(double* rows, Index i, double by, Index width) {
    for (Index c = 0; c < width; ++c) rows[i * width + c] /= by;
  }
};

std::vector<double> union_of(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> all;
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
  return all;
}

std::vector<double> nearest_net(const Surface& s, const KnotVector& knots,
                                const std::vector<double>& breaks) {
  const Index width = s.size_v() * s.dimension(), n = knots.size(), d = knots.degree();
  Band gram{n, d};
  std::vector<double> net(static_cast<std::size_t>(n * width), 0.0), value(static_cast<std::size_t>(width));
  const std::vector<Node> nodes =
      gauss_nodes((std::max(s.degree_u(), knots.degree()) + knots.degree()) / 2 + 1);
  for (std::size_t b = 1; b < breaks.size(); ++b) {
    const double half = (breaks[b] - breaks[b - 1]) / 2, middle = breaks[b - 1] + half;
    const Index from = s.knots_u().find_span(middle), to = knots.find_span(middle);
    for (const Node& node : nodes) {
      const double x = middle + half * node.at, weight = half * node.weight;
      Basis basis;
      basis_functions(knots, to, x, basis);
      std::fill(value.begin(), value.end(), 0.0);
      blend(s.knots_u(), from, x, s.net().data(), width, weight, value.data());
      for (Index a = 0; a <= d; ++a) {
        const double share = basis[static_cast<std::size_t>(a)];
        double* row = net.data() + (to - d + a) * width;
        for (Index c = 0; c < width; ++c) row[c] += share * value[static_cast<std::size_t>(c)];
        for (Index e = 0; e <= a; ++e)
          gram.at(to - d + a, to - d + e) += weight * share * basis[static_cast<std::size_t>(e)];
      }
    }
  }
  // The borders are given: their rows leave the system.
  const auto fix = [&](Index row, const double* values) {
    for (Index i = std::max<Index>(0, row - d); i <= std::min(n - 1, row + d); ++i) {
      if (i == row) continue;
      double& entry = i > row ? gram.at(i, row) : gram.at(row, i);
      for (Index c = 0; c < width; ++c) net[i * width + c] -= entry * values[c];
      entry = 0;
    }
    gram.at(row, row) = 1;
    std::copy_n(values, width, net.begin() + row * width);
  };
  fix(0, s.net().data());
  fix(n - 1, s.net().data() + (s.size_u() - 1) * width);
  gram.solve(net.data(), width);
  return net;
}

/// max |S - T| a span of breaks, over all v by the convex hull of its control points. A polynomial of degree p is
/// at most 1 / cos(p pi / 2N) of its largest value at N + 1 Chebyshev extrema [Ehlich64].
std::vector<double> span_errors(const Surface& s, const Surface& t, const std::vector<double>& breaks) {
  const int p = std::max(s.degree_u(), t.degree_u()), points = 4 * p;
  const double bound = 1 / std::cos(std::numbers::pi * p / (2.0 * points));
  const Index width = s.size_v() * s.dimension();
  std::vector<double> difference(static_cast<std::size_t>(width)), errors;
  for (std::size_t b = 1; b < breaks.size(); ++b) {
    const double half = (breaks[b] - breaks[b - 1]) / 2, middle = breaks[b - 1] + half;
    const Index of_s = s.knots_u().find_span(middle), of_t = t.knots_u().find_span(middle);
    double largest = 0;
    for (int k = 0; k <= points; ++k) {
      const double x = middle - half * std::cos(std::numbers::pi * k / points);
      std::fill(difference.begin(), difference.end(), 0.0);
      blend(s.knots_u(), of_s, x, s.net().data(), width, 1, difference.data());
      blend(t.knots_u(), of_t, x, t.net().data(), width, -1, difference.data());
      for (Index j = 0; j < s.size_v(); ++j) {
        double squared = 0;
        for (int c = 0; c < s.dimension(); ++c) {
          const double e = difference[static_cast<std::size_t>(j * s.dimension() + c)];
          squared += e * e;
        }
        largest = std::max(largest, squared);
      }
    }
    errors.push_back(bound * std::sqrt(largest));
  }
  return errors;
}

}  // namespace

Projection project_u(const Surface& s, const KnotVector& knots) {
  if (s.empty()) throw InvalidInput("the surface to approximate is empty");
  if (!s.knots_u().is_clamped() || !knots.is_clamped() || s.knots_u().first() != knots.first() ||
      s.knots_u().last() != knots.last())
    throw InvalidInput("a surface is approximated over clamped knots with its own domain only");
  const std::vector<double> coarse = knots.breaks(), breaks = union_of(s.knots_u().breaks(), coarse);
  Projection result;
  result.surface = Surface(knots, s.knots_v(), s.dimension(), nearest_net(s, knots, breaks));
  const std::vector<double> errors = span_errors(s, result.surface, breaks);
  result.span_errors.assign(coarse.size() - 1, 0.0);
  for (std::size_t b = 1, span = 0; b < breaks.size(); ++b) {
    if (breaks[b - 1] >= coarse[span + 1]) ++span;
    result.span_errors[span] = std::max(result.span_errors[span], errors[b - 1]);
  }
  result.error = *std::max_element(result.span_errors.begin(), result.span_errors.end());
  return result;
}

}  // namespace knotfit
