#include "report/surface_samples.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "knotfit/evaluate.h"
#include "knotfit/exceptions.h"
namespace knotfit::report {
namespace {

struct Lines {
  std::vector<double> at;
  std::vector<Index> knots;
  std::vector<int> multiplicity;
};

// Every span in equal parts, their number by its length, at least two for curved degrees.
Lines grid_lines(const KnotVector& knots, int most) {
  const std::vector<double> breaks = knots.breaks();
  const double width = breaks.back() - breaks.front();
  Lines lines;
  for (std::size_t s = 0; s + 1 < breaks.size(); ++s) {
    const double h = breaks[s + 1] - breaks[s];
    const int parts = std::max(knots.degree() > 1 ? 2 : 1, static_cast<int>(std::ceil(most * h / width)));
    lines.knots.push_back(static_cast<Index>(lines.at.size()));
    lines.multiplicity.push_back(s == 0 ? 1 : knots.multiplicity(breaks[s]));
    for (int k = 0; k < parts; ++k) lines.at.push_back(breaks[s] + h * k / parts);
  }
  lines.knots.push_back(static_cast<Index>(lines.at.size()));
  lines.multiplicity.push_back(1);
  lines.at.push_back(breaks.back());
  return lines;
}

// A height field kept as a surface in space: x changes with u alone and y with v alone, or the
// other way round.
bool is_height_field_in_space(const Surface& s) {
  if (s.dimension() < 3) return false;
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  for (Index k = 0; k < s.control_point_count(); ++k)
    for (int d = 0; d < 2; ++d) {
      low[d] = std::min(low[d], s.net()[k * s.dimension() + d]);
      high[d] = std::max(high[d], s.net()[k * s.dimension() + d]);
    }
  auto constant_along = [&](int d, bool along_v) {
    const double slack = 1e-9 * (high[d] - low[d]);
    for (Index i = 0; i < s.size_u(); ++i)
      for (Index j = 0; j < s.size_v(); ++j)
        if (!(std::abs(s.control_point(i, j)[d] - s.control_point(along_v ? i : 0, along_v ? 0 : j)[d]) <=
              slack))
          return false;
    return high[d] > low[d];
  };
  return (constant_along(0, true) && constant_along(1, false)) ||
         (constant_along(1, true) && constant_along(0, false));
}

struct Tangents {
  Vec3 u, v;
};

// The scale of x and y: radius about 1, a strip longer than 4 to 1 is drawn as 4 to 1.
Vec3 plane_scale(const Vec3& extent) {
  const double plane = std::max(extent.x, extent.y);
  Vec3 scale{1.2 / plane, 1.2 / plane, 1.2 / plane};
  if (extent.x > 0 && extent.x < plane / 4) scale.x = 1.2 / (4 * extent.x);
  if (extent.y > 0 && extent.y < plane / 4) scale.y = 1.2 / (4 * extent.y);
  return scale;
}

// Heights may have another unit than x and y: they keep their true scale only where that shows a
// relief of a usable height. Else nine tenths of the surface are made less steep than 40 degrees.
double height_scale(const Vec3& extent, const Vec3& plane, const std::vector<Tangents>& tangents) {
  const double ratio = extent.z * plane.z / 1.2;
  if (!(ratio > 0) || (ratio >= 0.14 && ratio <= 0.6)) return plane.z;
  std::vector<double> slope;
  slope.reserve(tangents.size());
  for (const Tangents& t : tangents) {
    const double u = std::hypot(t.u.x * plane.x, t.u.y * plane.y);
    const double v = std::hypot(t.v.x * plane.x, t.v.y * plane.y);
    if (u > 0 && v > 0) slope.push_back(std::hypot(t.u.z / extent.z / u, t.v.z / extent.z / v));
  }
  if (slope.empty()) return 0.26 * 1.2 / extent.z;
  const auto most = slope.begin() + static_cast<std::ptrdiff_t>(0.9 * static_cast<double>(slope.size() - 1));
  std::nth_element(slope.begin(), most, slope.end());
  constexpr double kSlope = 0.84;
  return std::clamp(kSlope / std::max(*most, 1e-12), 0.14 * 1.2, 0.40 * 1.2) / extent.z;
}

bool inside(const Vec3& p, const DataBox& box) {
  return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y && p.z >= box.low.z &&
         p.z <= box.high.z;
}

// The box with a third of its extent (x, y, z alike in space) added around.
DataBox widened(const DataBox& box, bool heights) {
  const Vec3 size = box.high - box.low;
  const double third = heights ? size.z / 3 : std::max({size.x, size.y, size.z}) / 3;
  const Vec3 more{heights ? INFINITY : third, heights ? INFINITY : third, third};
  return {box.low - more, box.high + more};
}

}  // namespace

SurfaceSamples sample_surface(const Surface& surface, const ParameterMap& map, int most,
                              const std::optional<DataBox>& data_box) {
  if (surface.empty()) throw InvalidInput("a picture needs a surface, and this one is empty");
  const int dimension = surface.dimension();
  if (dimension == 2)
    throw InvalidInput(
        "a surface of dimension 2 has no picture: heights (dimension 1) or points in space "
        "(dimension 3) can be drawn");
  SurfaceSamples s;
  Lines u = grid_lines(surface.knots_u(), most), v = grid_lines(surface.knots_v(), most);
  s.u = std::move(u.at);
  s.v = std::move(v.at);
  s.knots_u = std::move(u.knots);
  s.knots_v = std::move(v.knots);
  s.multiplicity_u = std::move(u.multiplicity);
  s.multiplicity_v = std::move(v.multiplicity);
  s.height_field = dimension == 1 || is_height_field_in_space(surface);
  if (dimension == 1) {
    s.name_x = map.name_u;
    s.name_y = map.name_v;
  }

  const std::vector<double> value = evaluate_grid(surface, s.u, s.v);
  const std::vector<double> du = evaluate_grid(surface, s.u, s.v, 1, 0);
  const std::vector<double> dv = evaluate_grid(surface, s.u, s.v, 0, 1);
  const auto n = static_cast<std::size_t>(s.size_u() * s.size_v());
  const auto stride = static_cast<std::size_t>(s.size_v());
  auto entry = [&](const std::vector<double>& of, std::size_t k) {
    const double* p = of.data() + k * static_cast<std::size_t>(dimension);
    return dimension == 1 ? Vec3{0, 0, p[0]} : Vec3{p[0], p[1], p[2]};
  };
  s.position.resize(n);
  std::vector<Tangents> tangents(n);
  const auto origin = map.from_uv(0, 0), along_u = map.from_uv(1, 0), along_v = map.from_uv(0, 1);
  for (std::size_t k = 0; k < n; ++k) {
    Vec3& p = s.position[k] = entry(value, k);
    tangents[k] = {entry(du, k), entry(dv, k)};
    if (dimension == 1) {
      const auto [x, y] = map.from_uv(s.u[k / stride], s.v[k % stride]);
      p.x = x;
      p.y = y;
      tangents[k].u.x = along_u[0] - origin[0];
      tangents[k].u.y = along_u[1] - origin[1];
      tangents[k].v.x = along_v[0] - origin[0];
      tangents[k].v.y = along_v[1] - origin[1];
    }
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
      throw InvalidInput("the surface has a point that is not finite; it cannot be drawn");
  }

  s.kept.assign(n, 1);
  if (data_box) {
    const DataBox box = widened(*data_box, s.height_field);
    std::size_t count = 0;
    for (std::size_t k = 0; k < n; ++k)
      count += static_cast<std::size_t>(s.kept[k] = inside(s.position[k], box));
    s.cut = count < n;
    if (count < n / 4) {  // not a surface of this data: show what there is
      s.kept.assign(n, 1);
      s.cut = false;
    }
  }
  s.low = {INFINITY, INFINITY, INFINITY};
  s.high = {-INFINITY, -INFINITY, -INFINITY};
  for (std::size_t k = 0; k < n; ++k) {
    const Vec3& p = s.position[k];
    if (!s.kept[k]) continue;
    s.low = {std::min(s.low.x, p.x), std::min(s.low.y, p.y), std::min(s.low.z, p.z)};
    s.high = {std::max(s.high.x, p.x), std::max(s.high.y, p.y), std::max(s.high.z, p.z)};
  }
  s.centre = 0.5 * s.low + 0.5 * s.high;
  // An extent below the rounding of the coordinates is noise, not shape: it is drawn as none.
  auto extent = [](double low, double high) {
    return high - low <= 1e-13 * std::max(std::abs(low), std::abs(high)) ? 0 : high - low;
  };
  const Vec3 size{extent(s.low.x, s.high.x), extent(s.low.y, s.high.y), extent(s.low.z, s.high.z)};
  const double largest = std::max({size.x, size.y, size.z});
  if (s.height_field && std::max(size.x, size.y) > 0) {
    s.scale = plane_scale(size);
    s.scale.z = height_scale(size, s.scale, tangents);
  } else if (largest > 0) {
    s.scale = {1.2 / largest, 1.2 / largest, 1.2 / largest};
  }
  if (size.x == 0) s.scale.x = 0;
  if (size.y == 0) s.scale.y = 0;
  if (size.z == 0) s.scale.z = 0;

  s.normal.resize(n);
  s.area.resize(n);
  parallel_chunks(static_cast<Index>(n), [&](Index, Index begin, Index end) {
    for (Index k = begin; k < end; ++k) {
      s.position[k] = s.to_scene(s.position[k]);
      const Tangents& t = tangents[k];
      const Vec3 a{t.u.x * s.scale.x, t.u.y * s.scale.y, t.u.z * s.scale.z};
      const Vec3 b{t.v.x * s.scale.x, t.v.y * s.scale.y, t.v.z * s.scale.z};
      s.area[k] = s.kept[k] ? length(cross(a, b)) : 0;
      // The tangents' directions, so that a corner where both are short still has its normal.
      const Vec3 sine = cross(unit_or(a, {}), unit_or(b, {}));
      s.normal[k] = length(sine) > 1e-12 ? unit_or(sine, {}) : Vec3{};
    }
  });
  return s;
}

}  // namespace knotfit::report
