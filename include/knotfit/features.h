// Feature measures: how much geometry there is to follow, f >= 0 over [0,1]^2.
#pragma once
#include <string>
#include <vector>

#include "knotfit/points.h"
#include "knotfit/surface.h"
namespace [[gnu::visibility("default")]] knotfit {

/// f on a grid of size_u x size_v equal cells over [0,1]^2: f[i*size_v + j] >= 0 is its value on
/// cell (i, j), taken at the centre.
struct FeatureMap {
  Index size_u = 0, size_v = 0;
  std::vector<double> f;
  bool empty() const { return f.empty(); }
};

/// \throws InvalidInput  shape, or an entry negative or not finite (names the cell)
void validate(const FeatureMap& map);

/// Those of a uniform pre-fit; residual: of a uniform fit at the counts wanted.
enum class FeatureMeasure { hessian, curvature, derivative, residual };

/// (|S_uu|^2 + 2|S_uv|^2 + |S_vv|^2)^(1/4) at the cell centres [METHOD 2.2].
FeatureMap hessian_features(const Surface& s, Index size = 200);
/// (k1^2 + k2^2)^(1/4) |S_u x S_v|, height fields as (u, v, z) [METHOD 2.2].
FeatureMap curvature_features(const Surface& s, Index size = 200);
/// (|d_u^a S|^2 + |d_v^b S|^2)^(1/(a+b)), a and b the degrees of S, which should be one above those of the fit to
/// come: the derivatives its error follows, by the power that makes equal shares of them best [deBoor01 XII].
FeatureMap derivative_features(const Surface& s, Index size = 200);
/// |S - P|^2 of the points of a cell, averaged; cells without points take the nearest value.
FeatureMap residual_features(const ParameterizedPoints& points, const std::vector<double>& errors,
                             Index size = 200);
/// A value a point given by the user, averaged over each cell, spread likewise.
FeatureMap point_features(const ParameterizedPoints& points, const std::vector<double>& f, Index size = 200);

}  // namespace knotfit
