// Knot removal with a bound that holds over the whole domain.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "knotfit/exceptions.h"
#include "knotfit/surface.h"
#include "spline/insertion.h"
namespace knotfit {
namespace {

constexpr int kRows = kMaxDegree + 2;  ///< most control points that one removal touches

/// The control points old_0..old_m that inserting the knot makes from new_0..new_{m-1}:
/// old_k = alpha_k new_k + beta_k new_{k-1}, alpha_0 = beta_m = 1, beta_0 = alpha_m = 0
/// [Piegl97 5.8]. `y` spans the left kernel of that matrix, so y . old = 0 where the knot can go
/// exactly. Otherwise the least max |old - insert(new)| is |y . old| / sum |y|, with equal moves of
/// alternating sign. The end rows stay as they are (as in [Tiller92]), which keeps a clamped
/// boundary in its place: the sum runs over the rows between.
struct Insertion {
  Index row = 0;  ///< index of old_0 among all control points
  int m = 0;
  std::array<double, kRows + 1> alpha{}, beta{};
  std::array<double, kRows + 1> y{};     ///< scaled to sum |y| = 1 over the rows that move
  std::array<double, kRows + 1> sign{};  ///< of y where the row moves, else 0
  int pivot = 0;                         ///< row of the largest |y|, solved from both sides
};

Insertion insertion_of(const KnotVector& knots, double knot) {
  const int p = knots.degree(), multiplicity = knots.multiplicity(knot);
  const Index r = knots.find_span(knot), first = r - p, last = r - multiplicity;
  Insertion result;
  result.row = first - 1;
  result.m = static_cast<int>(last - first) + 2;
  const int m = result.m;
  result.alpha[0] = result.beta[m] = 1;
  for (int k = 1; k < m; ++k) {
    const double left = knots[result.row + k], right = knots[result.row + k + p + 1];
    result.alpha[k] = (knot - left) / (right - left);
    result.beta[k] = (right - knot) / (right - left);
  }
  result.y[0] = 1;
  for (int k = 1; k <= m; ++k) result.y[k] = -result.y[k - 1] * (result.alpha[k - 1] / result.beta[k]);
  const bool ends_move = m == 1;  // degree + 1 equal knots: two points become one
  double sum = 0;
  for (int k = 0; k <= m; ++k)
    if (ends_move || (k > 0 && k < m)) {
      sum += std::abs(result.y[k]);
      result.sign[k] = result.y[k] < 0 ? -1 : 1;
    }
  for (int k = 0; k <= m; ++k) {
    result.y[k] /= sum;
    if (std::abs(result.y[k]) > std::abs(result.y[result.pivot])) result.pivot = k;
  }
  return result;
}

std::vector<double> points_within_spans(const std::vector<double>& breaks, int count) {
  std::vector<double> result;
  for (std::size_t s = 1; s < breaks.size(); ++s)
    for (int k = 1; k <= count; ++k) {
      const double part = k / (count + 1.0), x = (1 - part) * breaks[s - 1] + part * breaks[s];
      if (x > breaks[s - 1] && x < breaks[s] && (result.empty() || x > result.back())) result.push_back(x);
    }
  return result;
}

double largest_norm(const std::vector<double>& points, int dimension) {
  double largest = 0;
  for (auto at = points.begin(); at != points.end(); at += dimension) {
    double sum = 0;
    for (int d = 0; d < dimension; ++d) sum += at[d] * at[d];
    largest = std::max(largest, sum);
  }
  return std::sqrt(largest);
}

/// Bound on |sum_i B_i c_i| over the domain: the control polygon after refinement, whose distance
/// from the spline falls with the square of the span.
double bound_of(const KnotVector& knots, const std::vector<double>& points, int dimension,
                const std::vector<double>& added) {
  return largest_norm(refine_points(knots, added, points, 1, dimension).points, dimension);
}

void check_removal(const Surface& s, double knot, double tolerance) {
  if (s.empty()) throw InvalidInput("the surface to remove a knot from is empty");
  if (!(tolerance >= 0)) throw InvalidInput(fmt::format("the tolerance is {}; it must be >= 0", tolerance));
  if (std::isnan(knot)) throw InvalidInput("the knot to remove is NaN");
}

void check_interior(const KnotVector& knots, double knot) {
  if (!(knot > knots.first() && knot < knots.last()) || knots.multiplicity(knot) == 0)
    throw InvalidInput(
        fmt::format("{} is not an interior knot, so it cannot be removed; the domain is [{}, {}]", knot,
                    knots.first(), knots.last()));
}

}  // namespace

KnotRemoval remove_knot_u(const Surface& s, double knot, double tolerance) {
  check_removal(s, knot, tolerance);
  check_interior(s.knots_u(), knot);
  const KnotVector& knots = s.knots_u();
  const Insertion a = insertion_of(knots, knot);
  const Index width = s.size_v() * s.dimension();
  const double* old = s.net().data() + a.row * width;

  // One vector h(v) times sign is what the rows move by.
  std::vector<double> h(static_cast<std::size_t>(width), 0.0);
  for (int k = 0; k <= a.m; ++k)
    for (Index c = 0; c < width; ++c) h[c] += a.y[k] * old[k * width + c];
  const auto target = [&](int k, Index c) { return old[k * width + c] - a.sign[k] * h[c]; };
  std::vector<double> fresh(static_cast<std::size_t>(a.m * width));
  for (int k = 0; k < a.pivot; ++k)
    for (Index c = 0; c < width; ++c)
      fresh[k * width + c] =
          k == 0 ? target(0, c) : (target(k, c) - a.beta[k] * fresh[(k - 1) * width + c]) / a.alpha[k];
  for (int k = a.m; k > a.pivot; --k)
    for (Index c = 0; c < width; ++c)
      fresh[(k - 1) * width + c] =
          k == a.m ? target(k, c) : (target(k, c) - a.alpha[k] * fresh[k * width + c]) / a.beta[k];

  // What rounding left over, measured rather than believed.
  std::vector<double> left_over(static_cast<std::size_t>((a.m + 1) * width));
  double scale = 0;
  for (int k = 0; k <= a.m; ++k)
    for (Index c = 0; c < width; ++c) {
      const double after = k < a.m ? fresh[k * width + c] : 0,
                   before = k > 0 ? fresh[(k - 1) * width + c] : 0;
      left_over[k * width + c] = target(k, c) - (a.alpha[k] * after + a.beta[k] * before);
      scale = std::max({scale, std::abs(old[k * width + c]), std::abs(after)});
    }
  const double rounding = 8 * std::numeric_limits<double>::epsilon() * scale * std::sqrt(s.dimension());

  // S moves by g(u) h(v): g has the alternating signs as control points.
  std::vector<double> g(static_cast<std::size_t>(s.size_u()), 0.0);
  std::copy_n(a.sign.begin(), a.m + 1, g.begin() + a.row);
  const auto& t = knots.knots();
  std::vector<double> near(t.begin() + a.row, t.begin() + a.row + a.m + knots.degree() + 2);
  for (double& x : near) x = std::clamp(x, knots.first(), knots.last());
  KnotRemoval result{s, false, 0};
  result.error = bound_of(knots, g, 1, points_within_spans(near, 7)) *
                     bound_of(s.knots_v(), h, s.dimension(), points_within_spans(s.knots_v().breaks(), 7)) +
                 largest_norm(left_over, s.dimension()) + rounding;
  if (!std::isfinite(result.error)) result.error = std::numeric_limits<double>::infinity();
  if (!(result.error <= tolerance) || std::isinf(result.error)) return result;

  std::vector<double> net(s.net().begin(), s.net().begin() + a.row * width);
  net.reserve(s.net().size() - static_cast<std::size_t>(width));
  net.insert(net.end(), fresh.begin(), fresh.end());
  net.insert(net.end(), s.net().begin() + (a.row + a.m + 1) * width, s.net().end());
  std::vector<double> fewer = t;
  fewer.erase(fewer.begin() + knots.find_span(knot));
  result.surface =
      Surface(KnotVector(knots.degree(), std::move(fewer)), s.knots_v(), s.dimension(), std::move(net));
  result.removed = true;
  return result;
}

KnotRemoval remove_knot_v(const Surface& s, double knot, double tolerance) {
  check_removal(s, knot, tolerance);
  check_interior(s.knots_v(), knot);
  KnotRemoval result = remove_knot_u(transposed(s), knot, tolerance);
  result.surface = result.removed ? transposed(result.surface) : s;
  return result;
}

}  // namespace knotfit
