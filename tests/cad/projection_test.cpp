// Closest points against OpenCASCADE's projection, which shares no code with them.
#include <gtest/gtest.h>

#include <GeomAPI_ProjectPointOnSurf.hxx>
#include <Geom_BSplineSurface.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <cstdlib>

#include "knotfit/closest_point.h"
#include "knotfit/correct.h"
#include "knotfit/parameterize_mesh.h"
#include "parameterize/mesh_support.h"
namespace knotfit::test {
namespace {

Handle(Geom_BSplineSurface) in_occt(const Surface& s) {
  TColgp_Array2OfPnt poles(1, static_cast<int>(s.size_u()), 1, static_cast<int>(s.size_v()));
  for (int i = 0; i < s.size_u(); ++i)
    for (int j = 0; j < s.size_v(); ++j) {
      const auto p = s.control_point(i, j);
      poles.SetValue(i + 1, j + 1, {p[0], p[1], p[2]});
    }
  const auto knots = [](const KnotVector& k, bool multiplicities) {
    const std::vector<double> breaks = k.breaks();
    std::vector<double> values;
    for (const double b : breaks) values.push_back(multiplicities ? k.multiplicity(b) : b);
    return values;
  };
  const auto reals = [](const std::vector<double>& x) {
    TColStd_Array1OfReal a(1, static_cast<int>(x.size()));
    for (std::size_t k = 0; k < x.size(); ++k) a.SetValue(static_cast<int>(k) + 1, x[k]);
    return a;
  };
  const auto integers = [](const std::vector<double>& x) {
    TColStd_Array1OfInteger a(1, static_cast<int>(x.size()));
    for (std::size_t k = 0; k < x.size(); ++k) a.SetValue(static_cast<int>(k) + 1, static_cast<int>(x[k]));
    return a;
  };
  return new Geom_BSplineSurface(poles, reals(knots(s.knots_u(), false)), reals(knots(s.knots_v(), false)),
                                 integers(knots(s.knots_u(), true)), integers(knots(s.knots_v(), true)),
                                 s.degree_u(), s.degree_v());
}

class ProjectionOn : public testing::TestWithParam<const char*> {};

TEST_P(ProjectionOn, IsNoNearerThanTheClosestPoint) {
  if (!std::getenv("KNOTFIT_DATA")) GTEST_SKIP() << "KNOTFIT_DATA names no folder of meshes";
  const Mesh mesh = read_mesh(GetParam());
  const MeshMap map = parameterize_mesh(mesh, {.corners = CornerRule::sharpest, .omega = 0});
  const KnotVector knots = KnotVector::uniform(3, 8);
  const CorrectionResult r = correct_parameters(mesh, map, knots, knots, {.rounds = 10});
  const Handle(Geom_BSplineSurface) surface = in_occt(r.surface);
  GeomAPI_ProjectPointOnSurf projection;
  projection.Init(surface, 0, 1, 0, 1, 1e-9);
  const double size = r.surface.scale();
  int looked = 0, equal = 0;
  for (Index k = 0; k < mesh.vertex_count(); k += std::max<Index>(1, mesh.vertex_count() / 400)) {
    const double* p = mesh.vertex(k);
    projection.Perform({p[0], p[1], p[2]});
    if (projection.NbPoints() == 0) continue;  // it looks for feet in the inside alone
    const double ours = std::abs(r.signed_distances[k]), theirs = projection.LowerDistance();
    EXPECT_LE(ours, theirs + 1e-9 * size) << "vertex " << k;
    ++looked;
    equal += std::abs(ours - theirs) <= 1e-7 * size;
  }
  // Where the nearest point is on the border, theirs is another extremum.
  EXPECT_GT(looked, 200);
  EXPECT_GT(equal, 9 * looked / 10);
}
INSTANTIATE_TEST_SUITE_P(Cad, ProjectionOn, testing::Values("mask.obj", "three_peaks.off", "cowhead.obj"),
                         [](const auto& tested) {
                           return std::string(tested.param, std::string(tested.param).find('.'));
                         });

}  // namespace
}  // namespace knotfit::test
