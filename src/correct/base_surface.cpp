#include "knotfit/base_surface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "knotfit/closest_point.h"
#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
#include "knotfit/fit_least_squares.h"
#include "parameterize/cloud_triangulation.h"
#include "parameterize/row_parameters.h"
namespace knotfit {
namespace {

using Point = std::array<double, 3>;

constexpr double kMeet = 1e-2;  // of the curves' mean length, how far ends may be apart
constexpr Index kSpans = 20, kSamples = 4 * kSpans + 1;

double apart(const Point& a, const Point& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// A curve by chord length over [0,1].
struct Chain {
  std::vector<Point> point;
  std::vector<double> at;
  double length = 0;

  Chain(const std::vector<double>& xyz, std::size_t number) {
    if (xyz.size() % 3 != 0 || xyz.size() < 6)
      throw InvalidInput(fmt::format("boundary curve {} has {} points: a curve needs at least 2", number + 1,
                                     xyz.size() / 3));
    for (std::size_t k = 0; k < xyz.size(); k += 3) {
      for (std::size_t c = 0; c < 3; ++c)
        if (!(std::abs(xyz[k + c]) < 1e150))
          throw InvalidInput(fmt::format("boundary curve {}: a coordinate of point {} is not finite",
                                         number + 1, k / 3 + 1));
      point.push_back({xyz[k], xyz[k + 1], xyz[k + 2]});
    }
    std::vector<double> chords;
    for (std::size_t k = 1; k < point.size(); ++k) chords.push_back(apart(point[k - 1], point[k]));
    for (const double chord : chords) length += chord;
    at = parameterize::cumulative_parameters(chords);
    if (at.empty()) throw InvalidInput(fmt::format("boundary curve {} has no length", number + 1));
  }
  void turn() {
    std::reverse(point.begin(), point.end());
    std::reverse(at.begin(), at.end());
    for (double& t : at) t = 1 - t;
  }
  Point operator()(double t) const {
    const auto above = std::upper_bound(at.begin(), at.end() - 1, t);
    const auto i = std::max<std::size_t>(1, static_cast<std::size_t>(above - at.begin()));
    const double width = at[i] - at[i - 1], share = width > 0 ? (t - at[i - 1]) / width : 0;
    Point p;
    for (std::size_t c = 0; c < 3; ++c) p[c] = (1 - share) * point[i - 1][c] + share * point[i][c];
    return p;
  }
};

/// Turns and orders the curves: each begins where the one before it ends.
void close_loop(std::vector<Chain>& chain) {
  double mean = 0;
  for (const Chain& c : chain) mean += c.length / 4;
  // The first curve keeps its way round: both its ends must meet another.
  for (std::size_t k = 0; k + 1 < 4; ++k) {
    std::size_t nearest = k + 1;
    bool turned = false;
    double least = INFINITY;
    for (std::size_t j = k + 1; j < 4; ++j)
      for (const bool turn : {false, true}) {
        const double d = apart(chain[k].point.back(), turn ? chain[j].point.back() : chain[j].point.front());
        if (d < least) least = d, nearest = j, turned = turn;
      }
    if (least > kMeet * mean)
      throw InvalidInput(
          fmt::format("the boundary curves make no closed loop: an end is {:.4g} from the nearest other "
                      "(allowed {:.4g}, 1 % of their mean length)",
                      least, kMeet * mean));
    if (turned) chain[nearest].turn();
    std::swap(chain[k + 1], chain[nearest]);
  }
  const double gap = apart(chain[3].point.back(), chain[0].point.front());
  if (gap > kMeet * mean)
    throw InvalidInput(
        fmt::format("the boundary curves make no closed loop: the last ends {:.4g} from where the first "
                    "begins (allowed {:.4g}, 1 % of their mean length)",
                    gap, kMeet * mean));
}

}  // namespace

Surface coons_surface(const std::array<std::vector<double>, 4>& curves) {
  std::vector<Chain> chain;
  for (std::size_t k = 0; k < 4; ++k) chain.emplace_back(curves[k], k);
  close_loop(chain);
  // Counter-clockwise from (0,0): the sides v = 0, u = 1, v = 1, u = 0; the last two run against the parameters.
  chain[2].turn();
  chain[3].turn();
  const Point corner[2][2] = {{chain[0](0), chain[2](0)}, {chain[0](1), chain[2](1)}};
  ParameterizedPoints points;
  points.dimension = 3;
  for (Index i = 0; i < kSamples; ++i)
    for (Index j = 0; j < kSamples; ++j) {
      const double u = static_cast<double>(i) / static_cast<double>(kSamples - 1),
                   v = static_cast<double>(j) / static_cast<double>(kSamples - 1);
      const Point low = chain[0](u), high = chain[2](u), left = chain[3](v), right = chain[1](v);
      points.uv.insert(points.uv.end(), {u, v});
      for (std::size_t c = 0; c < 3; ++c)
        points.values.push_back((1 - v) * low[c] + v * high[c] + (1 - u) * left[c] + u * right[c] -
                                (1 - u) * ((1 - v) * corner[0][0][c] + v * corner[0][1][c]) -
                                u * ((1 - v) * corner[1][0][c] + v * corner[1][1][c]));
    }
  const KnotVector knots = KnotVector::uniform(3, kSpans - 1);
  const LeastSquaresResult fit = fit_least_squares(points, knots, knots);
  if (fit.status != FitStatus::solved)
    throw InvalidInput("no surface could be laid through the boundary curves");
  return fit.surface;
}

CloudMap parameterize_cloud(std::span<const double> points, const Surface& base, const Control& control) {
  const auto n = static_cast<Index>(points.size()) / 3;
  if (n < 4) throw InvalidInput(fmt::format("{} points: a surface needs at least 4", n));
  const ClosestPoints near = closest_points(base, points, {}, control);
  if (near.stopped) throw InvalidInput("stopped before all points were projected to the base surface");
  const double low[2] = {base.knots_u().first(), base.knots_v().first()},
               high[2] = {base.knots_u().last(), base.knots_v().last()};
  std::vector<double> uv = near.uv;
  double square = 0;
  const std::vector<double> derivative[2] = {evaluate(base, near.uv, 1, 0), evaluate(base, near.uv, 0, 1)};
  for (Index k = 0; k < n; ++k) {
    square += near.distances[k] * near.distances[k];
    for (int c = 0; c < 2; ++c) {
      const double at = near.uv[2 * k + c];
      if (at > low[c] && at < high[c]) continue;
      double along = 0, length = 0;
      for (int d = 0; d < 3; ++d) {
        const double t = derivative[c][3 * k + d];
        along += t * (points[3 * k + d] - near.points[3 * k + d]);
        length += t * t;
      }
      if (length > 0) uv[2 * k + c] += along / length;
    }
  }
  // Scales u and v by the base's mean lengths, so that lengths are nearly those in space.
  double sides[2] = {0, 0};
  for (int c = 0; c < 2; ++c)
    for (Index k = 0; k < n; ++k) {
      const double* t = &derivative[c][3 * k];
      sides[c] += std::sqrt(t[0] * t[0] + t[1] * t[1] + t[2] * t[2]) / static_cast<double>(n);
    }
  for (std::size_t k = 0; k < uv.size(); ++k) uv[k] *= sides[k % 2] > 0 ? sides[k % 2] : 1;
  CloudMap map = cloud::triangulate(points, uv);
  map.base = CloudBase::surface;
  map.scatter = std::sqrt(square / static_cast<double>(n));
  return map;
}

}  // namespace knotfit
