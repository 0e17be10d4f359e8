#include "correct/mesh_at_parameters.h"

#include <gtest/gtest.h>

#include <cmath>

#include "correct/flat_mesh.h"
#include "correct/penalised_error.h"
namespace knotfit::correction {
namespace {

/// A flat sheet with some edges that are halved, over 4 x 4 spans.
struct Flat {
  HoldingMesh mesh = flat(5);
  FixedKnots knots{KnotVector::uniform(3, 3), KnotVector::uniform(3, 3), 1};
  CorrectionOptions options;
  MeshAtParameters at{mesh, knots, options};
  CellPolynomials plain() const { return CellPolynomials(*at.plain_fit()); }
};

TEST(MeshAtParameters, HasNoLongEdges) {
  const Flat f;
  EXPECT_GT(f.mesh.size(), f.mesh.own);
  for (const auto& t : f.mesh.face)
    for (int k = 0; k < 3; ++k)
      for (int c = 0; c < 2; ++c)
        EXPECT_LE(std::abs(f.mesh.uv[2 * t[k] + c] - f.mesh.uv[2 * t[(k + 1) % 3] + c]), 0.6 / 4);
}

TEST(MeshAtParameters, FarPointsWeighMoreAndTheSumStays) {
  const Flat f;
  const std::vector<double> base = f.at.weights();
  std::vector<double> squared(base.size(), 1.0);
  squared[3] = 400;
  EXPECT_EQ(f.at.weights(0, squared), base);
  const std::vector<double> raised = f.at.weights(2, squared);
  double before = 0, after = 0, mean = 0, data = 0;
  for (std::size_t i = 0; i < base.size(); ++i) {
    if (!f.at.is_data(i)) {
      EXPECT_EQ(raised[i], base[i]);
      continue;
    }
    before += base[i], after += raised[i];
    mean += squared[i], data += 1;
  }
  mean /= data;
  EXPECT_NEAR(before, 1, 1e-12);
  EXPECT_NEAR(after, before, 1e-12);
  // (1 + kappa min(d^2 / mean, 64)) of the far one by that of another.
  EXPECT_NEAR(raised[3] / raised[0], (1 + 2 * std::min(400 / mean, 64.0)) / (1 + 2 / mean), 1e-12);
}

TEST(MeshAtParameters, JudgesByTheDistancesOfTheData) {
  const Flat f;
  const Judgement on_it = f.at.judge(f.plain());
  EXPECT_LT(on_it.max, 1e-7);  // the floor's trace
  EXPECT_EQ(on_it.folded, 0);
  const Surface plain = *f.at.plain_fit();
  std::vector<double> net = plain.net();
  for (std::size_t k = 2; k < net.size(); k += 3) net[k] += 0.25;
  const Judgement above = f.at.judge(CellPolynomials(Surface(plain.knots_u(), plain.knots_v(), 3, net)));
  EXPECT_NEAR(above.rms, 0.25, 1e-7);
  EXPECT_NEAR(above.max, 0.25, 1e-7);
  EXPECT_EQ(above.error, above.rms);  // what counts by default
  EXPECT_EQ(above.penalised_error, penalised_error(above.rms, above.folded));
}

TEST(MeshAtParameters, GoesBackToParametersGiven) {
  Flat f;
  const std::vector<double> first = f.mesh.uv;
  const Surface plain = *f.at.plain_fit();
  std::vector<double> net = plain.net();
  for (std::size_t k = 0; k < net.size(); k += 3) net[k] *= 0.9;  // the feet lie farther along u
  f.at.move(CellPolynomials(Surface(plain.knots_u(), plain.knots_v(), 3, net)));
  EXPECT_NE(f.mesh.uv, first);
  f.at.set_parameters(first);
  EXPECT_EQ(f.mesh.uv, first);
}

TEST(PenalisedError, AddsTwentyTimesTheFoldedShare) {
  EXPECT_EQ(penalised_error(3, 0), 3);
  EXPECT_DOUBLE_EQ(penalised_error(3, 1), 63);
}

}  // namespace
}  // namespace knotfit::correction
