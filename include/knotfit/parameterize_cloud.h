// A cloud of points over the unit square, as a mesh: its points as vertices, with triangles between them that a
// correction of the parameters holds the surface by.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "knotfit/control.h"
#include "knotfit/mesh.h"
#include "knotfit/openings.h"
#include "knotfit/parameterize_mesh.h"
namespace [[gnu::visibility("default")]] knotfit {

/// What the points are projected to.
enum class CloudBase {
  /// The plane where the cloud does not fold over it, else the graph. Where the places on the plane leave much of
  /// the square without data, the outline is laid along its sides (map_outline).
  automatic,
  plane,     ///< by principal axes, turned to the smallest rectangle around the points
  cylinder,  ///< fitted to the points, unrolled, cut where there are the fewest
  graph,     ///< no base: nearest neighbours joined to a mesh, mapped like one
  surface,   ///< a given one: base_surface.h
  given      ///< parameters that came with the points
};

struct CloudOptions {
  CloudBase base = CloudBase::automatic;
  int neighbours = 16;          ///< of a point, for normals and for the graph; 6 to 64
  MeshMapOptions map = {};      ///< of the graph's mesh
  double most_folded = 0.01;    ///< share of the points, above which `automatic` leaves the plane
  double least_covered = 0.97;  ///< share of the square, below which it maps the outline
  bool fill_holes = false;      ///< else require_no_openings()
  /// Of the points, n x 3, of any length; 0, 0, 0: unknown; empty: none. They take the place of estimated ones, and the
  /// surface's normal (S_u x S_v) points to the side that most of them do.
  std::vector<double> normals = {};
};

struct CloudMap {
  CloudBase base = CloudBase::given;
  /// Its vertices are points in their order; vertex_line is the number of each, from 1. Triangles over gaps in
  /// the data are virtual.
  Mesh mesh;
  MeshMap map;           ///< uv of every vertex; corners are those nearest to the square's
  Index points = 0;      ///< of the cloud
  Index sample = 0;      ///< points of the sample that was mapped (map_sample()); 0: all were
  Index coincident = 0;  ///< points left out: another has the same parameters
  Index lone = 0;        ///< points left out: no triangle of the data has them (outliers, scraps)
  /// Of `plane` and `automatic`: share of the points whose neighbourhood turns away from the plane.
  double folded = 0;
  std::vector<Index> stray_rows;  ///< of map_rows(): left out, far from both neighbours; from 0
  double covered = 0;   ///< share of the square under triangles of the data: elsewhere the surface is free
  double outlined = 0;  ///< the same, gaps within the outline included
  /// Share of the square where no point is within 2.5 spacings of those about it (spacing: the median circle through the
  /// corners of a triangle). A ragged rim leaves none, a round outline in its rectangle does.
  double bare = 0;
  /// Gaps within the outline that hold an empty circle of 4 spacings or more: windows, the second rim of a tube.
  std::vector<Opening> openings;
  bool mapped = false;                     ///< the outline was laid along the square by map_outline()
  std::array<double, 3> centre{}, axis{};  ///< of the plane (its normal) or the cylinder
  double radius = 0;                       ///< of the cylinder
  Index normals = 0;                       ///< points whose normals were given
  double scatter = 0;                      ///< RMS distance of the points from the plane or cylinder
};

/// \param points  n x 3, row-major
/// \throws InvalidInput  fewer than 4 points, one not finite, all on one line; normals of another number or not finite;
///   a cloud that the base cannot carry, or with openings: the message says why and what to do
CloudMap parameterize_cloud(std::span<const double> points, const CloudOptions& options = {},
                            const Control& control = {});

/// For clouds whose openings are not to be closed unasked. \throws InvalidInput  there are some, or more than 5 % of the
/// square is bare: where they are, and what else there is than to fill them
void require_no_openings(const CloudMap& cloud);

/// Points whose parameters are known, joined by the Delaunay triangulation of the parameters, lengths as in space.
/// Parameters move by less than 2^-29.
/// \param uv  n x 2 in [0,1]
/// \throws InvalidInput  lengths that do not fit, parameters outside [0,1], all on one line
CloudMap triangulate_parameters(std::span<const double> points, std::span<const double> uv);

/// Points in rows (parameterize_rows), each row joined to the next by triangles whose edges across are shortest in all
/// [Fuchs77]: however far chord length has shifted neighbouring rows against each other, places that are near in space are
/// joined. A row that is 8 times as far from both its neighbours as rows are, while those are near each other, is left out.
/// Up to 100 000 points are mapped by map_outline(), where that can be. Where v does not rise from row to row:
/// triangulate_parameters().
/// \param uv  n x 2 in [0,1]; v of a row's points is equal, u rises along it
/// \throws InvalidInput  as triangulate_parameters()
CloudMap map_rows(std::span<const double> points, std::span<const double> uv,
                  const MeshMapOptions& options = {}, const Control& control = {});

/// Keeps the largest part of the triangles, closes its holes by virtual ones, and maps it by parameterize_mesh(): the
/// outline comes to lie along the sides of the square, and no part of it is without data.
/// \throws InvalidInput  the triangles are no disk: why
void map_outline(CloudMap& cloud, const MeshMapOptions& options = {}, const Control& control = {});

/// What a report says: the base, and the points that were left out.
std::string describe(const CloudMap& cloud);

}  // namespace knotfit
