#include "parameterize/cloud_gaps.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "data/orientation.h"
#include "parameterize/cloud_neighbours.h"
namespace knotfit::cloud {
namespace {

constexpr double kCore =
    2.5;  // spacings, of the sparsest corner: triangles with larger circles may be an opening's
constexpr double kAround = 2;   // spacings: triangles about an opening with larger circles belong to it
constexpr double kReach = 2.5;  // spacings that a point stands for
constexpr double kLarge = 0.6;  // of its empty circle an opening is at least

using Point = std::array<double, 2>;

double cross(const Point& a, const Point& b, const Point& c) {
  return twice_area(a.data(), b.data(), c.data());
}

/// Middle of the circle through three places.
Point middle(const Point& a, const Point& b, const Point& c) {
  const double bx = b[0] - a[0], by = b[1] - a[1], cx = c[0] - a[0], cy = c[1] - a[1];
  const double twice = 2 * (bx * cy - by * cx), b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  return {a[0] + (cy * b2 - by * c2) / twice, a[1] + (bx * c2 - cx * b2) / twice};
}

/// How large the empty circle of a gap is, by the spacing along its rim: an opening or not.
bool is_opening(double radius, double spacing, double area) {
  return radius > kOpening * spacing && area > kLarge * std::numbers::pi * radius * radius;
}

/// The rim of a part of the virtual faces: its edges as the faces have them.
std::vector<std::array<std::int32_t, 2>> rim_of(const Mesh& mesh, const Opening& part) {
  std::map<std::array<std::int32_t, 2>, int> count;
  std::vector<std::array<std::int32_t, 2>> all, rim;
  for (const std::int32_t f : part.faces)
    for (int k = 0; k < 3; ++k) {
      all.push_back({mesh.faces[f][k], mesh.faces[f][(k + 1) % 3]});
      const auto [a, b] = std::minmax(all.back()[0], all.back()[1]);
      ++count[{a, b}];
    }
  for (const auto& e : all)
    if (const auto [a, b] = std::minmax(e[0], e[1]); count[{a, b}] == 1) rim.push_back(e);
  return rim;
}

/// The largest empty circle inside a rim, and the area inside, both in the plane that shows most of it.
struct Inside {
  double radius = 0, area = 0;
};
Inside inside(const Mesh& mesh, const std::vector<std::array<std::int32_t, 2>>& rim,
              std::span<const double> loose) {
  Vector sum{};
  const double* origin = mesh.vertex(rim[0][0]);
  const auto from = [&](const double* p) {
    return Vector{p[0] - origin[0], p[1] - origin[1], p[2] - origin[2]};
  };
  const auto from_origin = [&](std::int32_t k) { return from(mesh.vertex(k)); };
  for (const auto& [a, b] : rim) {
    const Vector p = from_origin(a), q = from_origin(b);
    for (int c = 0; c < 3; ++c) {
      const int d = (c + 1) % 3, e = (c + 2) % 3;
      sum[c] += 0.5 * (p[d] * q[e] - p[e] * q[d]);
    }
  }
  const double area = std::sqrt(dot(sum, sum));
  if (!(area > 0)) return {};
  const Vector normal{sum[0] / area, sum[1] / area, sum[2] / area};
  const auto [first, second] = frame_of(normal);
  std::map<std::int32_t, std::int32_t> number;
  std::vector<Point> at;
  double reach = 0;
  for (const auto& edge : rim)
    for (const std::int32_t k : edge)
      if (number.emplace(k, static_cast<std::int32_t>(at.size())).second) {
        const Vector p = from_origin(k);
        at.push_back({dot(p, first), dot(p, second)});
        reach = std::max({reach, std::abs(at.back()[0]), std::abs(at.back()[1])});
      }
  for (std::size_t k = 0; k + 2 < loose.size(); k += 3) {
    const Vector p = from(&loose[k]);
    if (std::abs(dot(p, normal)) > reach) continue;
    const Point flat{dot(p, first), dot(p, second)};
    if (std::abs(flat[0]) < reach && std::abs(flat[1]) < reach) at.push_back(flat);
  }
  std::vector<Place> places;
  places.reserve(at.size());
  const double scale = std::ldexp(1, kGridBits - 1) / reach;
  for (const Point& p : at)
    places.push_back({std::llround((p[0] + reach) * scale), std::llround((p[1] + reach) * scale)});
  Inside result{0, area};
  for (const auto& t : delaunay(places).triangle) {
    const Point &a = at[t[0]], &b = at[t[1]], &c = at[t[2]];
    const Point m{(a[0] + b[0] + c[0]) / 3, (a[1] + b[1] + c[1]) / 3};
    int turns = 0;  // of the rim around m
    for (const auto& edge : rim) {
      const Point &p = at[number[edge[0]]], &q = at[number[edge[1]]];
      if ((p[1] > m[1]) == (q[1] > m[1])) continue;
      const double side = cross(p, q, m);
      turns += p[1] <= m[1] ? side > 0 : -(side < 0);
    }
    if (turns == 0) continue;
    const double twice = std::abs(cross(a, b, c));
    if (!(twice > 0)) continue;
    const double radius = std::hypot(b[0] - a[0], b[1] - a[1]) * std::hypot(c[0] - b[0], c[1] - b[1]) *
                          std::hypot(a[0] - c[0], a[1] - c[1]) / (2 * twice);
    // A circle whose middle is beyond the rim is that of a flat triangle against it.
    if (radius * radius * std::numbers::pi * kLarge < area) result.radius = std::max(result.radius, radius);
  }
  return result;
}

}  // namespace

std::vector<double> circle_radii(std::span<const std::array<std::int32_t, 3>> triangle,
                                 std::span<const double> at, int dimension) {
  std::vector<double> radius;
  radius.reserve(triangle.size());
  for (const auto& t : triangle) {
    double square[3] = {0, 0, 0}, along = 0;
    for (int c = 0; c < dimension; ++c) {
      const double p = at[t[1] * Index{dimension} + c] - at[t[0] * Index{dimension} + c],
                   q = at[t[2] * Index{dimension} + c] - at[t[0] * Index{dimension} + c];
      square[0] += p * p, square[1] += q * q, square[2] += (q - p) * (q - p), along += p * q;
    }
    const double twice = std::sqrt(std::max(0.0, square[0] * square[1] - along * along));
    const double sides = std::sqrt(square[0]) * std::sqrt(square[1]) * std::sqrt(square[2]);
    radius.push_back(twice > 0 ? sides / (2 * twice) : sides > 0 ? INFINITY : 0);
  }
  return radius;
}

Spacing::Spacing(std::span<const std::array<std::int32_t, 3>> triangle, std::vector<double> radius,
                 Index vertices)
    : triangle_(triangle), radius_(std::move(radius)), stars_(triangle, vertices) {}

double Spacing::at(std::int32_t vertex) const {
  std::vector<std::int32_t> faces;
  for (const std::int32_t f : stars_.of(vertex))
    for (const std::int32_t k : triangle_[f]) {
      const auto more = stars_.of(k);
      faces.insert(faces.end(), more.begin(), more.end());
    }
  if (faces.empty()) return INFINITY;
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  std::vector<double> radii;
  radii.reserve(faces.size());
  for (const std::int32_t f : faces) radii.push_back(radius_[f]);
  const auto half = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2);
  std::nth_element(radii.begin(), half, radii.end());
  return *half;
}

std::vector<char> over_openings(const Triangulation& t, std::span<const double> places,
                                const Spacing& circles, const std::vector<double>& spacing) {
  const auto at = [&](std::int32_t k) { return Point{places[2 * k], places[2 * k + 1]}; };
  std::vector<double> ratio;
  std::vector<std::array<std::int32_t, 2>> hull;  // counter-clockwise
  for (std::size_t f = 0; f < t.triangle.size(); ++f) {
    double most = 0;
    for (int k = 0; k < 3; ++k) {
      most = std::max(most, spacing[t.triangle[f][k]]);
      if (t.beside[f][k] < 0) hull.push_back({t.triangle[f][(k + 1) % 3], t.triangle[f][(k + 2) % 3]});
    }
    ratio.push_back(circles.radius(f) / most);
  }
  const auto within_hull = [&](const Point& p) {
    return std::all_of(hull.begin(), hull.end(),
                       [&](const auto& e) { return cross(at(e[0]), at(e[1]), p) >= 0; });
  };
  std::vector<char> over(t.triangle.size(), 0), met(t.triangle.size(), 0);
  for (std::size_t first = 0; first < ratio.size(); ++first) {
    const auto is_core = [&](std::size_t f) {
      if (!(ratio[f] > kCore) || !std::isfinite(circles.radius(f))) return false;
      const auto& c = t.triangle[f];
      return within_hull(middle(at(c[0]), at(c[1]), at(c[2])));
    };
    if (met[first] != 0 || !is_core(first)) continue;
    std::vector<std::size_t> part{first};
    met[first] = 1;
    double radius = 0, area = 0, length = 0, sum = 0;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const std::size_t f = part[i];
      const auto& c = t.triangle[f];
      area += std::abs(cross(at(c[0]), at(c[1]), at(c[2]))) / 2;
      if (is_core(f)) radius = std::max(radius, circles.radius(f));
      for (int k = 0; k < 3; ++k) {
        const std::int32_t other = t.beside[f][k];
        if (other >= 0 && ratio[other] > kAround) {
          if (met[other] == 0) {
            met[other] = 1;
            part.push_back(static_cast<std::size_t>(other));
          }
        } else if (other >= 0) {
          const std::int32_t a = c[(k + 1) % 3], b = c[(k + 2) % 3];
          const double side = std::hypot(at(b)[0] - at(a)[0], at(b)[1] - at(a)[1]);
          length += side, sum += side * (spacing[a] + spacing[b]) / 2;
        }
      }
    }
    if (length > 0 && is_opening(radius, sum / length, area))
      for (const std::size_t f : part) over[f] = 1;
  }
  return over;
}

std::vector<Opening> cloud_openings(const Mesh& mesh, std::span<const double> loose) {
  std::vector<Opening> parts = find_openings(mesh);
  if (parts.empty()) return parts;
  std::vector<std::array<std::int32_t, 3>> data;
  for (Index f = 0; f < mesh.face_count(); ++f)
    if (mesh.virtual_face[f] == 0) data.push_back(mesh.faces[f]);
  const Spacing spacing(data, circle_radii(data, mesh.vertices, 3), mesh.vertex_count());
  std::erase_if(parts, [&](const Opening& part) {
    const auto rim = rim_of(mesh, part);
    if (rim.empty()) return true;
    double length = 0, sum = 0;
    for (const auto& [a, b] : rim) {
      const double *p = mesh.vertex(a), *q = mesh.vertex(b);
      const double side = std::hypot(q[0] - p[0], q[1] - p[1], q[2] - p[2]);
      length += side, sum += side * (spacing.at(a) + spacing.at(b)) / 2;
    }
    // Around so large a circle the rim is longer than this.
    if (!(length > 4.8 * kOpening * sum / length)) return true;
    const Inside hole = inside(mesh, rim, loose);
    return !is_opening(hole.radius, sum / length, hole.area);
  });
  return parts;
}

std::vector<double> loose_points(std::span<const double> points, const std::vector<char>& joined) {
  std::vector<double> loose;
  for (std::size_t k = 0; k < joined.size(); ++k)
    if (joined[k] == 0) loose.insert(loose.end(), &points[3 * k], &points[3 * k] + 3);
  return loose;
}

double bare_share(std::span<const double> places, const std::vector<double>& spacing,
                  const std::vector<char>& counts, const std::array<double, 2>& low,
                  const std::array<double, 2>& high) {
  constexpr Index cells = 128;
  const double step[2] = {(high[0] - low[0]) / cells, (high[1] - low[1]) / cells};
  std::vector<char> near(cells * cells, 0);
  for (std::size_t k = 0; k < spacing.size(); ++k) {
    if (counts[k] == 0) continue;
    const double reach = std::min(kReach * spacing[k], 2 * std::hypot(high[0] - low[0], high[1] - low[1]));
    Index from[2], to[2];
    for (int c = 0; c < 2; ++c) {
      const double x = (places[2 * k + c] - low[c]) / step[c], wide = reach / step[c];
      from[c] = std::clamp<Index>(static_cast<Index>(std::floor(x - wide)), 0, cells - 1);
      to[c] = std::clamp<Index>(static_cast<Index>(std::floor(x + wide)), 0, cells - 1);
    }
    for (Index i = from[0]; i <= to[0]; ++i)
      for (Index j = from[1]; j <= to[1]; ++j) {
        const double x = low[0] + (static_cast<double>(i) + 0.5) * step[0] - places[2 * k],
                     y = low[1] + (static_cast<double>(j) + 0.5) * step[1] - places[2 * k + 1];
        // The cell of a point counts, however near the points are.
        const bool own = std::abs(x) <= step[0] / 2 && std::abs(y) <= step[1] / 2;
        if (own || x * x + y * y <= reach * reach) near[i * cells + j] = 1;
      }
  }
  return static_cast<double>(std::count(near.begin(), near.end(), 0)) / static_cast<double>(cells * cells);
}

}  // namespace knotfit::cloud
