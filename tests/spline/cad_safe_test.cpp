#include "knotfit/cad_safe.h"

#include <gtest/gtest.h>

#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "spline/projection.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
#include "support/sampling.h"
namespace knotfit::test {
namespace {

/// The face over (u, v), the later one on a border.
const Surface& face_at(const std::vector<Surface>& faces, double u, double v) {
  const Surface* found = nullptr;
  for (const Surface& f : faces)
    if (f.knots_u().first() <= u && u <= f.knots_u().last() && f.knots_v().first() <= v &&
        v <= f.knots_v().last())
      found = &f;
  EXPECT_NE(found, nullptr) << u << " " << v;
  return *found;
}

/// Largest distance of the faces to the surface at random places.
double distance_to_faces(const Surface& s, const std::vector<Surface>& faces, Random& random,
                         int places = 300) {
  double largest = 0;
  std::vector<double> x(static_cast<std::size_t>(s.dimension())), y = x;
  for (int k = 0; k < places; ++k) {
    const double u = random_parameter(random, s.knots_u()), v = random_parameter(random, s.knots_v());
    evaluate(s, u, v, x);
    evaluate(face_at(faces, u, v), u, v, y);
    double squared = 0;
    for (std::size_t d = 0; d < x.size(); ++d) squared += (x[d] - y[d]) * (x[d] - y[d]);
    largest = std::max(largest, std::sqrt(squared));
  }
  return largest;
}

void expect_safe(const std::vector<Surface>& faces, const CadSafe& options, const Surface& s) {
  const auto check = [&](const KnotVector& k, double domain) {
    EXPECT_EQ(k.degree(), options.degree);
    EXPECT_TRUE(k.is_clamped());
    EXPECT_LE(k.size(), options.most_control_points);
    const std::vector<double> breaks = k.breaks();
    for (std::size_t b = 1; b < breaks.size(); ++b)
      EXPECT_GE(breaks[b] - breaks[b - 1], options.least_knot_distance * domain);
    for (const double knot : k.interior()) EXPECT_LT(k.multiplicity(knot), options.degree);  // C1 inside
  };
  for (const Surface& f : faces) {
    check(f.knots_u(), s.knots_u().last() - s.knots_u().first());
    check(f.knots_v(), s.knots_v().last() - s.knots_v().first());
  }
}

Surface random_of_degrees(Random& random, int p, int q, int interior, int dimension = 3) {
  std::vector<double> u, v;
  for (int k = 0; k < interior; ++k) {
    u.push_back(random.uniform(0.01, 0.99));
    v.push_back(random.uniform(0.01, 0.99));
  }
  std::sort(u.begin(), u.end());
  std::sort(v.begin(), v.end());
  const KnotVector ku = KnotVector::clamped(p, u), kv = KnotVector::clamped(q, v);
  return Surface(ku, kv, dimension, random_numbers(random, ku.size() * kv.size() * dimension));
}

/// A smooth surface of any degree: control points on a wave at the Greville abscissae.
Surface wave(int p, int q, int interior) {
  const KnotVector ku = KnotVector::uniform(p, interior), kv = KnotVector::uniform(q, interior);
  std::vector<double> net;
  for (const double a : ku.greville())
    for (const double b : kv.greville()) net.insert(net.end(), {a, b, std::sin(5 * a) * std::cos(4 * b)});
  return Surface(ku, kv, 3, std::move(net));
}

TEST(CadSafe, LowerDegreesAreTheSurfaceItself) {
  Random random;
  CadSafe options;
  options.least_knot_distance = 0;
  for (int k = 0; k < 60; ++k) {
    const int p = random.integer(1, 3), q = random.integer(1, 3);
    // Clamped or not, multiple knots, folds and jumps.
    const KnotVector u = random_knots(random, p, Ends::any, 5), v = random_knots(random, q, Ends::any, 5);
    const Surface s(u, v, 3, random_numbers(random, u.size() * v.size() * 3, random.log_uniform(1e-6, 1e6)));
    const std::vector<Surface> faces = cad_safe(s, options);
    expect_safe(faces, options, s);
    EXPECT_LE(distance_to_faces(s, faces, random), 400 * kEps * s.scale());
  }
}

TEST(CadSafe, LeavesASafeSurfaceAsItIs) {
  Random random;
  const Surface s = random_of_degrees(random, 3, 3, 8);
  const std::vector<Surface> faces = cad_safe(s);
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_EQ(faces.front(), s);
}

TEST(CadSafe, ReducesHigherDegreesWithinTheTolerance) {
  Random random;
  for (const auto& [p, q] : {std::pair{5, 3}, {4, 7}, {9, 9}, {2, 6}}) {
    const Surface s = wave(p, q, 3);
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
      CadSafe options;
      options.tolerance = tolerance;
      const std::vector<Surface> faces = cad_safe(s, options);
      expect_safe(faces, options, s);
      EXPECT_LE(distance_to_faces(s, faces, random), tolerance) << p << " " << q;
    }
  }
}

TEST(CadSafe, ADegreeThatIsOnlyOnPaperIsReducedAtNoTolerance) {
  // A plane of degree 7.
  const KnotVector k = KnotVector::uniform(7, 2);
  std::vector<double> net;
  for (const double a : k.greville())
    for (const double b : k.greville()) net.insert(net.end(), {a, b, 2 * a - 3 * b});
  const Surface s(k, k, 3, std::move(net));
  Random random;
  const std::vector<Surface> faces = cad_safe(s);
  ASSERT_EQ(faces.size(), 1U);
  EXPECT_EQ(faces.front().degree_u(), 3);
  EXPECT_LE(distance_to_faces(s, faces, random), 1e-12);
}

TEST(CadSafe, RefusesToReduceWithoutATolerance) {
  const Surface s = wave(6, 3, 2);
  expect_throw<InvalidInput>([&] { cad_safe(s); },
                             "degree 6 along u becomes 3 only by moving the surface by up to");
  expect_throw<InvalidInput>([&] { cad_safe(transposed(s)); }, "degree 6 along v becomes 3");
  Random random;
  CadSafe options;
  options.tolerance = 1e-13;  // out of reach of any number of cubic spans
  expect_throw<InvalidInput>([&] { cad_safe(random_of_degrees(random, 9, 3, 20), options); },
                             "allow more, or fit with degree 3");
}

TEST(CadSafe, SplitsAtFoldsAndJumpsIntoFacesThatShareBorders) {
  Random random;
  const std::vector<double> u = {0.2, 0.5, 0.5, 0.5, 0.7, 0.8, 0.8, 0.8, 0.8}, v = {0.3, 0.3, 0.6, 0.6, 0.6};
  const KnotVector ku = KnotVector::clamped(3, u), kv = KnotVector::clamped(3, v);
  const Surface s(ku, kv, 3, random_numbers(random, ku.size() * kv.size() * 3));
  const std::vector<Surface> faces = cad_safe(s);  // u at 0.5 and 0.8, v at 0.6
  ASSERT_EQ(faces.size(), 6U);
  EXPECT_EQ(faces[1].knots_v().first(), 0.6);  // u slowest
  EXPECT_LE(distance_to_faces(s, faces, random), 100 * kEps);
  const Surface &left = faces[0], &right = faces[2];
  ASSERT_EQ(left.knots_v(), right.knots_v());
  for (Index j = 0; j < left.size_v(); ++j)
    for (int d = 0; d < 3; ++d)
      EXPECT_EQ(left.control_point(left.size_u() - 1, j)[d], right.control_point(0, j)[d]);
}

TEST(CadSafe, ReducedFacesStillShareBorders) {
  std::vector<double> interior(5, 0.4);  // a fold of degree 5
  const KnotVector ku = KnotVector::clamped(5, interior), kv = KnotVector::uniform(5, 2);
  std::vector<double> net;
  for (const double a : ku.greville())
    for (const double b : kv.greville()) net.insert(net.end(), {a, b, std::abs(a - 0.4) + std::sin(3 * b)});
  const Surface s(ku, kv, 3, std::move(net));
  CadSafe options;
  options.tolerance = 1e-5;
  const std::vector<Surface> faces = cad_safe(s, options);
  ASSERT_EQ(faces.size(), 2U);
  ASSERT_EQ(faces[0].knots_v(), faces[1].knots_v());
  for (Index j = 0; j < faces[0].size_v(); ++j)
    for (int d = 0; d < 3; ++d)
      EXPECT_EQ(faces[0].control_point(faces[0].size_u() - 1, j)[d], faces[1].control_point(0, j)[d]);
}

TEST(CadSafe, FacesHaveAtMostSoManyControlPointsAndAreEven) {
  Random random;
  const Surface s = random_of_degrees(random, 3, 2, 60);
  CadSafe options;
  options.most_control_points = 25;
  const std::vector<Surface> faces = cad_safe(s, options);
  expect_safe(faces, options, s);
  EXPECT_LE(distance_to_faces(s, faces, random), 400 * kEps);
  Index fewest = options.most_control_points;
  for (const Surface& f : faces) fewest = std::min(fewest, f.size_u());
  EXPECT_GE(fewest, 20);  // 61 spans in 3 pieces: 20 or 21 each and 3 more
}

TEST(CadSafe, MergesNearKnotsWithinTheTolerance) {
  Random random;
  std::vector<double> near = {0.3, 0.3 + 2e-9, 0.6, 0.6, 0.6 + 1e-9, 1 - 1e-9};
  const KnotVector u = KnotVector::clamped(3, near), v = KnotVector::uniform(3, 1);
  std::vector<double> net;
  for (const double a : u.greville())
    for (const double b : v.greville()) net.insert(net.end(), {a, b, std::sin(4 * a) + b * b});
  const Surface s(u, v, 3, std::move(net));
  expect_throw<InvalidInput>([&] { cad_safe(s); }, "are nearer than 1e-07 of the domain, and merging them");
  CadSafe options;
  options.tolerance = 1e-3;
  const std::vector<Surface> faces = cad_safe(s, options);
  expect_safe(faces, options, s);
  EXPECT_LE(distance_to_faces(s, faces, random), options.tolerance);
  // A rough one is merged within what is allowed, or refused.
  options.tolerance = 1e-7;
  const Surface rough(u, v, 1, random_numbers(random, u.size() * v.size()));
  try {
    const std::vector<Surface> rough_faces = cad_safe(rough, options);
    expect_safe(rough_faces, options, rough);
    EXPECT_LE(distance_to_faces(rough, rough_faces, random), options.tolerance);
  } catch (const InvalidInput& e) {
    EXPECT_NE(std::string(e.what()).find("merging them may move"), std::string::npos);
  }
}

TEST(CadSafe, RefusesOptionsOutOfRange) {
  Random random;
  const Surface s = random_of_degrees(random, 3, 3, 2);
  const auto refused = [&](CadSafe options, const std::string& words) {
    expect_throw<InvalidInput>([&] { cad_safe(s, options); }, words);
  };
  refused({.degree = 0}, "degree of CAD faces is 0");
  refused({.degree = 10}, "degree of CAD faces is 10");
  refused({.tolerance = -1}, "tolerance of CAD faces is -1");
  refused({.tolerance = std::nan("")}, "tolerance of CAD faces is nan");
  refused({.most_control_points = 5}, "needs at least 6 control points");
  refused({.least_knot_distance = 0.5}, "least distance of knots is 0.5");
  expect_throw<InvalidInput>([&] { cad_safe(Surface()); }, "is empty");
}

TEST(Projection, ReproducesEverySplineOfItsSpace) {
  Random random;
  for (int k = 0; k < 60; ++k) {
    const Surface s = random_of_degrees(random, random.integer(1, 9), random.integer(1, 4), 6);
    // The Gram matrix of B-splines is as well conditioned as the degree lets it be: about 2^p to 4^p.
    EXPECT_LE(project_u(s, s.knots_u()).error, std::pow(4.0, s.degree_u()) * 100 * kEps);
  }
}

TEST(Projection, BoundsTheMoveFromNearby) {
  Random random;
  for (int k = 0; k < 60; ++k) {
    const Surface s = random_of_degrees(random, random.integer(2, 9), random.integer(1, 4), 4);
    const KnotVector knots = KnotVector::uniform(random.integer(1, 5), random.integer(0, 9));
    const Projection p = project_u(s, knots);
    const double moved = max_distance(s, p.surface, 15);
    EXPECT_LE(moved, p.error);
    EXPECT_LE(p.error, 2.5 * moved);  // 1.09 of the columns' largest; these are above the surface's
    for (Index j = 0; j < s.size_v(); ++j)
      for (int d = 0; d < 3; ++d) {
        EXPECT_EQ(p.surface.control_point(0, j)[d], s.control_point(0, j)[d]);
        EXPECT_EQ(p.surface.control_point(knots.size() - 1, j)[d], s.control_point(s.size_u() - 1, j)[d]);
      }
  }
}

}  // namespace
}  // namespace knotfit::test
