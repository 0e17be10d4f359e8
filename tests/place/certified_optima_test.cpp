// Optima of free knots known to 20 digits (docs/certified-optima.md): from every listed start, 6 digits of the error.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "knotfit/curve_points.h"
#include "place/levenberg.h"
#include "place/strip.h"
namespace knotfit::test {
namespace {

using Json = nlohmann::json;

struct Optimum {
  Json json;
};
void PrintTo(const Optimum& o, std::ostream* out) {
  *out << o.json["name"];
}

std::vector<Optimum> optima() {
  std::ifstream in(std::string(KNOTFIT_TEST_DATA) + "/free_knots/optima.json");
  const Json all = Json::parse(in, nullptr, false);
  std::vector<Optimum> list;
  if (all.is_array())
    for (const Json& one : all) list.push_back({one});
  return list;
}

class CertifiedOptimum : public testing::TestWithParam<Optimum> {
 protected:
  bool curve() const { return GetParam().json["split"].is_null(); }
  int degree() const { return GetParam().json["degree"]; }
  double phi() const { return std::stod(GetParam().json["phi"].get<std::string>()); }

  ParameterizedPoints points() const {
    const Json& values = GetParam().json["values"];
    const double last = static_cast<double>(values.size()) - 1;
    if (curve()) {
      CurvePoints points;
      points.dimension = 1;
      for (std::size_t k = 0; k < values.size(); ++k) {
        points.t.push_back(static_cast<double>(k) / last);
        points.values.push_back(values[k]);
      }
      return strip_of(points);
    }
    ParameterizedPoints points;
    for (std::size_t i = 0; i < values.size(); ++i)
      for (std::size_t j = 0; j < values.size(); ++j) {
        points.uv.insert(points.uv.end(), {static_cast<double>(i) / last, static_cast<double>(j) / last});
        points.values.push_back(values[i][j]);
      }
    return points;
  }

  InteriorKnots knots_of(const std::vector<double>& x) const {
    if (curve()) return {x, {}};
    const auto split = x.begin() + GetParam().json["split"].get<int>();
    return {{x.begin(), split}, {split, x.end()}};
  }

  MovingFit problem(const ParameterizedPoints& points) const {
    LeastSquaresOptions options;
    options.smoothing = 0;
    options.refinement_steps = 0;
    options.estimate_condition = false;
    options.use_grid = false;
    return MovingFit(points, degree(), curve() ? 1 : degree(), options);
  }
  /// The strip holds every point of a curve twice.
  double copies() const { return curve() ? 2 : 1; }
};

TEST_P(CertifiedOptimum, HasTheErrorThatIsListed) {
  std::vector<double> knots;
  for (const Json& k : GetParam().json["optimum"]) knots.push_back(std::stod(k.get<std::string>()));
  const ParameterizedPoints data = points();
  MovingFit fit = problem(data);
  ASSERT_TRUE(fit.solve(knots_of(knots)));
  EXPECT_NEAR(fit.phi() / copies(), phi(), 1e-9 * phi());
}

TEST_P(CertifiedOptimum, IsReachedFromEveryStart) {
  const ParameterizedPoints data = points();
  MovingFit fit = problem(data);
  if (GetParam().json["starts"].empty()) GTEST_SKIP() << GetParam().json["why_no_starts"].get<std::string>();
  LevenbergOptions options;
  options.steps = 400;
  options.fall = 1e-9;
  options.least_span = 1e-5;  // some optima have knots that coincide
  for (const Json& start : GetParam().json["starts"]) {
    InteriorKnots knots = knots_of(start.get<std::vector<double>>());
    const double reached = minimize_over_knots(fit, knots, options) / copies();
    // Six digits of the error, the root of phi.
    EXPECT_NEAR(std::sqrt(reached), std::sqrt(phi()), 1e-6 * std::sqrt(phi())) << start;
  }
}

INSTANTIATE_TEST_SUITE_P(Certified, CertifiedOptimum, testing::ValuesIn(optima()), [](const auto& at) {
  std::string name = at.param.json["name"];
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
});

TEST(CertifiedOptima, AreAtLeastTwentyWithStarts) {
  Index with_starts = 0;
  for (const Optimum& o : optima()) with_starts += !o.json["starts"].empty();
  EXPECT_GE(with_starts, 20);
}

}  // namespace
}  // namespace knotfit::test
