#include "place/error_model.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "knotfit/basis.h"
#include "place/shares.h"
namespace knotfit {
namespace {

// Measured constants [METHOD 2.1].
constexpr double kDensityFloor = 0.02, kDamping = 0.5, kLeastSpan = 0.01;
constexpr int kFineRounds = 4;

/// Whether there is data at (along, across); empty: everywhere.
using Coverage = std::function<bool(double, double)>;

Coverage coverage(const ParameterMap& map, bool along_v) {
  if (!map.sheared()) return {};
  return [&map, along_v](double along, double across) {
    return along_v ? map.covers(across, along) : map.covers(along, across);
  };
}

/// across.gram(0) from the spans that are covered, with `margin` around them, between `first` and `last` along: a
/// surface swings beyond the data, and cells that hold little of it swing with it.
std::vector<double> covered_gram(const Axis& across, double first, double last, const Coverage& covered) {
  const int w = across.width();
  std::vector<double> gram(across.functions() * w, 0.0);
  for (Index s = 0; s < across.spans(); ++s) {
    const double low = across.low(s) - across.length(s), high = across.low(s) + 2 * across.length(s);
    auto inside = [](double x) { return std::clamp(x, 0.0, 1.0); };
    bool all = true;
    for (double x : {first, last})
      for (double y : {low, high}) all = all && covered(inside(x), inside(y));
    if (!all) continue;
    const double* product = across.products(s);  // P_0 is the mean
    for (int i = 0; i < w; ++i)
      for (int j = 0; j <= i; ++j, product += across.moments())
        gram[(s + i) * w + (i - j)] += across.length(s) * product[0];
  }
  return gram;
}

/// \param net  control point (i along, j across), component e at [i * stride_along + j * stride_across + e]
ErrorDensity density(const Axis& along, const Axis& across, const double* net, Index stride_along,
                     Index stride_across, int dimension, const Coverage& covered) {
  const Index spans = along.spans(), nj = across.functions();
  const int m = along.degree(), w = along.width();
  if (spans == 1) return {{1.0}, 1.0};

  // D_s: the m-th derivative on span s, constant along it; a spline across with coefficients D[s].
  const Index row = nj * dimension;
  std::vector<double> derivative(spans * row, 0.0), basis((m + 1) * w);
  for (Index s = 0; s < spans; ++s) {
    if (along.length(s) <= 0) continue;
    basis_derivatives(along.knots(), s + m, along.low(s) + along.length(s) / 2, m, basis);
    for (int a = 0; a < w; ++a) {
      const double b = basis[m * w + a];
      const double* c = net + (s + a) * stride_along;
      for (Index j = 0; j < nj; ++j)
        for (int e = 0; e < dimension; ++e)
          derivative[s * row + j * dimension + e] += b * c[j * stride_across + e];
    }
  }

  // Slope at a knot: the jump there, in L2 across, over the distance of the spans' middles.
  // Only where there is data: what a surface does in an empty corner needs no knots.
  std::vector<double> gram = across.gram(0);
  const int wj = across.width();
  std::vector<double> slope(spans - 1, 0.0), jump(row);
  for (Index k = 0; k + 1 < spans; ++k) {
    const double h = (along.length(k) + along.length(k + 1)) / 2;
    if (along.length(k) <= 0 || along.length(k + 1) <= 0) continue;
    if (covered)
      gram = covered_gram(across, along.low(k) - along.length(k), along.low(k + 1) + 2 * along.length(k + 1),
                          covered);
    for (Index x = 0; x < row; ++x) jump[x] = derivative[(k + 1) * row + x] - derivative[k * row + x];
    double square = 0;
    for (Index j = 0; j < nj; ++j)
      for (Index b = 0; b < std::min<Index>(wj, j + 1); ++b) {
        double product = 0;
        for (int e = 0; e < dimension; ++e)
          product += jump[j * dimension + e] * jump[(j - b) * dimension + e];
        square += (b == 0 ? 1 : 2) * gram[j * wj + b] * product;
      }
    slope[k] = std::sqrt(std::max(0.0, square)) / h;
  }

  std::vector<double> g(spans);
  for (Index s = 0; s < spans; ++s) {
    const double left = slope[std::max<Index>(0, s - 1)], right = slope[std::min(spans - 2, s)];
    g[s] = std::pow((left + right) / 2, 2.0 / (2 * m + 3));
  }
  const std::vector<double> raw = g;
  for (Index s = 0; s < spans; ++s)
    g[s] = (raw[std::max<Index>(0, s - 1)] + 2 * raw[s] + raw[std::min(spans - 1, s + 1)]) / 4;

  ErrorDensity result;
  result.integral = 0;
  for (Index s = 0; s < spans; ++s) result.integral += g[s] * along.length(s);
  result.mass.resize(spans);
  for (Index s = 0; s < spans; ++s)
    result.mass[s] = std::max(g[s], kDensityFloor * result.integral) * along.length(s);
  if (!(result.integral > 0)) {  // a polynomial: no knot is better than another
    result.integral = 0;
    for (Index s = 0; s < spans; ++s) result.mass[s] = along.length(s);
  }
  return result;
}

/// Rounds at fixed counts from `knots`: refit, equal shares, damped; the best round's knots are kept.
struct Outcome {
  InteriorKnots best;
  double error = std::numeric_limits<double>::infinity();
};
Outcome iterate(FitProblem& problem, InteriorKnots knots, int rounds, const Tolerance& keep_by,
                const std::function<bool()>& stop) {
  Outcome result;
  for (int round = 0;; ++round) {
    if (!problem.solve(knots)) break;
    const double error = problem.measured(keep_by);
    if (error < result.error) {
      result.error = error;
      result.best = knots;
    }
    if (round == rounds || stop() || error <= keep_by.value) break;
    InteriorKnots next =
        knots_of_density(problem, static_cast<int>(knots.u.size()), static_cast<int>(knots.v.size()));
    const auto damp = [](std::vector<double>& x, const std::vector<double>& from) {
      for (std::size_t i = 0; i < x.size(); ++i) x[i] = kDamping * x[i] + (1 - kDamping) * from[i];
      widen_spans(x, kLeastSpan);
    };
    damp(next.u, knots.u);
    damp(next.v, knots.v);
    knots = std::move(next);
  }
  return result;
}

}  // namespace

ErrorDensity error_density_u(const FitProblem& f) {
  const int d = f.points().dimension;
  return density(f.axis_u(), f.axis_v(), f.net().data(), f.axis_v().functions() * d, d, d,
                 coverage(f.points().map, false));
}

ErrorDensity error_density_v(const FitProblem& f) {
  const int d = f.points().dimension;
  return density(f.axis_v(), f.axis_u(), f.net().data(), d, f.axis_v().functions() * d, d,
                 coverage(f.points().map, true));
}

InteriorKnots knots_of_density(const FitProblem& fitted, int interior_u, int interior_v) {
  InteriorKnots knots;
  knots.u = equal_shares(with_ends(fitted.knots().u), error_density_u(fitted).mass, interior_u);
  knots.v = equal_shares(with_ends(fitted.knots().v), error_density_v(fitted).mass, interior_v);
  widen_spans(knots.u, kLeastSpan);
  widen_spans(knots.v, kLeastSpan);
  return knots;
}

FineModel fit_fine_model(FitProblem& problem, const InteriorKnots& uniform, const Control& control) {
  FineModel model;
  model.knots = iterate(problem, uniform, kFineRounds, {.value = -1, .measure = ErrorMeasure::rms}, [&] {
                  return control.stop.stop_requested();
                }).best;
  if (model.knots.u.size() != uniform.u.size() || model.knots.v.size() != uniform.v.size())
    model.knots = uniform;  // no round was solvable
  if (problem.solve(model.knots)) {
    const ErrorDensity u = error_density_u(problem), v = error_density_v(problem);
    model.mass_u = u.mass;
    model.mass_v = v.mass;
    model.integral_u = u.integral;
    model.integral_v = v.integral;
  } else {
    model.mass_u.assign(uniform.u.size() + 1, 1.0);
    model.mass_v.assign(uniform.v.size() + 1, 1.0);
  }
  return model;
}

InteriorKnots error_model_from(PlacementContext& context, const InteriorKnots& start, int rounds) {
  const Outcome result = iterate(context.problem(), start, rounds, {.value = 0, .measure = ErrorMeasure::rms},
                                 [&] { return context.stop_requested(); });
  return std::isfinite(result.error) ? result.best : start;
}

/// Equal shares of the error that the present fit predicts [deBoor01 XII, NEWNOT], carried to surfaces [METHOD 2.1]. For
/// curves the book has steps 2 and 3; the norm across the other direction, the damping, the floor and both stages are
/// ours:
///  1. a fine net, 4 rounds from uniform knots, gives the densities that the knots start from;
///  2. the m-th derivative of the fit jumps at its knots: the jump over the mean span estimates the (m+1)-st, in L2 over
///     the other direction, and its power 2/(2m + 3) is the density;
///  3. knots cut the density's integral into equal shares, half of the step is taken, and the surface is fitted again;
///  4. the knots of least error of all rounds are kept.
Placement place_error_model(PlacementContext& context, int interior_u, int interior_v) {
  const FineModel& fine = context.fine_model();
  InteriorKnots start{equal_shares(fine.breaks_u(), fine.mass_u, interior_u),
                      equal_shares(fine.breaks_v(), fine.mass_v, interior_v)};
  widen_spans(start.u, kLeastSpan);
  widen_spans(start.v, kLeastSpan);
  const PlacementOptions& o = context.options();
  Placement placement;
  const Outcome rounds =
      iterate(context.problem(), start, o.rounds, o.keep_by, [&] { return context.stop_requested(); });
  placement.knots = std::isfinite(rounds.error) ? rounds.best : start;
  placement.status = context.stop_requested() ? PlacementStatus::stopped : PlacementStatus::converged;
  return placement;
}

}  // namespace knotfit
