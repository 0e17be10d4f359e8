// Where a cloud has an opening, and not only few points [METHOD 7.3].
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "data/vertex_stars.h"
#include "knotfit/exceptions.h"
#include "knotfit/mesh.h"
#include "knotfit/openings.h"
#include "parameterize/delaunay.h"
namespace knotfit::cloud {

/// An opening holds an empty circle whose radius is so many spacings, the mean along its rim, and is nearly as large as
/// that circle at least. The widest gap among points at random came to 2.7 (76 sheets of 300 to 60 000), where the density
/// grows 400 times across the sheet to 2.4, beside an edge where it falls by 64 to 2.4.
inline constexpr double kOpening = 4;

/// A cloud with openings that nobody asked to close.
class OpenSheet : public InvalidInput {
 public:
  using InvalidInput::InvalidInput;
};

/// The spacing about a vertex: the median radius of the circles through the corners of the triangles at most two rings away.
class Spacing {
 public:
  /// \param radius  of each triangle
  Spacing(std::span<const std::array<std::int32_t, 3>> triangle, std::vector<double> radius, Index vertices);
  double at(std::int32_t vertex) const;
  double radius(std::size_t triangle) const { return radius_[triangle]; }

 private:
  std::span<const std::array<std::int32_t, 3>> triangle_;
  std::vector<double> radius_;
  VertexStars stars_;
};

/// Radius of the circle through the corners of each triangle. \param at  vertices, `dimension` coordinates each (2 or 3)
std::vector<double> circle_radii(std::span<const std::array<std::int32_t, 3>> triangle,
                                 std::span<const double> at, int dimension);

/// Triangles of a Delaunay triangulation over openings of the data, or over bays of its outline: 1.
/// \param places   n x 2, lengths about as in space   \param spacing  of each place
std::vector<char> over_openings(const Triangulation& t, std::span<const double> places,
                                const Spacing& circles, const std::vector<double>& spacing);

/// Those of find_openings() that are openings by the same measure, taken in space; the others close gaps that points
/// at random leave.
/// \param loose  points that no triangle has, n x 3: a gap with points in it was left by the triangulation
std::vector<Opening> cloud_openings(const Mesh& mesh, std::span<const double> loose = {});

/// Those of the points, n x 3, whose entry is 0.
std::vector<double> loose_points(std::span<const double> points, const std::vector<char>& joined);

/// Share of the places' box farther than 2.5 spacings from every point that counts: even points leave none along their rim.
double bare_share(std::span<const double> places, const std::vector<double>& spacing,
                  const std::vector<char>& counts, const std::array<double, 2>& low,
                  const std::array<double, 2>& high);

}  // namespace knotfit::cloud
