// Surfaces and meshes for mesh viewers: OBJ, PLY and VTK files.
#pragma once
#include <iosfwd>
#include <span>
#include <vector>

#include "knotfit/mesh.h"
#include "knotfit/points.h"
#include "knotfit/surface.h"
namespace [[gnu::visibility("default")]] knotfit {

/// A surface as a grid of points, first index along u: entry (i, j) at i * v.size() + j.
struct Tessellation {
  std::vector<double> u, v;                ///< grid lines in the surface's domain, increasing
  std::vector<double> points, normals;     ///< n x 3; a normal is zero where the surface has none
  std::vector<double> mean_curvature;      ///< n, sign by the normal
  std::vector<double> gaussian_curvature;  ///< n
  std::vector<double> error;               ///< n, NaN where no data is near; empty: not measured
  ParameterMap map;                        ///< of the parameters that are written
  Index size() const { return static_cast<Index>(points.size()) / 3; }
};

/// Every knot line and `samples_per_span` - 1 lines between two.
/// \param surface  in R^3; a height field by height_field_in_space
/// \throws InvalidInput  not in R^3, no sample a span, more than 1e8 points
Tessellation tessellate(const Surface& surface, int samples_per_span = 4);

/// The largest error of the points to which a place of the grid is the nearest in each parameter.
/// \param errors  a point each, as FitResult::errors
/// \throws InvalidInput  their number is not that of the points
void add_errors(Tessellation& tessellation, const ParameterizedPoints& points,
                std::span<const double> errors);

/// Triangles with vt and vn.
void write_obj(std::ostream& out, const Tessellation& tessellation);
/// Binary, triangles; properties x y z nx ny nz s t, error where measured, mean_curvature, gaussian_curvature.
void write_ply(std::ostream& out, const Tessellation& tessellation);
/// VTK XML structured grid (ParaView); point data error, normal, mean_curvature, gaussian_curvature, uv.
void write_vts(std::ostream& out, const Tessellation& tessellation);

/// The mesh without its virtual faces, with vt where it has parameters.
/// \throws InvalidInput  the parameters do not fit the vertices
void write_obj(std::ostream& out, const Mesh& mesh);
/// Binary; properties x y z, s t where it has parameters.
void write_ply(std::ostream& out, const Mesh& mesh);

}  // namespace knotfit
