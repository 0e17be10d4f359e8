// A mesh as a piecewise linear function X(u,v) of its parameters, sampled on a grid.
#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "nearest/cell_polynomials.h"
namespace knotfit {

/// A mesh over its parameters, in any unit.
struct MapView {
  std::span<const Vec3> vertices;
  std::span<const std::array<std::int32_t, 3>> faces;
  std::span<const char> virtual_face;  ///< empty: none
  std::span<const double> uv;
  bool is_data(std::int32_t face) const { return virtual_face.empty() || !virtual_face[face]; }
  Vec3 normal(std::int32_t face) const;  ///< unit; zero for a face without area
};

/// The centres of `per_span` equal parts of every span.
std::vector<double> centred_places(const SpanTable& t, int per_span);

struct MapSamples {
  std::vector<double> u, v;        ///< the grid's lines
  std::vector<std::int32_t> face;  ///< u.size() x v.size(): the triangle there, -1: none
  Index index(Index i, Index j) const { return i * static_cast<Index>(v.size()) + j; }
};
/// Finds the triangle over each place, the first where several are. The same for any number of threads.
MapSamples sample_map(const MapView& map, std::vector<double> u, std::vector<double> v);

/// Derivatives of X on a triangle, and its unit normal.
struct TriangleFrame {
  Vec3 xu, xv, normal;
};
TriangleFrame triangle_frame(const MapView& map, std::int32_t face);

/// Means of the samples with use != 0 over windows that reach `reach` samples to all four sides, clipped to the grid. Zero
/// where there is none. \param rows  n_u x n_v, `width` numbers each
std::vector<double> window_means(std::span<const double> rows, int width, std::span<const char> use,
                                 Index n_u, Index n_v, Index reach);

}  // namespace knotfit
