#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "knotfit/threads.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

using Numbers = std::vector<double>;
const double kNan = std::numeric_limits<double>::quiet_NaN();

/// Equal to the last bit; any NaN is like any other.
void expect_same_bits(const Numbers& a, const Numbers& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (std::isnan(a[k]) && std::isnan(b[k])) continue;
    ASSERT_EQ(std::memcmp(&a[k], &b[k], sizeof(double)), 0) << "number " << k << ": " << a[k] << ", " << b[k];
  }
}

/// Inside, outside, on knots, and now and then NaN.
double some_parameter(Random& random, const KnotVector& t) {
  const int kind = random.integer(0, 20);
  if (kind == 0) return kNan;
  if (kind == 1) return random.uniform(t.first() - 1, t.last() + 1);
  if (kind <= 3) return t[random.integer(0, static_cast<int>(t.knots().size()) - 1)];
  return random_parameter(random, t);
}

Numbers one_at_a_time(const Surface& s, const Numbers& uv, int a, int b) {
  Numbers result;
  const int order = a + b;
  for (std::size_t k = 0; k < uv.size(); k += 2) {
    const Numbers all = evaluate_derivatives(s, uv[k], uv[k + 1], order);
    const auto at = all.begin() + (a * (order + 1) + b) * s.dimension();
    result.insert(result.end(), at, at + s.dimension());
  }
  return result;
}

TEST(EvaluateMany, GivesTheBitsOfOneAtATime) {
  Random random;
  for (int k = 0; k < 60; ++k) {
    const Surface s = random_surface(random, random.integer(1, 5));
    // From hardly a point a cell to many.
    Numbers uv(static_cast<std::size_t>(2 * random.integer(0, 1 << random.integer(0, 12))));
    for (std::size_t i = 0; i < uv.size(); ++i)
      uv[i] = some_parameter(random, i % 2 == 0 ? s.knots_u() : s.knots_v());
    for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {1, 2}, {3, 0}, {0, 10}})
      expect_same_bits(evaluate(s, uv, a, b), one_at_a_time(s, uv, a, b));
    Numbers values(static_cast<std::size_t>(s.dimension()));
    const Numbers many = evaluate(s, uv);
    for (std::size_t i = 0; i < uv.size() / 2; ++i) {
      evaluate(s, uv[2 * i], uv[2 * i + 1], values);
      expect_same_bits(values, Numbers(many.begin() + static_cast<Index>(i) * s.dimension(),
                                       many.begin() + static_cast<Index>(i + 1) * s.dimension()));
    }
  }
}

TEST(EvaluateMany, GivesTheSameBitsForOneAndTwoThreads) {
  Random random;
  for (int k = 0; k < 5; ++k) {
    const Surface s = random_surface(random, 3);
    Numbers uv(160000), u(150), v(170);  // more than a block of points
    for (std::size_t i = 0; i < uv.size(); ++i)
      uv[i] = some_parameter(random, i % 2 == 0 ? s.knots_u() : s.knots_v());
    for (double& x : u) x = some_parameter(random, s.knots_u());
    for (double& x : v) x = some_parameter(random, s.knots_v());
    set_thread_count(1);
    const Numbers one = evaluate(s, uv), grid_one = evaluate_grid(s, u, v, 1, 0);
    set_thread_count(2);
    expect_same_bits(one, evaluate(s, uv));
    expect_same_bits(grid_one, evaluate_grid(s, u, v, 1, 0));
    set_thread_count(0);
  }
}

TEST(EvaluateGrid, GivesTheBitsOfOneAtATime) {
  Random random;
  for (int k = 0; k < 60; ++k) {
    const Surface s = random_surface(random, random.integer(1, 4));
    Numbers u(static_cast<std::size_t>(random.integer(0, 20))),
        v(static_cast<std::size_t>(random.integer(0, 20))), uv;
    for (double& x : u) x = some_parameter(random, s.knots_u());
    for (double& x : v) x = some_parameter(random, s.knots_v());
    for (double x : u)
      for (double y : v) uv.insert(uv.end(), {x, y});
    for (const auto& [a, b] : {std::pair{0, 0}, {1, 0}, {2, 1}, {10, 0}})
      expect_same_bits(evaluate_grid(s, u, v, a, b), one_at_a_time(s, uv, a, b));
  }
}

TEST(EvaluateMany, NamesWhatIsWrong) {
  const Surface s(KnotVector::uniform(2, 0), KnotVector::uniform(2, 0), 1, Numbers(9, 1.0));
  const Numbers odd(3, 0.5), pair(2, 0.5);
  expect_throw<InvalidInput>([&] { evaluate(s, odd); },
                             "parameters come in pairs (u, v); there are 3 numbers");
  expect_throw<InvalidInput>([&] { evaluate(s, pair, -1, 0); },
                             "derivative (-1, 0) asked for; orders must be >= 0");
  expect_throw<InvalidInput>([&] { evaluate(Surface(), pair); }, "surface to evaluate is empty");
  expect_throw<InvalidInput>([&] { evaluate_grid(s, pair, pair, 0, -1); }, "derivative (0, -1) asked for");
  expect_throw<InvalidInput>([&] { evaluate_grid(Surface(), pair, pair); }, "surface to evaluate is empty");
}

}  // namespace
}  // namespace knotfit::test
