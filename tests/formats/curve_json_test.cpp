#include <gtest/gtest.h>

#include <cmath>

#include "knotfit/curve_io.h"
#include "knotfit/exceptions.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

TEST(CurveJson, RoundTripsEveryBit) {
  Random random;
  for (int run = 0; run < 100; ++run) {
    CurveDocument document;
    document.curve = random_curve(random, random.integer(1, 4));
    document.closed = run % 2 == 0;
    if (document.curve.dimension() == 1 && run % 3 == 0) {
      document.closed = false;
      document.function = true;
      document.x0 = random.uniform(-5, 0);
      document.x1 = random.uniform(1, 2);
    }
    document.options = "{\"a\": 1}";
    document.result = "{\"rms\": 0.1}";
    const CurveDocument read = curve_from_json(to_json(document), "a.json");
    EXPECT_EQ(read.curve, document.curve);
    EXPECT_EQ(read.closed, document.closed);
    EXPECT_EQ(read.function, document.function);
    EXPECT_EQ(read.x0, document.x0);
    EXPECT_EQ(read.x1, document.x1);
    EXPECT_EQ(read.options, document.options);
    EXPECT_EQ(read.result, document.result);
  }
}

TEST(CurveJson, NamesWhatIsWrong) {
  const auto refused = [](const std::string& text, const std::string& words) {
    expect_throw<FileError>([&] { curve_from_json(text, "c.json"); }, words);
  };
  refused("[1]", "a JSON object is missing");
  refused("{}", "not a knotfit curve: the member \"format\" is missing");
  refused("{\"format\": \"knotfit-surface\"}", "foreign schema");
  const std::string head = "{\"format\": \"knotfit-curve\", \"version\": 1, ";
  refused("{\"format\": \"knotfit-curve\", \"version\": 2}", "version 2 of the schema is unknown");
  refused(head + "\"degree\": 2.5}", "degree");
  refused(head + "\"degree\": 1, \"knots\": [0,0,1,1], \"control_points\": []}", "there are no points");
  refused(head + "\"degree\": 1, \"knots\": [0,0,1,1], \"control_points\": [[1,2],[3]]}",
          "point 1 has 1 coordinates, the first 2");
  refused(head + "\"degree\": 1, \"knots\": [0,0,1], \"control_points\": [[1],[3]]}", "knots");
  refused(head + "\"degree\": 1, \"knots\": [0,0,1,1], \"control_points\": [[1],[3]], \"function\": true}",
          "x0");
  refused(head + "\"degree\": 1, \"degree\": 1}", "there twice");
}

TEST(CurveJson, RefusesToWriteWhatIsNone) {
  expect_throw<InvalidInput>([] { to_json(CurveDocument{}); }, "without a curve");
  CurveDocument document;
  document.curve = Curve(KnotVector::uniform(1, 0), 2, {0, 0, 1, 1});
  document.function = true;
  expect_throw<InvalidInput>([&] { to_json(document); }, "needs one component");
  document.function = false;
  document.result = "[1]";
  expect_throw<InvalidInput>([&] { to_json(document); },
                             "the result of a curve document must be a JSON object");
}

TEST(CurveInSpace, KeepsEveryPoint) {
  Random random;
  for (int dimension : {1, 2, 3}) {
    CurveDocument document;
    document.curve = random_curve(random, dimension, Ends::clamped);
    const KnotVector& knots = document.curve.knots();
    document.function = dimension == 1;
    document.x0 = 10;
    document.x1 = 30;
    const Curve space = curve_in_space(document);
    for (int k = 0; k < 20; ++k) {
      const std::vector<double> t{random_parameter(random, knots)};
      const std::vector<double> p = evaluate(space, t), q = evaluate(document.curve, t);
      if (dimension == 1) {
        EXPECT_NEAR(p[0], 10 + t[0] * 20, 1e-10 * (1 + std::abs(p[0])));
        EXPECT_EQ(p[1], q[0]);
      } else {
        for (int e = 0; e < dimension; ++e) EXPECT_EQ(p[e], q[e]);
      }
      if (dimension < 3) {
        EXPECT_EQ(p[2], 0);
      }
    }
  }
  CurveDocument four;
  four.curve = random_curve(random, 4);
  expect_throw<InvalidInput>([&] { curve_in_space(four); }, "4 components");
}

}  // namespace
}  // namespace knotfit::test
