// The known behaviour of methods from the literature.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "knotfit/fit_least_squares.h"
#include "knotfit/place.h"
#include "place/row_grid.h"
#include "place/row_knots.h"
#include "place/shares.h"
#include "support/synthetic.h"
namespace knotfit::test {
namespace {

/// A full grid of heights f(u, v).
template <class F>
ParameterizedPoints grid_of(int nu, int nv, const F& f) {
  ParameterizedPoints points;
  points.height_field = true;
  for (int i = 0; i < nu; ++i)
    for (int j = 0; j < nv; ++j) {
      const double u = i / (nu - 1.0), v = j / (nv - 1.0);
      points.uv.insert(points.uv.end(), {u, v});
      points.values.push_back(f(u, v));
    }
  return points;
}

Index inside(const std::vector<double>& knots, double low, double high) {
  return std::count_if(knots.begin(), knots.end(), [&](double x) { return x > low && x < high; });
}

double rms(const ParameterizedPoints& points, const InteriorKnots& knots) {
  return fit_least_squares(points, KnotVector::clamped(3, knots.u), KnotVector::clamped(3, knots.v))
      .error.rms;
}

TEST(Nktp, OnUniformRowsIsUniformAndSparserAtTheEnds) {
  std::vector<double> t(401);
  for (int i = 0; i <= 400; ++i) t[i] = i / 400.0;
  const std::vector<double> knots = nktp_knots(t, 15, 3);
  ASSERT_EQ(knots.size(), 15u);
  // Groups of (N - 1)/(n - 2) parameters: their means step by that many lines, up to one line of rounding a group.
  const double step = 399.0 / 17 / 400;
  for (std::size_t i = 2; i + 2 < knots.size(); ++i)
    EXPECT_NEAR(knots[i + 1] - knots[i], step, 1.0 / 400) << i;
  // The end parameters stand alone: the first span is the mean of 1, 2, 3 groups less half a group.
  EXPECT_NEAR(knots.front(), 1.5 * step, 1.5 / 400);
  EXPECT_NEAR(1 - knots.back(), 1.5 * step, 1.5 / 400);
}

TEST(Nktp, IsBlindToShape) {
  const Placement flat = place_knots("nktp", grid_of(61, 41, [](double, double) { return 0.0; }));
  const Placement steep = place_knots("nktp", grid_of(61, 41, step));
  EXPECT_EQ(flat.knots, steep.knots);
  EXPECT_TRUE(steep.notes.empty()) << "its own grid: nothing to say";
}

TEST(Nktp, FollowsTheDensityOfTheRows) {
  std::vector<double> t;
  for (int i = 0; i <= 300; ++i) t.push_back(square(i / 300.0));
  const std::vector<double> knots = nktp_knots(t, 9, 3);
  EXPECT_GT(inside(knots, 0, 0.25), 3);  // half of the parameters lie below 1/4
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) EXPECT_LT(knots[i], knots[i + 1]);
}

TEST(Nktp, FewerRowsThanControlPointsStillGiveAPlacement) {
  PlacementOptions options;
  options.interior_u = 9;
  options.interior_v = 5;
  const Placement placement = place_knots("nktp", grid_of(6, 7, franke), options);
  EXPECT_EQ(placement.knots.u.size(), 9u);
  for (std::size_t i = 0; i + 1 < 9; ++i) EXPECT_LT(placement.knots.u[i], placement.knots.u[i + 1]);
}

TEST(Dominant, ColumnsGatherWhereAGridBends) {
  // A bend at u = 0.3 of every row; along v nothing happens.
  const ParameterizedPoints points =
      grid_of(101, 41, [](double u, double) { return std::tanh(60 * (u - 0.3)); });
  const InteriorKnots knots = place_knots("dominant", points).knots;
  EXPECT_GE(inside(knots.u, 0.2, 0.4), 6) << "of 8, in a fifth of the domain";
  EXPECT_LE(inside(knots.v, 0.2, 0.4), 3);
  EXPECT_LT(rms(points, knots), 0.2 * rms(points, place_knots("uniform", points).knots));
}

TEST(Dominant, TakesOneFitALine) {
  const ParameterizedPoints points = grid_of(61, 61, franke);
  PlacementOptions options;
  options.interior_u = 12;
  options.interior_v = 9;
  const Placement placement = place_knots("dominant", points, options);
  // It starts from 4 to 7 lines of each direction's 16 and 13.
  EXPECT_GE(placement.fits, 16 + 13 - 2 * 7);
  EXPECT_LE(placement.fits, 16 + 13 - 2 * 4);
}

TEST(RowMethods, SayThatScatteredDataWasResampled) {
  const ParameterizedPoints points = synthetic_points("franke", 4000);
  for (const char* method : {"nktp", "dominant", "derivative-share"}) {
    const Placement placement = place_knots(method, points);
    ASSERT_EQ(placement.notes.size(), 1u) << method;
    EXPECT_NE(placement.notes[0].find("resampled on 101 x 101 lines"), std::string::npos)
        << placement.notes[0];
  }
  EXPECT_TRUE(place_knots("fitpack", points).notes.empty());
}

TEST(RowShape, IsTheTurningAngleAndTheLength) {
  // A roof: every row turns by the same angle at u = 0.5.
  ParameterizedPoints points = grid_of(11, 4, [](double u, double) { return std::abs(u - 0.5); });
  FitProblem problem(points, 3, 3);
  const RowGrid grid = make_row_grid(problem, {});
  EXPECT_TRUE(grid.note.empty());
  const RowShape shape = row_shape(grid, false);
  for (int i = 0; i < 11; ++i) EXPECT_NEAR(shape.bend[i], i == 5 ? 4 * std::numbers::pi / 2 : 0, 1e-7) << i;
  for (int i = 1; i < 11; ++i) EXPECT_NEAR(shape.length[i], 4 * 0.1 * std::sqrt(2.0), 1e-12);
  EXPECT_EQ(shape.length[0], 0);
  const RowShape across = row_shape(grid, true);
  for (double b : across.bend) EXPECT_NEAR(b, 0, 1e-7);
  EXPECT_NEAR(across.length[1], 11 / 3.0, 1e-12);
}

TEST(Averaging, IsTheBooksFormula) {
  ParameterizedPoints points;
  std::vector<double> t;
  for (int k = 0; k < 50; ++k) t.push_back(square(k / 49.0));
  for (double x : t) {
    points.uv.insert(points.uv.end(), {x, std::fmod(17 * x, 1.0)});
    points.values.push_back(x);
  }
  PlacementOptions options;
  options.interior_u = 6;
  options.interior_v = 2;
  const std::vector<double> knots = place_knots("averaging", points, options).knots.u;
  const double d = 50.0 / 7;  // (N + 1)/(n - m + 1), n = 6 + 3
  for (int j = 1; j <= 6; ++j) {
    const int i = static_cast<int>(j * d);
    const double a = j * d - i;
    EXPECT_NEAR(knots[j - 1], (1 - a) * t[i - 1] + a * t[i], 1e-15);
  }
}

TEST(EqualShare, CutsTheMarginalsEvenly) {
  PlacementOptions options;
  options.interior_u = 3;
  options.interior_v = 1;
  options.user_features = FeatureMap{4, 2, {1, 1, 2, 2, 3, 3, 2, 2}};
  const Placement placement = place_knots("equal-share", synthetic_points("franke", 200), options);
  // Marginal of u: 1/8, 2/8, 3/8, 2/8 of the whole.
  EXPECT_NEAR(placement.knots.u[0], 0.25 + 0.25 / 2, 1e-12);
  EXPECT_NEAR(placement.knots.u[1], 0.5 + 0.25 / 3, 1e-12);
  EXPECT_NEAR(placement.knots.u[2], 0.75, 1e-12);
  EXPECT_NEAR(placement.knots.v[0], 0.5, 1e-12);
  EXPECT_DOUBLE_EQ(placement.criterion, cell_criterion(options.user_features, placement.knots));
}

TEST(Centroid, IsTheCentroidOfEachRegion) {
  PlacementOptions options;
  options.interior_u = 2;
  options.interior_v = 3;
  options.user_features = FeatureMap{4, 1, {3, 1, 1, 1}};
  const InteriorKnots knots = place_knots("centroid", synthetic_points("franke", 200), options).knots;
  // Half of the mass lies in the first cell, the other half evenly over the rest.
  EXPECT_NEAR(knots.u[0], 0.125, 1e-12);
  EXPECT_NEAR(knots.u[1], 0.625, 1e-12);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(knots.v[i], (2 * i + 1) / 6.0, 1e-12);
}

TEST(DerivativeShare, FollowsTheDerivativeOfTheOrder) {
  // |d^4 exp(a u)| ~ exp(a u), its fourth root ~ exp(a u / 4): shares are known.
  const double a = 8;
  const ParameterizedPoints points = grid_of(401, 5, [&](double u, double) { return std::exp(a * u); });
  PlacementOptions options;
  options.interior_v = 0;
  options.degree_v = 1;
  const std::vector<double> knots = place_knots("derivative-share", points, options).knots.u;
  for (int i = 0; i < 8; ++i)
    EXPECT_NEAR(knots[i], 4 / a * std::log(1 + (i + 1) / 9.0 * (std::exp(a / 4) - 1)), 0.01) << i;
}

TEST(DerivativeShare, IsUniformWhereTheDerivativeOfTheOrderIsConstant) {
  // d^4 u^4 = 24 everywhere. Divided differences of fourth order over lines 1/60 apart lose 2^4 kEps 60^4 / 24 of it.
  const ParameterizedPoints points =
      grid_of(61, 5, [](double u, double v) { return (1 + v) * u * u * u * u; });
  PlacementOptions options;
  options.interior_v = 0;
  options.degree_v = 1;
  const std::vector<double> knots = place_knots("derivative-share", points, options).knots.u;
  for (int i = 0; i < 8; ++i) EXPECT_NEAR(knots[i], (i + 1) / 9.0, 1e-8) << i;
}

TEST(DerivativeShare, IsUniformWhereTheDataIsAPolynomial) {
  const ParameterizedPoints points = grid_of(30, 30, [](double, double) { return 1.0; });
  EXPECT_EQ(place_knots("derivative-share", points).knots.u, uniform_knots(8));
}

TEST(Fitpack, PutsEachKnotAtTheMeanOfTheResiduals) {
  // The first knot: residuals of the cubic alone.
  const ParameterizedPoints points = synthetic_points("ridge", 3000);
  PlacementOptions options;
  options.interior_u = 1;
  options.interior_v = 0;
  const Placement placement = place_knots("fitpack", points, options);
  EXPECT_EQ(placement.fits, 1);
  LeastSquaresOptions plain;
  plain.refinement_steps = 0;
  const LeastSquaresResult cubic =
      fit_least_squares(points, KnotVector::uniform(3, 0), KnotVector::uniform(3, 0), plain);
  double squares = 0, moment = 0;
  for (Index k = 0; k < points.size(); ++k) {
    squares += square(cubic.errors[k]);
    moment += square(cubic.errors[k]) * points.u(k);
  }
  ASSERT_EQ(placement.knots.u.size(), 1u);
  EXPECT_NEAR(placement.knots.u[0], moment / squares, 1e-9);
}

TEST(Fitpack, SplitsTheSpanOfTheLargestResidualSum) {
  // Every knot is a knot of what came before, and stands in the span that the fit without it fits worst.
  const ParameterizedPoints points = synthetic_points("ridge", 3000);
  PlacementOptions options;
  options.interior_v = 0;
  options.interior_u = 1;
  std::vector<double> before = place_knots("fitpack", points, options).knots.u;
  for (int count = 2; count <= 6; ++count) {
    options.interior_u = count;
    const std::vector<double> after = place_knots("fitpack", points, options).knots.u;
    std::vector<double> added;
    std::set_difference(after.begin(), after.end(), before.begin(), before.end(), std::back_inserter(added));
    ASSERT_EQ(added.size(), 1u) << count;
    const LeastSquaresResult fit =
        fit_least_squares(points, KnotVector::clamped(3, before), KnotVector::uniform(3, 0));
    const std::vector<double> breaks = with_ends(before);
    std::vector<double> squares(breaks.size() - 1, 0.0);
    for (Index k = 0; k < points.size(); ++k)
      for (std::size_t s = 0; s < squares.size(); ++s)
        if (points.u(k) >= breaks[s] && points.u(k) < breaks[s + 1]) squares[s] += square(fit.errors[k]);
    const auto worst = std::max_element(squares.begin(), squares.end()) - squares.begin();
    EXPECT_GT(added[0], breaks[worst]) << count;
    EXPECT_LT(added[0], breaks[worst + 1]) << count;
    before = after;
  }
}

TEST(Fitpack, GoesWhereTheErrorIs) {
  const ParameterizedPoints points =
      grid_of(201, 21, [](double u, double) { return std::tanh(60 * (u - 0.3)); });
  const Placement placement = place_knots("fitpack", points);
  EXPECT_GE(inside(placement.knots.u, 0.2, 0.4), 4);
  EXPECT_EQ(placement.fits, 16);
}

TEST(FeatureMeasures, EachDrawsTheCriterionToAStep) {
  const ParameterizedPoints points = synthetic_points("step", 5000);
  for (FeatureMeasure measure : {FeatureMeasure::curvature, FeatureMeasure::hessian,
                                 FeatureMeasure::derivative, FeatureMeasure::residual}) {
    PlacementOptions options;
    options.feature = measure;
    const InteriorKnots knots = place_knots("criterion", points, options).knots;
    EXPECT_GE(inside(knots.u, 0.15, 0.45), 4) << static_cast<int>(measure);
  }
}

}  // namespace
}  // namespace knotfit::test
