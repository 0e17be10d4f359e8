#include "knotfit/parameterize_cloud.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/place_text.h"
#include "knotfit/exceptions.h"
#include "knotfit/remedy.h"
#include "parameterize/cloud_base.h"
#include "parameterize/cloud_gaps.h"
#include "parameterize/cloud_graph.h"
#include "parameterize/cloud_neighbours.h"
#include "parameterize/cloud_triangulation.h"
#include "parameterize/row_triangulation.h"
#include "parameterize/table_checks.h"
namespace knotfit {
namespace {

using cloud::BasePlaces;
using cloud::NeighbourLists;
using cloud::Vector;

constexpr double kMostBare = 0.05;  // of the square, without a point near
constexpr double kTube = 0.1;       // of the radius, RMS: points of a tube are at most so far from a cylinder
constexpr double kTurn = 5.2;       // radians of it that they take, at least
constexpr Index kMostMapped = 100000;  // points whose outline is mapped unasked: a minute of work

Index count_of(std::span<const double> points) {
  if (points.size() % 3 != 0)
    throw InvalidInput(fmt::format("{} coordinates are no points in space", points.size()));
  const auto n = static_cast<Index>(points.size()) / 3;
  if (n < 4) throw InvalidInput(fmt::format("{} points: a surface needs at least 4", n));
  for (std::size_t k = 0; k < points.size(); ++k)
    if (!(std::abs(points[k]) < 1e150))
      throw InvalidInput(
          fmt::format("point {} (from 1): coordinate {} is not finite or beyond what distances can hold",
                      k / 3 + 1, points[k]));
  return n;
}

CloudMap over(CloudBase base, const BasePlaces& places, std::span<const double> points) {
  CloudMap map = cloud::triangulate(points, places.at);
  map.base = base;
  map.centre = places.centre;
  map.axis = places.axis;
  map.radius = places.radius;
  map.scatter = places.scatter;
  return map;
}

/// Share of the normals that point away from the side most of them point to, within 3 degrees of the plane too.
double folded_share(const std::vector<Vector>& normals, const Vector& axis) {
  constexpr double grazing = 0.05;
  Index up = 0, down = 0;
  for (const Vector& n : normals) {
    const double cosine = n[0] * axis[0] + n[1] * axis[1] + n[2] * axis[2];
    up += cosine > grazing, down += cosine < -grazing;
  }
  return 1 - static_cast<double>(std::max(up, down)) / static_cast<double>(normals.size());
}

/// Mapped where it can be: several pieces, or none that is a disk, stay as they are.
CloudMap outlined(CloudMap cloud, const MeshMapOptions& options, const Control& control) {
  if (cloud.points > kMostMapped) return cloud;
  CloudMap mapped = cloud;
  try {
    map_outline(mapped, options, control);
  } catch (const InvalidInput&) {
    return cloud;
  }
  return mapped;
}

/// What else there is for a cloud with openings.
std::string other_ways(const CloudMap& cloud) {
  if (cloud.base == CloudBase::plane && std::abs(cloud.axis[2]) > 0.9)
    return "; " + remedy_text(Remedy::height_field) + " fits z over x, y and leaves them as they are";
  if (cloud.base != CloudBase::graph) return "";
  std::vector<double> points;
  for (Index k = 0; k < cloud.mesh.vertex_count(); ++k)
    if (cloud.mesh.vertex_source.empty() || cloud.mesh.vertex_source[k] >= 0)
      points.insert(points.end(), cloud.mesh.vertex(k), cloud.mesh.vertex(k) + 3);
  const auto n = static_cast<Index>(points.size()) / 3;
  const NeighbourLists near =
      cloud::neighbours_across_lines(points, static_cast<int>(std::min<Index>(16, n - 1)));
  try {
    const BasePlaces round = cloud::project_to_cylinder(points, cloud::agreeing_normals(points, near));
    double low = INFINITY, high = -INFINITY;
    for (std::size_t k = 0; k < round.at.size(); k += 2)
      low = std::min(low, round.at[k]), high = std::max(high, round.at[k]);
    if (round.scatter < kTube * round.radius && high - low > kTurn * round.radius)
      return fmt::format(
          "; {} unrolls them around the axis that they surround, of radius {:.4g} about ({:.3g}, {:.3g}, "
          "{:.3g})",
          remedy_text(Remedy::base, "cylinder"), round.radius, round.axis[0], round.axis[1], round.axis[2]);
  } catch (const InvalidInput&) {
    // No cylinder.
  }
  return "";
}

Index count_normals(std::span<const double> normals) {
  Index count = 0;
  for (std::size_t k = 0; k + 2 < normals.size(); k += 3)
    count += normals[k] != 0 || normals[k + 1] != 0 || normals[k + 2] != 0;
  return count;
}

void check_normals(std::span<const double> normals, Index n) {
  if (!normals.empty() && static_cast<Index>(normals.size()) != 3 * n)
    throw InvalidInput(
        fmt::format("{} numbers of normals for {} points: three each, or none", normals.size(), n));
  for (std::size_t k = 0; k < normals.size(); ++k)
    if (!(std::abs(normals[k]) < 1e150))
      throw InvalidInput(
          fmt::format("normal {} (from 1): coordinate {} is not finite", k / 3 + 1, normals[k]));
}

void check_parameters(std::span<const double> points, std::span<const double> uv) {
  const Index n = count_of(points);
  if (static_cast<Index>(uv.size()) != 2 * n)
    throw InvalidInput(
        fmt::format("{} points need {} parameters, u and v each; there are {}", n, 2 * n, uv.size()));
  for (std::size_t k = 0; k < uv.size(); ++k)
    if (!(uv[k] >= 0 && uv[k] <= 1))
      throw InvalidInput(fmt::format("{} of point {} (from 1) is {}: parameters lie in [0,1]",
                                     k % 2 == 0 ? "u" : "v", k / 2 + 1, uv[k]));
}

}  // namespace

CloudMap parameterize_cloud(std::span<const double> points, const CloudOptions& options,
                            const Control& control) {
  const Index n = count_of(points);
  if (options.neighbours < 6 || options.neighbours > 64)
    throw InvalidInput(fmt::format("{} neighbours of a point; there are 6 to 64", options.neighbours));
  check_normals(options.normals, n);
  parameterize::check_strays(points, 3, {});
  const CloudBase base = options.base;
  if (base == CloudBase::given || base == CloudBase::surface)
    throw InvalidInput("a base surface is given to another function, and so are parameters");
  BasePlaces plane;
  if (base == CloudBase::plane || base == CloudBase::automatic) {
    plane = cloud::project_to_plane(points);
    cloud::turn_to_normals(plane, points, options.normals);
  }
  const int count = static_cast<int>(std::min<Index>(options.neighbours, n - 1));
  const NeighbourLists near = cloud::neighbours_across_lines(points, count);
  const std::vector<Vector> normals = cloud::agreeing_normals(points, near, options.normals);
  const auto counted = [&](CloudMap map) {
    map.normals = count_normals(options.normals);
    return map;
  };
  if (base == CloudBase::cylinder) {
    BasePlaces places = cloud::project_to_cylinder(points, normals);
    cloud::turn_to_normals(places, points, options.normals);
    CloudMap map = over(CloudBase::cylinder, places, points);
    if (!options.fill_holes) require_no_openings(map);
    return counted(std::move(map));
  }
  const double folded = base == CloudBase::graph ? 0 : folded_share(normals, plane.axis);
  if (base == CloudBase::plane || (base == CloudBase::automatic && folded <= options.most_folded)) {
    CloudMap map = over(CloudBase::plane, plane, points);
    map.folded = folded;
    if (!options.fill_holes && !map.openings.empty()) require_no_openings(map);
    if (base == CloudBase::automatic && map.outlined < options.least_covered)
      map = outlined(std::move(map), options.map, control);
    if (!options.fill_holes) require_no_openings(map);
    return counted(std::move(map));
  }
  try {
    CloudMap map = cloud::map_graph(points, near, normals, options, control);
    map.folded = folded;
    return counted(std::move(map));
  } catch (const cloud::OpenSheet&) {
    throw;
  } catch (const InvalidInput& e) {
    if (base == CloudBase::graph) throw;
    throw InvalidInput(
        fmt::format("the points fold over their plane ({:.3g} % of them stand upright or turn back), and {}; "
                    "{} fits z over x, y, {} fits them over their plane all the same, {} around an axis",
                    100 * folded, e.what(), remedy_text(Remedy::height_field),
                    remedy_text(Remedy::base, "plane"), remedy_text(Remedy::base, "cylinder")));
  }
}

void require_no_openings(const CloudMap& cloud) {
  if (!cloud.openings.empty()) {
    const bool one = cloud.openings.size() == 1;
    throw cloud::OpenSheet(fmt::format(
        "the points leave {}; {} closes {} by triangles that are no data: the surface "
        "is free there{}",
        describe(cloud.openings), remedy_text(Remedy::fill_holes), one ? "it" : "them", other_ways(cloud)));
  }
  if (cloud.bare > kMostBare)
    throw cloud::OpenSheet(
        fmt::format("{:.2g} % of the square would be without data; {} leaves the surface free there, {} "
                    "lays the outline of the points along the sides of the square",
                    100 * cloud.bare, remedy_text(Remedy::fill_holes), remedy_text(Remedy::base, "graph")));
}

void map_outline(CloudMap& cloud, const MeshMapOptions& options, const Control& control) {
  RepairedMesh repaired = repair(cloud.mesh, {.largest_part = true, .fill_holes = true});
  std::vector<Index> line;
  Index points = 0;
  for (const Index from : repaired.kept) {
    line.push_back(from < 0 ? 0 : cloud.mesh.vertex_line.empty() ? from + 1 : cloud.mesh.vertex_line[from]);
    points += from >= 0;
  }
  require_disk(repaired.mesh);
  repaired.mesh.vertex_line = std::move(line);
  MeshMap map = parameterize_mesh(repaired.mesh, options, control);
  std::vector<char> kept(static_cast<std::size_t>(cloud.mesh.vertex_count()), 0);
  for (const Index k : repaired.kept)
    if (k >= 0) kept[k] = 1;
  const std::vector<double> loose = cloud::loose_points(cloud.mesh.vertices, kept);
  cloud.mesh = std::move(repaired.mesh);
  cloud.map = std::move(map);
  cloud.lone = cloud.points - cloud.coincident - points;
  cloud.openings = cloud::cloud_openings(cloud.mesh, loose);
  measure_openings(cloud.openings, cloud.mesh, cloud.map.uv);
  cloud.covered = covered_share(cloud.mesh, cloud.map.uv, cloud.openings);
  cloud.outlined = 1;
  cloud.bare = 0;
  for (const Opening& o : cloud.openings) cloud.bare += o.share_of_square;
  cloud.mapped = true;
}

CloudMap triangulate_parameters(std::span<const double> points, std::span<const double> uv) {
  check_parameters(points, uv);
  const std::array<double, 2> sides = cloud::lengths_of(points, uv);
  std::vector<double> places(uv.begin(), uv.end());
  for (std::size_t k = 0; k < places.size(); ++k) places[k] *= sides[k % 2];
  return cloud::triangulate(points, places, sides);
}

CloudMap map_rows(std::span<const double> points, std::span<const double> uv, const MeshMapOptions& options,
                  const Control& control) {
  check_parameters(points, uv);
  CloudMap rows = cloud::triangulate_rows(points, uv);
  return rows.mesh.faces.empty() ? triangulate_parameters(points, uv)
                                 : outlined(std::move(rows), options, control);
}

std::string describe(const CloudMap& c) {
  std::string text;
  switch (c.base) {
    case CloudBase::plane:
      text = fmt::format("plane with the normal ({:.4g}, {:.4g}, {:.4g}), points {:.4g} RMS off it",
                         c.axis[0], c.axis[1], c.axis[2], c.scatter);
      break;
    case CloudBase::cylinder:
      text = fmt::format(
          "cylinder of radius {:.6g} around ({:.4g}, {:.4g}, {:.4g}) through ({}, {}, {}), "
          "points {:.4g} "
          "RMS off it",
          c.radius, c.axis[0], c.axis[1], c.axis[2], place_text(c.centre[0]), place_text(c.centre[1]),
          place_text(c.centre[2]), c.scatter);
      break;
    case CloudBase::surface:
      text = fmt::format("surface given, points {:.4g} RMS off it", c.scatter);
      break;
    case CloudBase::graph:
      text = "mesh of nearest neighbours";
      break;
    default:
      text = "parameters as given";
  }
  if (c.folded > 0)
    text += fmt::format("; {:.2g} % of the points stand upright on the plane or turn back over it",
                        100 * c.folded);
  if (c.mapped && c.base != CloudBase::graph) text += "; the outline laid along the square";
  if (c.sample > 0) text += fmt::format("; of {} points a sample of {} is mapped", c.points, c.sample);
  if (c.normals > 0)
    text += fmt::format("; {} of the points have normals, which say where outside is", c.normals);
  if (c.covered < 0.99)
    text += fmt::format("; {:.2g} % of the square holds no data, and the surface is free there",
                        100 * (1 - c.covered));
  if (!c.openings.empty())
    text += fmt::format("; {} opening{} closed by triangles that are no data", c.openings.size(),
                        c.openings.size() == 1 ? "" : "s");
  if (c.coincident > 0)
    text += fmt::format("; {} points left out, at the parameters of others", c.coincident);
  for (const Index r : c.stray_rows)
    text += fmt::format("; row {} left out, far from both rows beside it", r + 1);
  if (c.lone > 0) text += fmt::format("; {} points left out, apart from the others", c.lone);
  return text;
}

}  // namespace knotfit
