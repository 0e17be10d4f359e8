#include "data.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <numeric>

#include "knotfit/evaluate.h"
#include "support/synthetic.h"
#include "verify/reference_field.h"
namespace knotfit::bench {
namespace {

bool in_hole(double u, double v) {
  return std::hypot(u - 0.5, v - 0.5) < std::sqrt(0.2 / std::numbers::pi);
}

double user_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

double wall_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

std::string name_of(Variant variant) {
  switch (variant) {
    case Variant::plain:
      return "plain";
    case Variant::hole:
      return "hole";
    case Variant::clusters:
      return "clusters";
    case Variant::noise:
      return "noise";
  }
  return "";
}

Data make_data(const std::string& name, Index count, std::uint64_t seed, Variant variant) {
  Data data;
  data.name = name;
  ParameterizedPoints& points = data.points;
  points.dimension = test::synthetic_dimension(name);
  points.height_field = points.dimension == 1;
  test::Uniform random(seed);
  while (points.size() < count) {
    const double u = random(), v = random();
    if (variant == Variant::hole && in_hole(u, v)) continue;
    if (variant == Variant::clusters && random() > std::pow(30.0, -u)) continue;
    points.uv.insert(points.uv.end(), {u, v});
    for (double x : test::synthetic_value(name, u, v)) points.values.push_back(x);
  }
  data.diagonal = test::synthetic_diagonal(points);
  if (variant == Variant::noise) {
    test::Uniform noise(seed + 777);
    for (double& x : points.values) x += 2e-4 * data.diagonal * noise.normal();
  }
  return data;
}

FreshError fresh_error(const Surface& surface, const Data& data, double tolerance,
                       const InteriorKnots& metric) {
  constexpr int kSide = 400;
  std::vector<double> uv;
  for (int i = 0; i < kSide; ++i)
    for (int j = 0; j < kSide; ++j) uv.insert(uv.end(), {(i + 0.5) / kSide, (j + 0.5) / kSide});
  const std::vector<double> values = evaluate(surface, uv);
  const auto dimension = static_cast<std::size_t>(data.points.dimension);
  std::vector<double> error(uv.size() / 2);
  for (std::size_t k = 0; k < error.size(); ++k) {
    const std::vector<double> truth = test::synthetic_value(data.name, uv[2 * k], uv[2 * k + 1]);
    double sum = 0;
    for (std::size_t d = 0; d < dimension; ++d) sum += test::square(values[k * dimension + d] - truth[d]);
    error[k] = std::sqrt(sum);
  }
  std::vector<std::size_t> order(error.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return error[a] > error[b]; });

  // References cost most: from the largest error down, until one is promised.
  FreshError fresh{error[order.front()], 0};
  const verify::ReferenceField field(data.points, tolerance, metric.u, metric.v, 1);
  constexpr std::size_t kBatch = 256;
  for (std::size_t at = 0; at < order.size(); at += kBatch) {
    std::vector<verify::Place> places;
    for (std::size_t i = at; i < std::min(at + kBatch, order.size()); ++i)
      places.push_back({uv[2 * order[i]], uv[2 * order[i] + 1]});
    const std::vector<verify::ReferenceValue> reference = field.at(places);
    for (std::size_t i = 0; i < places.size(); ++i)
      if (reference[i].error_bar <= tolerance / 2 && reference[i].gap <= verify::kHole) {
        fresh.promised = error[order[at + i]];
        return fresh;
      }
  }
  return fresh;
}

Stopwatch::Stopwatch() : user_(user_seconds()), wall_(wall_seconds()) {}
double Stopwatch::user() const {
  return user_seconds() - user_;
}
double Stopwatch::wall() const {
  return wall_seconds() - wall_;
}

}  // namespace knotfit::bench
