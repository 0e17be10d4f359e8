#include "fit/curve_problem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "knotfit/basis.h"
#include "knotfit/fit_least_squares.h"
#include "solve/band_places.h"
#include "solve/banded.h"
#include "solve/gauss_rule.h"
#include "solve/smoothing_floor.h"
namespace knotfit {
namespace {

constexpr double kSecondFloor = 1e-14;  // the first beyond none, in one direction
// Knots so close that rounding beats every floor: of the trace, what keeps functions that meet no data at the centre of the
// frame. Rounding is 1e-16, and a share of 1e-12 is taken out by the refinement step where data is.
constexpr double kRidge = 1e-12;

void add(BandMatrix& matrix, Index i, Index j, double value) {
  matrix.add(std::max(i, j), std::min(i, j), value);
}

/// Second derivatives (first, for degree 1), squared and integrated, times a factor.
void add_thin_plate(const Axis& axis, double factor, const std::vector<double>& gram, BandMatrix& matrix) {
  const BandPlaces place(axis);
  const Index n = axis.functions();
  for (Index i = 0; i < n; ++i)
    for (Index k = 0; k < axis.width(); ++k) {
      const Index j = i - k;
      if (j < 0 && !axis.is_periodic()) break;
      add(matrix, place(i), place(j < 0 ? j + n : j), factor * gram[i * axis.width() + k]);
    }
}

/// Adds the data energy of the curve of a strip, which counts twice what the curve counts once.
/// \param right  n x dimension, column after column
void add_held_terms(const DataEnergy& energy, const Axis& axis, double factor, int dimension,
                    BandMatrix& matrix, std::vector<double>& right) {
  const int m = axis.degree(), w = axis.width(), most = std::min(m, 2);
  const Index n = axis.functions();
  const BandPlaces place(axis);
  const GaussRule& rule = gauss_rule(m);
  std::vector<double> table((most + 1) * w), weight(DataEnergy::kKinds), goal(energy.goal_size()),
      scratch(energy.scratch_size());
  for (Index s = 0; s < axis.spans(); ++s) {
    const double low = axis.low(s), h = axis.length(s);
    if (!(h > 0)) continue;
    energy.integrate(low, low + h, 0, 1, weight.data(), goal.data(), scratch.data());
    for (int order = 1; order <= most; ++order) {
      const int kind = order == 1 ? DataRaster::kU : DataRaster::kUu;
      std::vector<double> gram(w * w, 0.0),
          legendre(DataEnergy::kOrder * w, 0.0);  // means of products; coefficients
      for (std::size_t g = 0; g < rule.node.size(); ++g) {
        basis_derivatives(axis.knots(), s + m, low + h * (rule.node[g] + 1) / 2, order, table);
        const double* of = table.data() + order * w;
        for (int a = 0; a < w; ++a) {
          for (int b = 0; b <= a; ++b) gram[a * w + b] += rule.weight[g] / 2 * of[a] * of[b];
          legendre[a] += rule.weight[g] / 2 * of[a];
          legendre[w + a] += 1.5 * rule.weight[g] * rule.node[g] * of[a];
        }
      }
      for (int a = 0; a < w; ++a) {
        const Index row = place(axis.function(s, a));
        for (int b = 0; b <= a; ++b)
          add(matrix, row, place(axis.function(s, b)), factor / 2 * weight[kind] * gram[a * w + b]);
        for (int x = 0; x < DataEnergy::kOrder; ++x)
          for (int e = 0; e < dimension; ++e)
            right[e * n + row] +=
                factor / 2 * legendre[x * w + a] *
                goal[(Index{x * DataEnergy::kOrder} * DataEnergy::kKinds + kind) * energy.dimension() + e];
      }
    }
  }
}

/// The rows of A: the functions alive at each point, times the root of its weight.
struct Rows {
  const CurvePoints& points;
  const Axis& axis;
  BandPlaces place;
  std::vector<Index> places;  // of a span's functions
  std::vector<Index> span;
  std::vector<double> value;   // n x width
  std::vector<double> target;  // n x dimension: P times the root

  Rows(const CurvePoints& p, const Axis& a) : points(p), axis(a), place(a) {
    for (Index s = 0; s < a.spans(); ++s)
      for (int i = 0; i < a.width(); ++i) places.push_back(place(a.function(s, i)));
    const double first = a.knots().first();
    for (Index k = 0; k < p.size(); ++k) {
      const double t = p.closed && p.t[k] < first ? p.t[k] + 1 : p.t[k], root = std::sqrt(p.weight(k));
      std::array<double, kMaxDegree + 1> basis{};
      span.push_back(a.span(t));
      basis_functions(a.knots(), span.back() + a.degree(), t, std::span(basis).first(a.width()));
      for (int i = 0; i < a.width(); ++i) value.push_back(root * basis[i]);
      for (int e = 0; e < p.dimension; ++e) target.push_back(root * p.value(k)[e]);
    }
  }
  Index at(Index k, int i) const { return places[span[k] * axis.width() + i]; }
  double operator()(Index k, int i) const { return value[k * axis.width() + i]; }

  void add_gram(BandMatrix& matrix) const {
    for (Index k = 0; k < points.size(); ++k)
      for (int i = 0; i < axis.width(); ++i)
        for (int j = 0; j <= i; ++j) add(matrix, at(k, i), at(k, j), (*this)(k, i) * (*this)(k, j));
  }
  /// Adds A^T x, x n x dimension, to y, functions x dimension, column after column.
  void add_transposed(const std::vector<double>& x, std::vector<double>& y) const {
    const Index n = axis.functions();
    for (Index k = 0; k < points.size(); ++k)
      for (int i = 0; i < axis.width(); ++i)
        for (int e = 0; e < points.dimension; ++e)
          y[e * n + at(k, i)] += (*this)(k, i) * x[k * points.dimension + e];
  }
  /// A c - P, both times the root of the weight; n x dimension.
  std::vector<double> residual(const std::vector<double>& c) const {
    const Index n = axis.functions();
    const int d = points.dimension;
    std::vector<double> r(target.size());
    for (Index k = 0; k < points.size(); ++k)
      for (int e = 0; e < d; ++e) {
        double sum = -target[k * d + e];
        for (int i = 0; i < axis.width(); ++i) sum += (*this)(k, i) * c[e * n + at(k, i)];
        r[k * d + e] = sum;
      }
    return r;
  }
};

bool all_finite(const std::vector<double>& x) {
  return std::all_of(x.begin(), x.end(), [](double value) { return std::isfinite(value); });
}

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
  const int d = points_.dimension;
  if (points_.closed && static_cast<int>(knots.size()) < degree_ + 1) return false;
  const Axis axis = points_.closed ? Axis::periodic(degree_, knots) : Axis(degree_, knots);
  const Index n = axis.functions();
  const Rows rows(points_, axis);
  BandMatrix normal(n, rows.place.bandwidth()), held(n, rows.place.bandwidth());
  rows.add_gram(normal);
  std::vector<double> data(n * d, 0.0), goals(n * d, 0.0);
  rows.add_transposed(rows.target, data);
  if (energy_) add_held_terms(*energy_, axis, mean_weight_, d, held, goals);
  for (std::size_t i = 0; i < data.size(); ++i) data[i] += goals[i];
  const std::vector<double> gram = axis.gram(std::min(2, degree_));
  double trace = 0;
  for (Index i = 0; i < n; ++i) trace += gram[i * axis.width()];
  BandMatrix matrix;
  // What hardly meets data is left to the data energy: any pivot will do.
  const auto factor = [&](double floor, double ridge) {
    matrix = normal;
    add_thin_plate(axis, floor * normal.trace() / trace, gram, matrix);
    if (energy_) matrix.add(held);
    for (Index i = 0; i < n; ++i) matrix.add(i, i, ridge);
    return matrix.factor(0);
  };
  const bool factored = with_smoothing_floor(
                            smoothing_, [&](double floor) { return factor(floor, 0); }, kSecondFloor) ||
                        factor(std::max(smoothing_, kSecondFloor), kRidge * normal.trace());
  if (!factored) return false;
  std::vector<double> c = data;
  matrix.solve(c.data(), d);
  // One refinement step takes the floor's share out.
  std::vector<double> gradient = energy_ ? held.times(c) : std::vector<double>(n * d, 0.0);
  for (std::size_t i = 0; i < gradient.size(); ++i) gradient[i] -= goals[i];
  rows.add_transposed(rows.residual(c), gradient);
  matrix.solve(gradient.data(), d);
  for (std::size_t i = 0; i < c.size(); ++i) c[i] -= gradient[i];
  r_ = rows.residual(c);
  if (!all_finite(c) || !all_finite(r_)) return false;
  phi_ = 0;
  for (const double x : r_) phi_ += x * x;
  std::vector<double> net;
  for (Index i = 0; i < axis.knots().size(); ++i)
    for (int e = 0; e < d; ++e) net.push_back(c[e * n + rows.place(i % n)]);
  curve_ = Curve(axis.knots(), d, std::move(net));
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
