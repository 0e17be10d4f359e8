#include "knotfit/grid_support.h"

#include <algorithm>
#include <cmath>

#include "parameterize/cloud_gaps.h"
#include "parameterize/cloud_triangulation.h"
namespace knotfit {
namespace {

constexpr double kReach = 2.5;  // spacings from a point
enum Mark : char { kNear = 1, kOpen = 2 };

/// Nodes of the raster in its own steps: column and row of a place.
struct Steps {
  const Raster& grid;
  double column(double x) const { return (x - grid.x(0)) / grid.dx; }
  double row(double y) const { return (grid.y(0) - y) / grid.dy; }
};

Index within(double at, Index count) {
  return static_cast<Index>(std::clamp(at, 0.0, static_cast<double>(count - 1)));
}

/// Marks every node for which `is` holds, of the columns and rows between these.
template <class Is>
void mark(std::vector<char>& marks, const Raster& grid, const double (&column)[2], const double (&row)[2],
          Mark with, const Is& is) {
  if (column[1] < 0 || row[1] < 0 || column[0] > static_cast<double>(grid.columns - 1) ||
      row[0] > static_cast<double>(grid.rows - 1))
    return;
  for (Index r = within(std::ceil(row[0]), grid.rows); r <= within(std::floor(row[1]), grid.rows); ++r)
    for (Index c = within(std::ceil(column[0]), grid.columns);
         c <= within(std::floor(column[1]), grid.columns); ++c)
      if (is(grid.x(c), grid.y(r))) marks[r * grid.columns + c] |= with;
}

}  // namespace

std::vector<char> grid_support(const ParameterizedPoints& points, const Raster& grid) {
  std::vector<double> flat, places;
  for (Index k = 0; k < points.size(); ++k) {
    const auto [x, y] = points.map.from_uv(points.u(k), points.v(k));
    flat.insert(flat.end(), {x, y, 0});
    places.insert(places.end(), {x, y});
  }
  const CloudMap cloud = cloud::triangulate(flat, places);
  const Mesh& mesh = cloud.mesh;
  std::vector<std::array<std::int32_t, 3>> data;
  for (Index f = 0; f < mesh.face_count(); ++f)
    if (mesh.virtual_face[f] == 0) data.push_back(mesh.faces[f]);
  const cloud::Spacing spacing(data, cloud::circle_radii(data, places, 2), points.size());

  std::vector<char> marks(static_cast<std::size_t>(grid.rows * grid.columns), 0);
  const Steps steps{grid};
  for (Index k = 0; k < points.size(); ++k) {
    const double radius = kReach * spacing.at(static_cast<std::int32_t>(k));
    if (!std::isfinite(radius)) continue;
    const double x = places[2 * k], y = places[2 * k + 1];
    mark(marks, grid, {steps.column(x - radius), steps.column(x + radius)},
         {steps.row(y + radius), steps.row(y - radius)}, kNear,
         [&](double a, double b) { return std::hypot(a - x, b - y) <= radius; });
  }
  for (const Opening& o : cloud.openings)
    for (const std::int32_t f : o.faces) {
      double x[3], y[3];
      for (int k = 0; k < 3; ++k)
        x[k] = places[2 * mesh.faces[f][k]], y[k] = places[2 * mesh.faces[f][k] + 1];
      const auto [left, right] = std::minmax({x[0], x[1], x[2]});
      const auto [low, high] = std::minmax({y[0], y[1], y[2]});
      mark(marks, grid, {steps.column(left), steps.column(right)}, {steps.row(high), steps.row(low)}, kOpen,
           [&](double a, double b) {
             for (int k = 0; k < 3; ++k) {
               const int l = (k + 1) % 3;
               if ((x[l] - x[k]) * (b - y[k]) - (y[l] - y[k]) * (a - x[k]) < 0) return false;
             }
             return true;
           });
    }
  for (char& m : marks) m = m == kNear;
  return marks;
}

}  // namespace knotfit
