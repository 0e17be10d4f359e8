// A feature measure of the user's own, from a file.
#pragma once
#include <string>

#include "knotfit/curve_points.h"
#include "knotfit/features.h"
#include "knotfit/points.h"
namespace knotfit::tool {

/// z of a raster, or of points x,y,z or u,v,z, over the domain of the data: averaged over the cells of a map, spread
/// to those without. Values outside the domain are left out.
/// \param map  of the data: its parameters are the file's x, y (or u, v)
/// \throws FileError  unreadable, no such points, one that is negative (names its line), none inside
FeatureMap read_feature_file(const std::string& path, const ParameterMap& map);

/// The same along a curve: two columns, t (of a function its x) and the measure. \throws FileError  as above
FeatureMap read_curve_feature_file(const std::string& path, const CurvePoints& curve);

}  // namespace knotfit::tool
