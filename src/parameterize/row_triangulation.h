// Rows of points joined to a mesh [METHOD 7.4].
#pragma once
#include <span>

#include "knotfit/parameterize_cloud.h"
namespace knotfit::cloud {

/// See map_rows(). \return at the parameters given; without faces where v does not rise from row to row
CloudMap triangulate_rows(std::span<const double> points, std::span<const double> uv);

}  // namespace knotfit::cloud
