#include "verify/kriging.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "support/synthetic.h"
namespace knotfit::verify {
namespace {

using Real = long double;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

struct Data {
  std::vector<double> x, y, values, weights;
  int components = 1;
  Index size() const { return static_cast<Index>(x.size()); }
  Stencil stencil() const { return {x, y, values, weights, components}; }
};

// Random points of the unit disk, the farthest at distance 1, or of a half or quarter disk.
Data disk(Index k, int components = 1, std::uint64_t seed = 1, int sides = 0) {
  test::Uniform random(seed);
  Data data;
  data.components = components;
  while (data.size() < k) {
    double x = 2 * random() - 1, y = 2 * random() - 1;
    if (x * x + y * y > 1) continue;
    if (sides > 0) x = std::abs(x);
    if (sides > 1) y = std::abs(y);
    data.x.push_back(x), data.y.push_back(y);
  }
  for (Index i = 0; i < k; ++i)
    for (int c = 0; c < components; ++c)
      data.values.push_back(std::sin(2 * data.x[i] + c) * std::exp(data.y[i]) +
                            0.3 * std::cos(5 * data.y[i] * data.x[i]));
  return data;
}

// The whole system [METHOD 5.3] at once, in long double.
struct Slow {
  Matrix kernel, basis, place, p, values;
  Slow(const Data& data, int degree) {
    const Index k = data.size();
    auto phi = [&](Real r) { return (degree % 2 == 0 ? -1 : 1) * std::pow(r, Real(2 * degree + 1)); };
    kernel.resize(k, k), place.resize(k, 1), values.resize(k, data.components);
    basis.resize(k, (degree + 1) * (degree + 2) / 2);
    p = Matrix::Zero(basis.cols(), 1);
    for (Index i = 0; i < k; ++i) {
      for (Index j = 0; j < k; ++j)
        kernel(i, j) = phi(std::hypot(Real(data.x[i]) - data.x[j], Real(data.y[i]) - data.y[j]));
      place(i, 0) = phi(std::hypot(Real(data.x[i]), Real(data.y[i])));
      for (int c = 0; c < data.components; ++c) values(i, c) = data.values[i * data.components + c];
      Index column = 0;
      for (int a = 0; a <= degree; ++a)
        for (int b = 0; a + b <= degree; ++b, ++column)
          basis(i, column) = std::pow(Real(data.x[i]), a) * std::pow(Real(data.y[i]), b);
    }
    p(0, 0) = 1;
  }
  // Value and error bar; nugget g on the diagonal (over the weights), sigma2 < 0: from the data.
  double solve(std::vector<double>& value, Real sigma2 = -1, const std::vector<Real>& nugget = {}) const {
    const Index k = kernel.rows(), q = basis.cols();
    Matrix system = Matrix::Zero(k + q, k + q);
    system.topLeftCorner(k, k) = kernel;
    for (Index i = 0; i < k && !nugget.empty(); ++i) system(i, i) += nugget[i];
    system.topRightCorner(k, q) = basis;
    system.bottomLeftCorner(q, k) = basis.transpose();
    Matrix right = Matrix::Zero(k + q, values.cols() + 1);
    right.topLeftCorner(k, values.cols()) = values;
    right.topRightCorner(k, 1) = place;
    right.bottomRightCorner(q, 1) = p;
    const Matrix w = system.fullPivLu().solve(right);
    Real own = 0;
    value.clear();
    for (Index c = 0; c < values.cols(); ++c) {
      value.push_back(
          static_cast<double>(place.col(0).dot(w.col(c).head(k)) + p.col(0).dot(w.col(c).tail(q))));
      own += values.col(c).dot(w.col(c).head(k)) / Real(k - q);
    }
    if (sigma2 < 0) sigma2 = own;
    const Real pi2 =
        -(place.col(0).dot(w.rightCols(1).col(0).head(k)) + p.col(0).dot(w.rightCols(1).col(0).tail(q)));
    return static_cast<double>(std::sqrt(sigma2 * pi2));
  }
  // Most likely nugget over the half decades of `top`, by an eigendecomposition; returns the noise.
  Real likely(Real noise, Real top, Real& nugget) const {
    const Index k = kernel.rows(), q = basis.cols();
    const Matrix full = basis.householderQr().householderQ();
    const Matrix q2 = full.rightCols(k - q);
    const Eigen::SelfAdjointEigenSolver<Matrix> eigen(q2.transpose() * kernel * q2);
    const Matrix y = eigen.eigenvectors().transpose() * (q2.transpose() * values);
    Real best = INFINITY, found = 0;
    const Real d = Real(values.cols()), count = Real(k - q) * d;
    for (int i = 0; i < 37; ++i) {
      const Real t = top * std::pow(Real(10), Real(-14) + Real(i) / 2);
      Real logs = 0, squares = 0;
      for (Index j = 0; j < k - q; ++j) {
        const Real l = std::max<Real>(eigen.eigenvalues()[j], 0) + t;
        logs += d * std::log(l), squares += y.row(j).squaredNorm() / l;
      }
      const Real s2 = noise > 0 ? noise * noise / t : squares / count;
      const Real likelihood = count * std::log(s2) + logs + squares / s2;
      if (likelihood < best) best = likelihood, nugget = t, found = std::sqrt(t * s2);
    }
    return found;
  }
};

TEST(Kriging, SolvesTheWholeSystem) {
  struct Case {
    int degree;
    Index points;
    int components, sides;
  };
  for (const Case& c : {Case{4, 80, 1, 0}, Case{4, 80, 3, 1}, Case{3, 60, 1, 2}, Case{2, 40, 2, 0},
                        Case{1, 30, 1, 1}, Case{1, 12, 1, 0}})
    for (std::uint64_t seed : {1, 2, 3}) {
      const Data data = disk(c.points, c.components, seed, c.sides);
      Kriging kriging;
      ASSERT_EQ(kriging.set(data.stencil(), c.degree), c.degree);
      std::vector<double> value(static_cast<std::size_t>(c.components)), expected;
      const double e = kriging.predict(0, value), slow = Slow(data, c.degree).solve(expected);
      // K in the null space has a condition of 1e8 to 1e11, but z* and e keep what the data determines.
      for (int d = 0; d < c.components; ++d) EXPECT_NEAR(value[d], expected[d], 1e-5 * slow + 1e-12);
      EXPECT_NEAR(e, slow, 1e-5 * slow);
    }
}

TEST(Kriging, ReproducesPolynomials) {
  for (int degree = 1; degree <= 4; ++degree) {
    Data data = disk(80);
    for (Index i = 0; i < 80; ++i)
      data.values[i] =
          0.7 + std::pow(data.x[i], degree) - 2 * data.y[i] + data.x[i] * std::pow(data.y[i], degree - 1);
    Kriging kriging;
    ASSERT_EQ(kriging.set(data.stencil(), degree), degree);
    double value;
    const double e = kriging.predict(0, {&value, 1});
    EXPECT_NEAR(value, degree == 1 ? 0.7 : 0.7, 1e-12);
    EXPECT_LT(e, 1e-11);
  }
}

TEST(Kriging, InterpolatesAtAPoint) {
  Data data = disk(80);
  data.x[17] = data.y[17] = 0;
  data.values[17] = 0.123;
  Kriging kriging;
  ASSERT_EQ(kriging.set(data.stencil(), 4), 4);
  double value;
  const double e = kriging.predict(0, {&value, 1});
  EXPECT_NEAR(value, 0.123, 1e-8);
  EXPECT_LT(e, 1e-4);
}

TEST(Kriging, LowersTheDegreeWhereThePolynomialsLoseRank) {
  auto on_lines = [](int lines, double off_line = 0) {
    Data data;
    test::Uniform random(4);
    for (int i = 0; i < 80; ++i) {
      data.x.push_back(lines == 1 ? 0.1 : -0.5 + (i % lines) / (lines - 1.0));
      data.x.back() += off_line * (random() - 0.5);
      data.y.push_back(2 * random() - 1), data.values.push_back(random());
    }
    return data;
  };
  Kriging kriging;
  // x takes `lines` values: x^lines depends on the lower powers.
  for (int lines : {5, 4, 3, 2, 1}) EXPECT_EQ(kriging.set(on_lines(lines).stencil(), 4), lines - 1) << lines;
  EXPECT_EQ(kriging.set(on_lines(3, 1e-9).stencil(), 4), 2);  // nor do lines of points a rounding apart tell
  EXPECT_EQ(kriging.set(on_lines(3, 0.2).stencil(), 4), 4);
  Data circle, diagonal;
  for (int i = 0; i < 80; ++i) {
    circle.x.push_back(std::cos(0.07 * i)), circle.y.push_back(std::sin(0.07 * i)),
        circle.values.push_back(i);
    diagonal.x.push_back(i / 80.0), diagonal.y.push_back(i / 80.0), diagonal.values.push_back(i);
  }
  EXPECT_EQ(kriging.set(circle.stencil(), 4), 1);  // x^2 + y^2 = 1
  EXPECT_EQ(kriging.set(diagonal.stencil(), 4), 0);
}

TEST(Kriging, KeepsFullDegreeOnGridsAndAtCorners) {
  Kriging kriging;
  for (int sides : {0, 1, 2})
    for (std::uint64_t seed = 1; seed <= 50; ++seed)
      EXPECT_EQ(kriging.set(disk(80, 1, seed, sides).stencil(), 4), 4);
  for (double low : {-1.0, 0.0}) {
    Data grid;
    for (int i = 0; i < 9; ++i)
      for (int j = 0; j < 9; ++j)
        grid.x.push_back((low + (1 - low) * i / 8) / 1.5), grid.y.push_back((low + (1 - low) * j / 8) / 1.5),
            grid.values.push_back(i * j);
    EXPECT_EQ(kriging.set(grid.stencil(), 4), 4);
  }
}

TEST(Kriging, SaysNothingFromTooFewPoints) {
  Kriging kriging;
  for (int degree = 1; degree <= 4; ++degree) {
    EXPECT_EQ(kriging.set(disk(least_points(degree)).stencil(), 4), degree);
    EXPECT_EQ(kriging.set(disk(least_points(degree) - 1).stencil(), 4), degree - 1);
  }
}

TEST(Kriging, ErrorBarIsFiniteWherePointsNearlyCoincide) {
  for (double apart : {1e-6, 1e-9, 1e-13, 0.0})
    for (double differ : {0.0, 1e-3}) {
      Data data = disk(80);
      for (Index i = 0; i < 40; ++i) {
        data.x[i + 40] = data.x[i] + apart, data.y[i + 40] = data.y[i];
        data.values[i + 40] = data.values[i] + differ;
      }
      Kriging kriging;
      ASSERT_EQ(kriging.set(data.stencil(), 4), 4);
      double value;
      const double e = kriging.predict(0, {&value, 1});
      EXPECT_TRUE(std::isfinite(value));
      EXPECT_TRUE(std::isfinite(e) && e >= 0);
      // Data that contradicts itself must not be trusted as if it did not.
      if (differ > 0) {
        EXPECT_GT(e, differ);
      }
    }
}

TEST(Kriging, OfNoiseIsTheMostLikelyNugget) {
  for (const bool weighted : {false, true})
    for (std::uint64_t seed : {1, 2}) {
      Data data = disk(60, 2, seed);
      test::Uniform random(seed);
      if (weighted)
        for (int i = 0; i < 60; ++i) data.weights.push_back(0.2 + 3 * random());
      const double noise = 0.03;
      for (Index i = 0; i < 60; ++i)
        for (int c = 0; c < 2; ++c)
          data.values[i * 2 + c] += noise * random.normal() / (weighted ? std::sqrt(data.weights[i]) : 1);
      Kriging kriging;
      ASSERT_EQ(kriging.set(data.stencil(), 3), 3);
      std::vector<double> value(2), expected;
      const double e = kriging.predict(noise, value), found = kriging.likely_noise();
      EXPECT_NEAR(found, noise, 0.4 * noise);
      // The nugget in force follows from e^2 = d noise^2 / g pi^2; the slow way over every g of a fine
      // ladder must meet value and bar at one of them.
      const Slow slow(data, 3);
      double nearest = INFINITY;
      for (double t = 1e-5; t < 1e3; t *= std::pow(10, 1.0 / 64)) {
        std::vector<Real> nugget;
        for (int i = 0; i < 60; ++i) nugget.push_back(t / (weighted ? data.weights[i] : 1));
        const double bar = slow.solve(expected, Real(2 * noise * noise / t), nugget);
        nearest = std::min(nearest, std::abs(bar / e - 1) + std::abs(value[0] - expected[0]) +
                                        std::abs(value[1] - expected[1]));
      }
      EXPECT_LT(nearest, 3e-2);
    }
}

TEST(Kriging, LikelihoodIsThatOfAnEigendecomposition) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (double noise : {0.0, 1e-4, 1e-2, 1.0}) {
      Data data = disk(60, 1, seed);
      test::Uniform random(seed + 50);
      for (double& z : data.values) z += noise * random.normal();
      Kriging kriging;
      ASSERT_EQ(kriging.set(data.stencil(), 3), 3);
      Real nugget;
      // The half decades hang on a bound of the norm here, on 1 there: at most one apart, which is
      // sqrt(sqrt(10)) in the noise.
      const double found = kriging.likely_noise(),
                   slow = static_cast<double>(Slow(data, 3).likely(0, 1, nugget));
      EXPECT_LT(found, 1.8 * slow + 1e-6);
      EXPECT_GT(found, slow / 1.8 - 1e-6);
    }
}

TEST(Kriging, OfAllEqualWeightsIsTheSameAsOfNone) {
  Data data = disk(80, 2);
  Kriging kriging;
  std::vector<double> value(2), weighted(2);
  kriging.set(data.stencil(), 4);
  const double e = kriging.predict(0, value);
  data.weights.assign(80, 1);
  kriging.set(data.stencil(), 4);
  EXPECT_EQ(kriging.predict(0, weighted), e);
  EXPECT_EQ(weighted, value);
  // Without noise weights change nothing: the values are interpolated.
  for (Index i = 0; i < 80; ++i) data.weights[i] = static_cast<double>(1 + i % 5);
  kriging.set(data.stencil(), 4);
  const double other = kriging.predict(0, weighted);
  EXPECT_NEAR(weighted[0], value[0], 1e-6 * e + 1e-12);
  EXPECT_NEAR(other, e, 1e-4 * e);
}

// Row i of the whole inverse by its definition: the stencil without its point i, at that point.
TEST(Kriging, SurpriseIsTheWorstPointLeftOut) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> in(-1, 1);
  for (const double noise : {0.0, 0.05}) {
    const Index k = 50, nearest = 6;
    std::vector<double> x, y, z;
    for (Index i = 0; i < k; ++i) {
      x.push_back(in(random)), y.push_back(in(random));
      z.push_back(std::sin(3 * x.back()) * y.back() + (i == 2 ? 0.3 : 0));
    }
    Kriging all;
    ASSERT_EQ(all.set({x, y, z, {}, 1}, 2), 2);
    double value = 0;
    all.predict(noise, {&value, 1});
    const double surprise = all.surprise(nearest);
    // sigma^2 and the nugget of the whole stencil, on systems with a row less.
    const int q = 6;
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(k + q, k + q);
    for (Index i = 0; i < k; ++i) {
      for (Index j = 0; j < k; ++j) system(i, j) = -std::pow(std::hypot(x[i] - x[j], y[i] - y[j]), 5);
      const double p[q] = {1, x[i], y[i], x[i] * x[i], x[i] * y[i], y[i] * y[i]};
      for (int c = 0; c < q; ++c) system(i, k + c) = system(k + c, i) = p[c];
    }
    double best = std::numeric_limits<double>::infinity(), worst = 0;
    for (int step = 0; step < (noise > 0 ? 4000 : 1); ++step) {
      // The nugget the object took is one of its grid: the one for which the surprises agree best.
      const double nugget = noise > 0 ? std::pow(10, -8 + 0.0025 * step) : 0;
      Eigen::MatrixXd a = system;
      a.topLeftCorner(k, k).diagonal().array() += nugget;
      const Eigen::MatrixXd inverse = a.inverse();
      Eigen::VectorXd right = Eigen::VectorXd::Zero(k + q);
      for (Index i = 0; i < k; ++i) right[i] = z[i];
      const Eigen::VectorXd w = inverse * right;
      const double sigma2 = noise > 0 ? noise * noise / nugget : w.head(k).dot(right.head(k)) / (k - q);
      double most = 0;
      for (Index i = 0; i < nearest; ++i)
        most = std::max(most, std::abs(w[i]) / std::sqrt(inverse(i, i) * sigma2));
      if (std::abs(most - surprise) < best) best = std::abs(most - surprise), worst = most;
    }
    EXPECT_NEAR(surprise, worst, (noise > 0 ? 1e-2 : 1e-6) * worst) << noise;
    if (noise == 0) {
      EXPECT_GT(surprise, 2);  // point 2 is off
    }
    EXPECT_LE(all.surprise(1), surprise);
    EXPECT_EQ(all.surprise(0), 0);
  }
}

// Points crowded in pairs, as where a mesh map squeezes rows of triangles: the error bar must not come from the
// rounding of a difference, where it was a millionth of the error.
TEST(Kriging, ErrorBarHoldsWherePointsCrowd) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> in(-1, 1);
  double worst = 0;
  for (int stencil = 0; stencil < 300; ++stencil) {
    std::vector<double> x, y, z;
    const double near = std::pow(10, -3 - 3 * (in(random) + 1));  // 1e-9 to 1e-3
    for (int i = 0; i < 40; ++i) {
      const double s = in(random), t = 0.4 * in(random) + 0.5 * s * s;
      for (const double off : {0.0, near}) {
        x.push_back(s + off), y.push_back(t + off * in(random));
        z.push_back(std::cos(2 * x.back()) + x.back() * y.back() + 0.2 * std::abs(y.back() - 0.1));
      }
    }
    Kriging kriging;
    ASSERT_EQ(kriging.set({x, y, z, {}, 1}, 4), 4);
    double value = 0;
    const double e = kriging.predict(0, {&value, 1}), truth = 1 + 0.2 * 0.1;
    worst = std::max(worst, std::abs(value - truth) / (e + 1e-9));
  }
  EXPECT_LT(worst, 100);  // a crease near the place; 23 bars here
}

}  // namespace
}  // namespace knotfit::verify
