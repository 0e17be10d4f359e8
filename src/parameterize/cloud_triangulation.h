// Points with places in a plane as a mesh over the unit square.
#pragma once
#include <array>
#include <span>
#include <vector>

#include "knotfit/parameterize_cloud.h"
namespace knotfit::cloud {

/// Joins the points by the Delaunay triangulation of their places, moved to a grid of 2^-29 of the longer side.
/// Triangles over gaps, many times longer than the points at their corners are apart, are virtual where they are
/// enclosed by others, else dropped; so are flat ones at the hull.
/// \param points  n x 3
/// \param places  n x 2, coordinates with lengths about as in space; their box becomes the square
/// \throws InvalidInput  all places on one line
CloudMap triangulate(std::span<const double> points, std::span<const double> places);

/// The same where the square is given as 0 to sides[0] and 0 to sides[1] of the places; every point keeps a triangle
/// of the data.
CloudMap triangulate(std::span<const double> points, std::span<const double> places,
                     const std::array<double, 2>& sides);

/// How much longer in space 1 of v is than 1 of u, a mean over neighbours: {1, ratio}.
std::array<double, 2> lengths_of(std::span<const double> points, std::span<const double> uv);

}  // namespace knotfit::cloud
