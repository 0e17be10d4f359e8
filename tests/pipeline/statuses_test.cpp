// How the whole way ends, in status and words.
#include <gtest/gtest.h>

#include "pipeline/fits.h"
namespace knotfit::test {
namespace {

void expect_words(const FitResult& r, const std::string& words) {
  EXPECT_NE(r.message.find(words), std::string::npos) << r.message;
}

TEST(PipelineStatuses, DataTooSparse) {
  const ParameterizedPoints points = synthetic_points("ridge", 300);
  const FitResult r = fit_surface(points, to_tolerance(1e-6));
  EXPECT_EQ(r.status, Status::data_too_sparse);
  EXPECT_FALSE(r.reached);
  expect_words(r, "the 300 points are too sparse for this tolerance");
  expect_honest(r, points);
}

TEST(PipelineStatuses, LimitReached) {
  const ParameterizedPoints points = synthetic_points("ridge", 2000);
  FitOptions options = to_tolerance(1e-6);
  options.max_control_points = 60;
  const FitResult r = fit_surface(points, options);
  EXPECT_EQ(r.status, Status::limit_reached);
  EXPECT_LE(r.surface.control_point_count(), 60);
  expect_words(r, "the limit on control points or fits was reached; best");
  expect_honest(r, points);
}

TEST(PipelineStatuses, ToleranceBelowNoise) {
  ParameterizedPoints points = synthetic_points("franke", 5000);
  Uniform random(4);
  for (double& z : points.values) z += 0.01 * random.normal();
  const FitResult r = fit_surface(points, to_tolerance(0.01));
  EXPECT_EQ(r.status, Status::tolerance_below_noise);
  EXPECT_NEAR(r.noise, 0.01, 0.003);
  expect_words(r, "the tolerance is below the noise of the data (standard deviation about 0.0");
  expect_honest(r, points);
}

TEST(PipelineStatuses, NoiseIsInTheUnitOfTheData) {
  ParameterizedPoints points = synthetic_points("franke", 5000);
  Uniform random(4);
  for (double& z : points.values) z = 1e4 * (z + 0.01 * random.normal()) + 3e6;
  const FitResult r = fit_surface(points, to_tolerance(1e3));
  EXPECT_NEAR(r.noise, 100, 30);
}

TEST(PipelineStatuses, StoppedBeforeItBegan) {
  const ParameterizedPoints points = synthetic_points("ridge", 2000);
  std::stop_source source;
  source.request_stop();
  Control control;
  control.stop = source.get_token();
  for (const FitOptions& options : {to_tolerance(1e-4), at_size(10, 10)}) {
    const FitResult r = fit_surface(points, options, control);
    EXPECT_EQ(r.status, Status::stopped);
    expect_words(r, "stopped; best");
    expect_honest(r, points);
  }
}

TEST(PipelineStatuses, StoppedOnTheWay) {
  const ParameterizedPoints points = synthetic_points("ridge", 2000);
  std::stop_source source;
  Control control;
  control.stop = source.get_token();
  int calls = 0;
  control.progress = [&](const Progress& p) {
    EXPECT_FALSE(p.stage.empty());
    if (++calls == 4) source.request_stop();
  };
  FitOptions options = to_tolerance(1e-4);
  options.between = true;
  const FitResult r = fit_surface(points, options, control);
  EXPECT_EQ(r.status, Status::stopped);
  EXPECT_FALSE(r.between.measured);
  expect_honest(r, points);
}

TEST(PipelineStatuses, TimeLimit) {
  const ParameterizedPoints points = synthetic_points("ridge", 20000);
  Control control;
  control.time_limit = 0.01;
  const FitResult r = fit_surface(points, to_tolerance(1e-4), control);
  EXPECT_EQ(r.status, Status::time_limit);
  expect_words(r, "the time limit cut the search short");
  expect_honest(r, points);
}

TEST(PipelineStatuses, FailedWhereKnotsCannotBeSolved) {
  // Nothing tells the surface beyond the jump apart (tests of the fit): said, not guessed.
  ParameterizedPoints points = synthetic_points("franke", 600);
  for (Index k = 0; k < points.size(); ++k) points.uv[2 * k] /= 2;
  FitOptions options = to_tolerance(1e-2);
  options.knots = InteriorKnots{{0.75, 0.75, 0.75, 0.75}, {0.5}};
  const FitResult r = fit_surface(points, options);
  EXPECT_EQ(r.status, Status::failed);
  EXPECT_TRUE(r.surface.empty());
  EXPECT_FALSE(r.reached);
  expect_words(r, "no surface: the normal equations of these knots cannot be solved");
}

}  // namespace
}  // namespace knotfit::test
