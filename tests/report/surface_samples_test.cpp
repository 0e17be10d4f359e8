#include "report/surface_samples.h"

#include <gtest/gtest.h>

#include <string>

#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "scenes.h"
namespace knotfit::report {
namespace {

TEST(SurfaceSamples, HoldEveryKnotLine) {
  const KnotVector u = KnotVector::clamped(2, std::vector{0.1, 0.1, 0.37, 0.9});
  const KnotVector v = KnotVector::uniform(1, 2);
  const Surface s(u, v, 1, std::vector<double>(static_cast<std::size_t>(u.size() * v.size()), 1.0));
  const SurfaceSamples samples = sample_surface(s, {}, 30);
  std::vector<double> lines;
  for (Index k : samples.knots_u) lines.push_back(samples.u[k]);
  EXPECT_EQ(lines, u.breaks());
  EXPECT_EQ(samples.multiplicity_u, (std::vector<int>{1, 2, 1, 1, 1}));
  EXPECT_EQ(samples.knots_v.size(), 4u);
}

TEST(SurfaceSamples, LieOnTheSurface) {
  ParameterMap map;
  map.u0 = 100;
  map.u1 = 300;
  map.v1 = 50;
  const Surface s = scenes::heights(scenes::hills);
  const SurfaceSamples samples = sample_surface(s, map, 40);
  for (Index i = 0; i < samples.size_u(); i += 7)
    for (Index j = 0; j < samples.size_v(); j += 5) {
      double z = 0;
      evaluate(s, samples.u[i], samples.v[j], {&z, 1});
      const Vec3 p = samples.to_scene({map.from_u(samples.u[i]), map.from_v(samples.v[j]), z});
      EXPECT_NEAR(length(p - samples.position[samples.at(i, j)]), 0, 1e-12);
    }
}

TEST(SurfaceSamples, FitIntoTheSceneWhateverTheUnits) {
  for (double scale : {1e-200, 1e-6, 1.0, 1e8, 1e200})
    for (double offset : {0.0, 1e8}) {
      if (offset > 0 && scale < 1e-3) continue;  // below the rounding of the offset
      const Surface s = scenes::in_space([&](double u, double v) {
        return std::vector{offset + scale * (u + 0.1 * v), offset + scale * v, offset + scale * u * v};
      });
      const SurfaceSamples samples = sample_surface(s, {}, 20);
      for (std::size_t k = 0; k < samples.position.size(); ++k) {
        ASSERT_LE(length(samples.position[k]), 1.2) << scale;
        ASSERT_NEAR(length(samples.normal[k]), 1, 1e-6) << scale << " + " << offset;
      }
    }
}

TEST(SurfaceSamples, KeepTheScaleOfHeightsThatShowWellAndSayWhenNot) {
  auto exaggeration = [](double range) {
    return sample_surface(scenes::heights([&](double u, double v) { return range * scenes::hills(u, v); }),
                          {}, 40)
        .exaggeration();
  };
  EXPECT_EQ(exaggeration(0.15), 1);
  EXPECT_GT(exaggeration(1e-3), 10);
  EXPECT_LT(exaggeration(1e3), 1e-2);
}

TEST(SurfaceSamples, KnowAHeightFieldKeptInSpace) {
  const Surface height = scenes::heights(scenes::hills);
  const Surface space = height_field_in_space(height, 10, 12, 5, 6);
  EXPECT_TRUE(sample_surface(space, {}, 20).height_field);
  EXPECT_TRUE(sample_surface(transposed(space), {}, 20).height_field);
  EXPECT_FALSE(sample_surface(scenes::in_space([](double u, double v) {
                                return std::vector{u + 0.2 * v, v, u * v};
                              }),
                              {}, 20)
                   .height_field);
}

TEST(SurfaceSamples, LeaveOutWhatSwingsFarOutsideTheData) {
  const Surface s = scenes::heights([](double u, double v) { return u > 0.7 && v > 0.7 ? 500.0 : u; });
  const DataBox box{{0, 0, 0}, {1, 1, 1}};
  const SurfaceSamples cut = sample_surface(s, {}, 60, box);
  EXPECT_TRUE(cut.cut);
  EXPECT_LE(cut.high.z, 4.0 / 3 + 1e-12);
  EXPECT_FALSE(sample_surface(s, {}, 60).cut);
  EXPECT_FALSE(sample_surface(s, {}, 60, DataBox{{0, 0, -9}, {1, 1, -8}}).cut)
      << "none of it is near this data";
}

TEST(SurfaceSamples, HaveNoReliefWhereThereIsOnlyRounding) {
  EXPECT_EQ(sample_surface(scenes::heights([](double, double) { return 5.1; }), {}, 20).scale.z, 0);
  const SurfaceSamples point = sample_surface(scenes::in_space([](double, double) {
                                                return std::vector{3.1, 3.1, 3.1};
                                              }),
                                              {}, 20);
  for (const Vec3& p : point.position) EXPECT_EQ(length(p), 0);
}

TEST(SurfaceSamples, RefuseWhatHasNoPicture) {
  EXPECT_THROW(sample_surface(Surface(), {}, 20), InvalidInput);
  try {
    sample_surface(scenes::in_space([](double u, double v) { return std::vector{u, v}; }), {}, 20);
    FAIL();
  } catch (const InvalidInput& e) {
    EXPECT_NE(std::string(e.what()).find("dimension 2"), std::string::npos);
  }
}

}  // namespace
}  // namespace knotfit::report
