// The iterated error model [deBoor01 NEWNOT; METHOD 2.1].
#include "place/error_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "knotfit/evaluate.h"
#include "place/shares.h"
#include "support/random_splines.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

template <class F>
ParameterizedPoints sampled(const F& f, Index n = 4000, std::uint64_t seed = 1) {
  ParameterizedPoints points;
  Uniform random(seed);
  for (Index k = 0; k < n; ++k) {
    const double u = random(), v = random();
    points.uv.insert(points.uv.end(), {u, v});
    points.values.push_back(f(u, v));
  }
  return points;
}

/// Steps 1 to 5 [METHOD 2.1] from values of the surface's derivatives alone.
ErrorDensity by_the_book(const Surface& s) {
  const int m = s.degree_u(), d = s.dimension();
  const std::vector<double> breaks = s.knots_u().breaks(), across = s.knots_v().breaks();
  const std::size_t spans = breaks.size() - 1;
  // L2 across v by many midpoints a span; D is a polynomial there, so Simpson on halves is not exact,
  // but 400 Gauss points are: two-point Gauss on 200 pieces has an error of order 200^-4.
  std::vector<double> v, weight;
  for (std::size_t r = 0; r + 1 < across.size(); ++r)
    for (int piece = 0; piece < 200; ++piece)
      for (double t : {-1 / std::sqrt(3.0), 1 / std::sqrt(3.0)}) {
        const double h = (across[r + 1] - across[r]) / 200;
        v.push_back(across[r] + h * (piece + (t + 1) / 2));
        weight.push_back(h / 2);
      }
  auto derivative = [&](std::size_t span) {
    const std::vector<double> middle{(breaks[span] + breaks[span + 1]) / 2};
    return evaluate_grid(s, middle, v, m, 0);
  };
  std::vector<double> slope;
  for (std::size_t k = 1; k < spans; ++k) {
    const std::vector<double> before = derivative(k - 1), after = derivative(k);
    double square_sum = 0;
    for (std::size_t x = 0; x < v.size(); ++x)
      for (int e = 0; e < d; ++e) square_sum += weight[x] * square(after[x * d + e] - before[x * d + e]);
    slope.push_back(std::sqrt(square_sum) / ((breaks[k + 1] - breaks[k - 1]) / 2));
  }
  std::vector<double> raw;
  for (std::size_t k = 0; k < spans; ++k) {
    const double left = k == 0 ? slope.front() : slope[k - 1],
                 right = k + 1 == spans ? slope.back() : slope[k];
    raw.push_back(std::pow((left + right) / 2, 2.0 / (2 * m + 3)));
  }
  ErrorDensity result;
  result.integral = 0;
  std::vector<double> g;
  for (std::size_t k = 0; k < spans; ++k) {
    g.push_back((raw[k == 0 ? 0 : k - 1] + 2 * raw[k] + raw[std::min(spans - 1, k + 1)]) / 4);
    result.integral += g[k] * (breaks[k + 1] - breaks[k]);
  }
  for (std::size_t k = 0; k < spans; ++k)
    result.mass.push_back(std::max(g[k], 0.02 * result.integral) * (breaks[k + 1] - breaks[k]));
  return result;
}

void expect_same(const ErrorDensity& a, const ErrorDensity& b) {
  EXPECT_NEAR(a.integral, b.integral, 1e-6 * b.integral);
  ASSERT_EQ(a.mass.size(), b.mass.size());
  for (std::size_t s = 0; s < a.mass.size(); ++s) EXPECT_NEAR(a.mass[s], b.mass[s], 1e-6 * b.mass[s]);
}

TEST(ErrorModel, DensityIsThatOfTheMethod) {
  for (const auto& [m, n] : {std::pair{3, 3}, {1, 2}, {2, 4}, {5, 3}})
    for (const char* name : {"franke", "torus"}) {
      const ParameterizedPoints points = synthetic_points(name, 3000);
      FitProblem problem(points, m, n);
      ASSERT_TRUE(problem.solve({{0.1, 0.3, 0.35, 0.6, 0.9}, {0.2, 0.5, 0.55, 0.7}}));
      expect_same(error_density_u(problem), by_the_book(problem.surface()));
      expect_same(error_density_v(problem), by_the_book(transposed(problem.surface())));
    }
}

TEST(ErrorModel, OneSpanHasAllTheMass) {
  const ParameterizedPoints points = synthetic_points("franke", 500);
  FitProblem problem(points, 3, 3);
  ASSERT_TRUE(problem.solve({{}, {0.5}}));
  EXPECT_EQ(error_density_u(problem).mass, std::vector<double>{1.0});
  EXPECT_EQ(error_density_v(problem).mass.size(), 2u);
}

TEST(ErrorModel, IsUniformWhereTheNextDerivativeIsConstant) {
  for (int m : {1, 2, 3, 4}) {
    const ParameterizedPoints points =
        sampled([&](double u, double v) { return std::pow(u, m + 1) + 2 * std::pow(v, m + 1); });
    PlacementOptions options;
    options.degree_u = options.degree_v = m;
    options.interior_u = 7;
    options.interior_v = 5;
    const Placement placement = place_knots("error-model", points, options);
    for (int i = 0; i < 7; ++i) EXPECT_NEAR(placement.knots.u[i], (i + 1) / 8.0, 0.15 / 8) << "degree " << m;
    for (int j = 0; j < 5; ++j) EXPECT_NEAR(placement.knots.v[j], (j + 1) / 6.0, 0.15 / 6) << "degree " << m;
  }
}

TEST(ErrorModel, PutsItsKnotsAtAStep) {
  const ParameterizedPoints points =
      sampled([](double u, double v) { return std::tanh(60 * (u - 0.3)) + 0.1 * v; }, 10000);
  PlacementOptions options;
  options.interior_u = 10;
  options.interior_v = 4;
  const Placement placement = place_knots("error-model", points, options);
  const auto near = std::count_if(placement.knots.u.begin(), placement.knots.u.end(),
                                  [](double x) { return std::abs(x - 0.3) < 0.1; });
  EXPECT_GE(near, 7);  // uniform ones would have 2 there
}

TEST(ErrorModel, OfAPolynomialLeavesValidKnots) {
  for (const auto& f : {+[](double, double) { return 0.0; }, +[](double, double) { return 5.0; },
                        +[](double u, double v) { return u * u * u - 2 * u * v + v * v; }}) {
    const Placement placement = place_knots("error-model", sampled(f, 1000), {});
    for (const auto* line : {&placement.knots.u, &placement.knots.v}) {
      ASSERT_EQ(line->size(), 8u);
      const std::vector<double> breaks = with_ends(*line);
      for (std::size_t s = 0; s + 1 < breaks.size(); ++s) EXPECT_GT(breaks[s + 1] - breaks[s], 0.001);
    }
  }
}

TEST(ErrorModel, OfZeroIsUniform) {
  const ParameterizedPoints points = sampled([](double, double) { return 0.0; }, 1000);
  FitProblem problem(points, 3, 3);
  ASSERT_TRUE(problem.solve({{0.2, 0.4}, {0.5}}));
  const ErrorDensity density = error_density_u(problem);
  EXPECT_EQ(density.integral, 0);
  EXPECT_NEAR(density.mass[0], 0.2, kEps);
  EXPECT_NEAR(density.mass[2], 0.6, kEps);
}

TEST(ErrorModel, TransposedDataTransposesTheKnots) {
  ParameterizedPoints points = synthetic_points("ridge", 3000), turned = points;
  for (Index k = 0; k < points.size(); ++k) std::swap(turned.uv[2 * k], turned.uv[2 * k + 1]);
  PlacementOptions options;
  options.interior_u = 9;
  options.interior_v = 5;
  const Placement a = place_knots("error-model", points, options);
  std::swap(options.interior_u, options.interior_v);
  const Placement b = place_knots("error-model", turned, options);
  for (std::size_t i = 0; i < 9; ++i) EXPECT_NEAR(a.knots.u[i], b.knots.v[i], 1e-6);
  for (std::size_t j = 0; j < 5; ++j) EXPECT_NEAR(a.knots.v[j], b.knots.u[j], 1e-6);
}

TEST(ErrorModel, ScaledDataHasTheSameKnots) {
  ParameterizedPoints points = synthetic_points("franke", 2000), scaled = points;
  for (double& x : scaled.values) x = std::ldexp(x, -40);
  const Placement a = place_knots("error-model", points), b = place_knots("error-model", scaled);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_NEAR(a.knots.u[i], b.knots.u[i], 1e-9);
}

TEST(ErrorModel, KeepsTheRoundOfLeastError) {
  const ParameterizedPoints points = synthetic_points("step", 5000);
  double before = INFINITY;
  for (int rounds : {0, 1, 2, 4, 8, 16}) {
    PlacementOptions options;
    options.rounds = rounds;
    const Placement placement = place_knots("error-model", points, options);
    FitProblem problem(points, 3, 3, {.refinement_steps = 0});
    ASSERT_TRUE(problem.solve(placement.knots));
    EXPECT_LE(problem.rms(), before);
    before = problem.rms();
  }
}

TEST(ErrorModel, StopsOnceTheErrorAskedForHolds) {
  const ParameterizedPoints points = synthetic_points("franke", 2000);
  PlacementOptions options;
  const long all = place_knots("error-model", points, options).fits;
  options.keep_by = {.value = 1e3, .measure = ErrorMeasure::max};
  EXPECT_LT(place_knots("error-model", points, options).fits, all);
}

}  // namespace
}  // namespace knotfit::test
