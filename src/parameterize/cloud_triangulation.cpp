#include "parameterize/cloud_triangulation.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "knotfit/exceptions.h"
#include "parameterize/cloud_gaps.h"
#include "parameterize/cloud_neighbours.h"
#include "parameterize/delaunay.h"
namespace knotfit::cloud {
namespace {

constexpr int kSpacing = 6;  // a point's spacing is the distance of so many'th neighbour
constexpr double kGap = 8;   // of spacings that an edge may be long
constexpr double kFlat =
    -0.94;  // cosine of the angle opposite the hull from which a triangle is flat: 160 degrees
constexpr double kMostSteps = 12;  // powers of two between the square's sides

struct Box {
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  double side(int c) const { return high[c] - low[c]; }
};

Box box_around(std::span<const double> places) {
  Box box;
  for (std::size_t k = 0; k < places.size(); ++k) {
    box.low[k % 2] = std::min(box.low[k % 2], places[k]);
    box.high[k % 2] = std::max(box.high[k % 2], places[k]);
  }
  return box;
}

/// Grids of u and v: 2^29 steps on the longer side, on the other less by a power of two, so that cells are about
/// square in space and every parameter is an exact double.
struct Grid {
  Box box;
  double steps[2];
  explicit Grid(const Box& around) : box(around) {
    if (!(box.side(0) > 0) || !(box.side(1) > 0))
      throw InvalidInput("all points lie on one straight line of the base: there is no surface over it");
    const double power =
        std::clamp(std::round(std::log2(box.side(0) / box.side(1))), -kMostSteps, kMostSteps);
    steps[0] = std::ldexp(1, kGridBits + static_cast<int>(std::min(power, 0.0)));
    steps[1] = std::ldexp(1, kGridBits - static_cast<int>(std::max(power, 0.0)));
  }
  Place place(const double* at) const {
    Place p;
    for (int c = 0; c < 2; ++c) p[c] = std::llround((at[c] - box.low[c]) / box.side(c) * steps[c]);
    return p;
  }
};

/// Median of three.
double middle(double a, double b, double c) {
  return std::max(std::min(a, b), std::min(std::max(a, b), c));
}

double longest_edge(const std::array<std::int32_t, 3>& triangle, std::span<const double> places) {
  double longest = 0;
  for (int k = 0; k < 3; ++k) {
    const double *a = &places[2 * triangle[k]], *b = &places[2 * triangle[(k + 1) % 3]];
    longest = std::max(longest, std::hypot(b[0] - a[0], b[1] - a[1]));
  }
  return longest;
}

/// Triangles that bridge a gap of the data. The neighbours of a point on a line tell nothing of the next line, but all its
/// triangles reach there, and so do the circles through their corners.
std::vector<char> bridges(const Triangulation& t, std::span<const double> places, const Spacing& circles) {
  const auto n = static_cast<Index>(t.used.size());
  std::vector<double> spacing(static_cast<std::size_t>(n), INFINITY);
  if (n > 2 * kSpacing) {
    for (std::size_t f = 0; f < t.triangle.size(); ++f)
      for (const std::int32_t k : t.triangle[f]) spacing[k] = std::min(spacing[k], circles.radius(f));
    const NeighbourLists near = nearest_neighbours(places, 2, kSpacing);
    for (Index k = 0; k < n; ++k) {
      const double distance = std::sqrt(near.squared[(k + 1) * kSpacing - 1]);
      spacing[k] = std::isfinite(spacing[k]) ? std::max(spacing[k], distance) : distance;
    }
  }
  std::vector<char> bridge;
  for (const auto& f : t.triangle)
    bridge.push_back(longest_edge(f, places) > kGap * middle(spacing[f[0]], spacing[f[1]], spacing[f[2]]));
  return bridge;
}

/// Triangles to drop: from the hull inwards those that bridge, or are flat against it.
std::vector<char> outside(const Triangulation& t, const std::vector<char>& bridge,
                          std::span<const double> places) {
  std::vector<char> gone(t.triangle.size(), 0);
  std::vector<std::int32_t> open;
  const auto flat = [&](std::size_t f, int k) {  // the angle at corner k
    const double *p = &places[2 * t.triangle[f][k]], *a = &places[2 * t.triangle[f][(k + 1) % 3]],
                 *b = &places[2 * t.triangle[f][(k + 2) % 3]];
    const double x = a[0] - p[0], y = a[1] - p[1], z = b[0] - p[0], w = b[1] - p[1];
    return !(x * z + y * w > kFlat * std::hypot(x, y) * std::hypot(z, w));
  };
  const auto look = [&](std::int32_t f) {
    if (gone[f] != 0) return;
    for (int k = 0; k < 3; ++k) {
      const std::int32_t other = t.beside[f][k];
      if ((other < 0 || gone[other] != 0) && (bridge[f] != 0 || flat(static_cast<std::size_t>(f), k))) {
        gone[f] = 1;
        open.push_back(f);
        return;
      }
    }
  };
  for (std::size_t f = 0; f < gone.size(); ++f) look(static_cast<std::int32_t>(f));
  while (!open.empty()) {
    const std::int32_t f = open.back();
    open.pop_back();
    for (const std::int32_t other : t.beside[f])
      if (other >= 0) look(other);
  }
  return gone;
}

/// Points whose triangles are all bridges get back the one with the shortest longest edge.
void keep_every_point(const Triangulation& t, std::span<const double> places, std::vector<char>& bridge) {
  std::vector<std::int32_t> best(t.used.size(), -1);
  std::vector<double> least(t.used.size(), INFINITY);
  for (std::size_t f = 0; f < t.triangle.size(); ++f) {
    const double longest = bridge[f] != 0 ? longest_edge(t.triangle[f], places) : 0;
    for (const std::int32_t k : t.triangle[f])
      if (longest < least[k]) least[k] = longest, best[k] = static_cast<std::int32_t>(f);
  }
  for (const std::int32_t f : best)
    if (f >= 0) bridge[f] = 0;
}

CloudMap triangulate_on(const Grid& grid, std::span<const double> points, std::span<const double> places,
                        bool every_point) {
  const auto n = static_cast<Index>(places.size()) / 2;
  std::vector<Place> cells;
  for (Index k = 0; k < n; ++k) cells.push_back(grid.place(&places[2 * k]));
  const Triangulation t = delaunay(cells);
  if (t.triangle.empty())
    throw InvalidInput("all points lie on one straight line of the base: there is no surface over it");
  const Spacing circles(t.triangle, circle_radii(t.triangle, places, 2), n);
  std::vector<char> bridge = bridges(t, places, circles);
  // Where most of the square is gaps, the measure of a gap is none: points in lines far apart.
  if (2 * std::count(bridge.begin(), bridge.end(), 1) > static_cast<Index>(bridge.size()))
    bridge.assign(bridge.size(), 0);
  std::vector<double> spacing(static_cast<std::size_t>(n), 0);
  if (every_point) {
    keep_every_point(t, places, bridge);
  } else {
    parallel_for(n, [&](Index k) { spacing[k] = circles.at(static_cast<std::int32_t>(k)); });
    const std::vector<char> over = over_openings(t, places, circles, spacing);
    for (std::size_t f = 0; f < over.size(); ++f) bridge[f] |= over[f];
  }
  const std::vector<char> gone = outside(t, bridge, places);
  CloudMap cloud;
  cloud.points = n;
  cloud.mesh.vertices.assign(points.begin(), points.end());
  std::vector<char> real(static_cast<std::size_t>(n), 0);
  for (std::size_t f = 0; f < t.triangle.size(); ++f) {
    if (gone[f] != 0) continue;
    cloud.mesh.faces.push_back(t.triangle[f]);
    cloud.mesh.virtual_face.push_back(bridge[f]);
    for (const std::int32_t k : t.triangle[f])
      if (bridge[f] == 0) real[k] = 1;
  }
  for (Index k = 0; k < n; ++k) {
    cloud.coincident += t.used[k] == 0;
    cloud.lone += t.used[k] != 0 && real[k] == 0;
    cloud.mesh.vertex_line.push_back(k + 1);
    for (int c = 0; c < 2; ++c) cloud.map.uv.push_back(static_cast<double>(cells[k][c]) / grid.steps[c]);
  }
  if (cloud.mesh.faces.empty() || cloud.lone + cloud.coincident == n)
    throw InvalidInput("the points are too few, or too far apart from each other, to make a surface of");
  for (int corner = 0; corner < 4; ++corner) {
    const double u = corner == 1 || corner == 2, v = corner >= 2;
    double least = INFINITY;
    for (Index k = 0; k < n; ++k) {
      const double d = std::hypot(cloud.map.uv[2 * k] - u, cloud.map.uv[2 * k + 1] - v);
      if (real[k] != 0 && d < least) least = d, cloud.map.corners[corner] = k;
    }
  }
  cloud.openings = cloud_openings(cloud.mesh, loose_points(points, real));
  measure_openings(cloud.openings, cloud.mesh, cloud.map.uv);
  cloud.covered = covered_share(cloud.mesh, cloud.map.uv, cloud.openings);
  cloud.outlined = covered_share(cloud.mesh, cloud.map.uv, {});
  if (!every_point)
    cloud.bare = bare_share(places, spacing, real, {grid.box.low[0], grid.box.low[1]},
                            {grid.box.high[0], grid.box.high[1]});
  cloud.map.quality = measure_map(cloud.mesh, cloud.map.uv);
  return cloud;
}

}  // namespace

CloudMap triangulate(std::span<const double> points, std::span<const double> places) {
  return triangulate_on(Grid(box_around(places)), points, places, false);
}

CloudMap triangulate(std::span<const double> points, std::span<const double> places,
                     const std::array<double, 2>& sides) {
  Box box;
  for (int c = 0; c < 2; ++c) box.low[c] = 0, box.high[c] = sides[c];
  return triangulate_on(Grid(box), points, places, true);
}

std::array<double, 2> lengths_of(std::span<const double> points, std::span<const double> uv) {
  // |dx|^2 = a du^2 + b dv^2, relative to |du|^2 + |dv|^2, by least squares over pairs of neighbours.
  const auto n = static_cast<Index>(uv.size()) / 2;
  const int count = static_cast<int>(std::min<Index>(kSpacing, n - 1));
  const NeighbourLists near = nearest_neighbours(uv, 2, count);
  double aa = 0, ab = 0, bb = 0, ax = 0, bx = 0;
  for (Index k = 0; k < n; ++k)
    for (int i = 0; i < count; ++i) {
      const Index j = near.of(k)[i];
      const double u = uv[2 * j] - uv[2 * k], v = uv[2 * j + 1] - uv[2 * k + 1], whole = u * u + v * v;
      if (!(whole > 0)) continue;
      double x = 0;
      for (int c = 0; c < 3; ++c) x += std::pow(points[3 * j + c] - points[3 * k + c], 2);
      const double a = u * u / whole, b = v * v / whole;
      aa += a * a, ab += a * b, bb += b * b, ax += a * x / whole, bx += b * x / whole;
    }
  const double determinant = aa * bb - ab * ab;
  const double a = (ax * bb - bx * ab) / determinant, b = (bx * aa - ax * ab) / determinant;
  constexpr double most = 4096;  // between the two
  if (!(determinant > 0) || !std::isfinite(a) || !std::isfinite(b) || !(a > 0) || !(b > 0)) return {1, 1};
  const double ratio = std::clamp(std::sqrt(b / a), 1 / most, most);
  return {1, ratio};
}

}  // namespace knotfit::cloud
