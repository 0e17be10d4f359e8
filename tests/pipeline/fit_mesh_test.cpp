#include "knotfit/fit_mesh.h"

#include <gtest/gtest.h>

#include "knotfit/exceptions.h"
#include "knotfit/threads.h"
#include "parameterize/mesh_support.h"
#include "support/expect_throw.h"
namespace knotfit {
namespace {

using namespace test;

struct Mapped {
  Mesh mesh;
  MeshMap map;
};

const Mapped& ridge() {
  static const Mapped m = [] {
    const auto z = [](double x, double y) { return 0.3 / (1 + std::exp(-25 * (x + 0.3 * y - 0.6))); };
    Mapped r{sheet(30, 30, 1, 1, z, 0.3), {}};
    r.map = parameterize_mesh(r.mesh, {.corners = CornerRule::sharpest, .omega = 0, .newton = false});
    return r;
  }();
  return m;
}

FitOptions at_size(int size, double tolerance = 0) {
  FitOptions options;
  options.control_points_u = options.control_points_v = size;
  options.method = "uniform";
  options.between = false;
  if (tolerance > 0) options.tolerance = ToleranceRequest{.value = tolerance};
  return options;
}

TEST(FitMesh, ItsErrorsAreDistancesToTheSurface) {
  const MeshFit fit = fit_mesh(ridge().mesh, ridge().map, at_size(10));
  EXPECT_EQ(fit.result.status, Status::fixed_size);
  const PointDistances d = point_distances(fit.result.surface, ridge().mesh.vertices);
  ASSERT_EQ(fit.result.errors.size(), d.signed_distances.size());
  for (std::size_t k = 0; k < d.signed_distances.size(); ++k) {
    EXPECT_NEAR(fit.result.errors[k], std::abs(d.signed_distances[k]), 1e-9);
    EXPECT_EQ(fit.result.errors[k], std::abs(fit.signed_distances[k]));
  }
  EXPECT_NEAR(fit.result.error.max, d.summary.max, 1e-9);
  EXPECT_LE(fit.result.error.rms, fit.at_parameters.rms * (1 + 1e-12));
  EXPECT_GT(fit.to_mesh.count, 0);
  EXPECT_FALSE(fit.result.least_squares);
  const FitResult plain = fit_surface(mesh_points(ridge().mesh, ridge().map.uv), at_size(10));
  EXPECT_LT(fit.result.error.rms, 0.5 * plain.error.rms);
}

TEST(FitMesh, TheDistanceIsWhatAToleranceIsHeldBy) {
  const double reached = fit_mesh(ridge().mesh, ridge().map, at_size(10, 1)).result.measured;
  const MeshFit holds = fit_mesh(ridge().mesh, ridge().map, at_size(10, 1.01 * reached));
  const MeshFit fails = fit_mesh(ridge().mesh, ridge().map, at_size(10, 0.2 * reached));
  EXPECT_EQ(holds.result.status, Status::reached);
  EXPECT_TRUE(holds.result.reached);
  EXPECT_EQ(fails.result.status, Status::not_reached);
  EXPECT_FALSE(fails.result.reached);
  EXPECT_NE(holds.result.message.find("hold the tolerance"), std::string::npos);
}

TEST(FitMesh, SaysWhereTheFacetsAreCoarse) {
  const auto z = [](double x, double y) { return 0.4 * std::sin(9 * x) * std::cos(7 * y); };
  const Mesh mesh = sheet(10, 10, 1, 1, z);
  const MeshMap map = parameterize_mesh(mesh, {.corners = CornerRule::sharpest, .omega = 0, .newton = false});
  const MeshFit fit = fit_mesh(mesh, map, at_size(9));
  bool said = false;
  for (const std::string& note : fit.result.notes)
    said = said || note.find("facets are coarse") != std::string::npos;
  EXPECT_EQ(said, fit.to_mesh.rms > 2 * fit.correction.distance.rms);
  EXPECT_TRUE(said);
}

TEST(FitMesh, ASurfaceThatStraysFromTheMeshIsTheFirstNote) {
  // A wave that the vertices sample and the facets do not follow: held at the vertices, far between them.
  const auto z = [](double x, double y) { return 0.4 * std::sin(9 * x) * std::cos(7 * y); };
  const Mesh mesh = sheet(10, 10, 1, 1, z);
  const MeshMap map = parameterize_mesh(mesh, {.corners = CornerRule::sharpest, .omega = 0, .newton = false});
  FitOptions options = at_size(9);
  const MeshFit fixed = fit_mesh(mesh, map, options);
  for (const std::string& note : fixed.result.notes)
    EXPECT_EQ(note.find("strays"), std::string::npos) << note;
  for (const double share : {0.3, 0.7}) {
    options.tolerance = ToleranceRequest{.value = share * fixed.to_mesh.max};
    const MeshFit fit = fit_mesh(mesh, map, options);
    const bool strays = fit.to_mesh.max > 2 * fit.result.tolerance;
    EXPECT_EQ(strays, share < 0.5);
    ASSERT_FALSE(fit.result.notes.empty());
    EXPECT_EQ(fit.result.notes[0].find("between the vertices the surface strays from the mesh by ") == 0,
              strays);
    // The distance of the tool, from more samples, is the same to a hundredth.
    EXPECT_NEAR(mesh_distances(fit.result.surface, mesh).max, fit.to_mesh.max, 0.011 * fit.to_mesh.max);
  }
}

TEST(FitMesh, PointsAwayFromTheirFootPointsAreCounted) {
  const MeshFit fit = fit_mesh(ridge().mesh, ridge().map, at_size(10, 3e-3));
  ASSERT_EQ(fit.foot_uv.size(), 2 * fit.result.errors.size());
  ParameterizedPoints feet = fit.points;
  feet.uv = fit.foot_uv;
  const std::vector<double> there = recheck_errors(fit.result.surface, feet),
                            here = recheck_errors(fit.result.surface, fit.points);
  Index off = 0;
  for (std::size_t k = 0; k < there.size(); ++k) {
    EXPECT_NEAR(there[k], fit.result.errors[k], 1e-9);
    off += here[k] > std::max(3e-3, 2 * there[k]);
  }
  EXPECT_EQ(fit.off_foot, off);
}

TEST(FitMesh, StopsWithAJudgedSurface) {
  std::stop_source stop;
  Control control;
  control.stop = stop.get_token();
  control.progress = [&](const Progress& p) {
    if (p.stage == "correction" && p.fraction > 0.1) stop.request_stop();
  };
  const MeshFit fit = fit_mesh(ridge().mesh, ridge().map, at_size(10), {}, control);
  EXPECT_EQ(fit.result.status, Status::stopped);
  EXPECT_FALSE(fit.result.surface.empty());
  EXPECT_GT(fit.result.error.rms, 0);
}

FitOptions to_tolerance(double tolerance, ErrorMeasure measure = ErrorMeasure::max, double share = 1) {
  FitOptions options;
  options.method = "uniform";
  options.tolerance = ToleranceRequest{.value = tolerance, .measure = measure, .share = share};
  return options;
}

TEST(FitMesh, ASearchHoldsTheDistanceWithFewerControlPoints) {
  const MeshFit fit = fit_mesh(ridge().mesh, ridge().map, to_tolerance(3e-3));
  EXPECT_EQ(fit.result.status, Status::reached);
  EXPECT_LE(point_distances(fit.result.surface, ridge().mesh.vertices).summary.max, 3e-3);
  EXPECT_LE(fit.correction.folds.blurred, 1e-3);
  EXPECT_FALSE(fit.result.tried.empty());
  FitOptions plain = to_tolerance(3e-3);
  plain.between = false;
  const FitResult without = fit_surface(mesh_points(ridge().mesh, ridge().map.uv), plain);
  EXPECT_LT(fit.result.surface.control_point_count(), without.surface.control_point_count());
}

TEST(FitMesh, ALooserToleranceDoesNotAskForMore) {
  Index last = 1 << 30;
  for (const double tolerance : {1e-3, 2e-3, 4e-3, 8e-3, 1.6e-2}) {
    const MeshFit fit = fit_mesh(ridge().mesh, ridge().map, to_tolerance(tolerance));
    EXPECT_EQ(fit.result.status, Status::reached) << tolerance;
    EXPECT_LE(fit.result.surface.control_point_count(), last) << tolerance;
    last = fit.result.surface.control_point_count();
  }
}

TEST(FitMesh, ASearchTakesEveryMeasure) {
  for (const ErrorMeasure measure : {ErrorMeasure::rms, ErrorMeasure::percentile}) {
    const MeshFit fit = fit_mesh(ridge().mesh, ridge().map, to_tolerance(1e-3, measure, 0.95));
    EXPECT_EQ(fit.result.status, Status::reached);
    EXPECT_LE(measured_error(fit.result.errors, fit.result.asked), 1e-3);
  }
}

TEST(FitMesh, ASearchGivesTheSameBitsForAnyNumberOfThreads) {
  set_thread_count(1);
  const MeshFit one = fit_mesh(ridge().mesh, ridge().map, to_tolerance(5e-3));
  set_thread_count(3);
  const MeshFit three = fit_mesh(ridge().mesh, ridge().map, to_tolerance(5e-3));
  set_thread_count(0);
  EXPECT_EQ(one.result.surface, three.result.surface);
  EXPECT_EQ(one.correction.uv, three.correction.uv);
}

TEST(FitMesh, ASearchSaysWhatEndedIt) {
  FitOptions options = to_tolerance(1e-4);
  options.max_control_points = 36;
  const MeshFit limited = fit_mesh(ridge().mesh, ridge().map, options);
  EXPECT_EQ(limited.result.status, Status::limit_reached);
  EXPECT_FALSE(limited.result.reached);
  EXPECT_LE(limited.result.surface.control_point_count(), 36);
  EXPECT_GT(limited.result.measured, 1e-4);
  const MeshFit sparse = fit_mesh(ridge().mesh, ridge().map, to_tolerance(1e-7));
  EXPECT_EQ(sparse.result.status, Status::data_too_sparse);
  std::stop_source stop;
  Control control;
  control.stop = stop.get_token();
  control.progress = [&](const Progress& p) {
    if (p.stage == "size search") stop.request_stop();
  };
  const MeshFit stopped = fit_mesh(ridge().mesh, ridge().map, to_tolerance(1e-4), {}, control);
  EXPECT_EQ(stopped.result.status, Status::stopped);
  EXPECT_FALSE(stopped.result.surface.empty());
}

TEST(FitMesh, RefusesToSearchForNothing) {
  expect_throw<InvalidInput>([&] { fit_mesh(ridge().mesh, ridge().map, {}); },
                             "give a tolerance, a number of control points, or knots");
}

}  // namespace
}  // namespace knotfit
