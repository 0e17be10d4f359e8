// Rows at a fixed number of knots: the RMS error, and known knots given back.
#include <algorithm>
#include <cmath>

#include "data.h"
#include "knotfit/evaluate.h"
#include "knotfit/fit_least_squares.h"
#include "knotfit/place.h"
#include "row.h"
#include "support/synthetic.h"
namespace knotfit::bench {
namespace {

LeastSquaresResult fit(const ParameterizedPoints& points, const InteriorKnots& knots, double smoothing) {
  LeastSquaresOptions options;
  options.smoothing = smoothing;
  options.estimate_condition = false;
  return fit_least_squares(points, KnotVector::clamped(3, knots.u), KnotVector::clamped(3, knots.v), options);
}

Figures equal_knots(const std::string& name, int count, std::uint64_t seed) {
  const Data data = make_data(name, 10000, seed);
  PlacementOptions options;
  options.interior_u = options.interior_v = count;
  const Stopwatch watch;
  const Placement placement = place_knots("optimal", data.points, options);
  const double user = watch.user(), wall = watch.wall();
  return {{"rms", fit(data.points, placement.knots, options.smoothing).error.rms},
          {"fits", placement.fits},
          {"user", user},
          {"wall", wall}};
}

/// Uneven knots, no span below 30 % of the mean; a pair made equal where `doubled`.
std::vector<double> uneven_knots(test::Uniform& random, int count, bool doubled) {
  std::vector<double> knots(static_cast<std::size_t>(count));
  for (double& x : knots) x = random();
  std::sort(knots.begin(), knots.end());
  std::vector<double> length;
  double before = 0, excess = 0;
  const double least = 0.3 / (count + 1);
  for (double x : knots) length.push_back(x - before), before = x;
  length.push_back(1 - before);
  for (double h : length) excess += std::max(0.0, h - least);
  before = 0;
  for (std::size_t i = 0; i < knots.size(); ++i)
    knots[i] = before += least + std::max(0.0, length[i] - least) * 0.7 / excess;
  if (doubled && count > 1) {
    const auto i = static_cast<std::size_t>(random() * (count - 1));
    knots[i + 1] = knots[i];
  }
  return knots;
}

Figures known_knots(bool doubled, int count, int trial) {
  test::Uniform random(static_cast<std::uint64_t>(1000 * count + trial + (doubled ? 500 : 0)));
  InteriorKnots truth;
  truth.u = uneven_knots(random, count, doubled);
  truth.v = uneven_knots(random, count, doubled);
  const KnotVector u = KnotVector::clamped(3, truth.u), v = KnotVector::clamped(3, truth.v);
  ParameterizedPoints points;
  for (int k = 0; k < 20000; ++k) points.uv.push_back(random());
  std::vector<double> net(static_cast<std::size_t>(u.size() * v.size()));
  for (double& c : net) c = random.normal();
  points.values = evaluate(Surface(u, v, 1, net), points.uv);

  PlacementOptions options;
  options.interior_u = options.interior_v = count;
  options.smoothing = 1e-14;
  const Stopwatch watch;
  const Placement placement = place_knots("optimal", points, options);
  const double user = watch.user();
  double off = 0;
  for (std::size_t i = 0; i < truth.u.size(); ++i)
    off = std::max(
        {off, std::abs(placement.knots.u[i] - truth.u[i]), std::abs(placement.knots.v[i] - truth.v[i])});
  return {{"off", off},
          {"error", fit(points, placement.knots, options.smoothing).error.max / bounding_diagonal(points)},
          {"fits", placement.fits},
          {"user", user}};
}

}  // namespace

std::vector<Row> equal_knots_rows() {
  std::vector<Row> rows;
  for (const std::string& name : test::synthetic_names())
    for (int count : {8, 15})
      for (int seed : {1, 2, 3})
        rows.push_back({{"equal", name, std::to_string(count), std::to_string(seed)},
                        [=] { return equal_knots(name, count, static_cast<std::uint64_t>(seed)); }});
  return rows;
}

std::vector<Row> known_knots_rows() {
  std::vector<Row> rows;
  for (bool doubled : {false, true})
    for (int count = doubled ? 2 : 1; count <= 12; ++count)
      for (int trial = 0; trial < 5; ++trial)
        rows.push_back(
            {{"known", doubled ? "double" : "simple", std::to_string(count), std::to_string(trial)},
             [=] { return known_knots(doubled, count, trial); }});
  return rows;
}

}  // namespace knotfit::bench
