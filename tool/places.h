// Where a surface is to be evaluated, in the user's own coordinates.
#pragma once
#include <string>
#include <vector>

#include "knotfit/io.h"
#include "options.h"
namespace knotfit::tool {

struct Places {
  std::vector<double> a, b;   ///< u, v of the data that was fitted; x, y for a height field
  int given_dimension = 0;    ///< 0: places alone
  std::vector<double> given;  ///< n x given_dimension: values to compare with
  std::vector<Index> line;    ///< in the file, from 1; empty: none
  std::string source;         ///< "--at", or the file, for messages
  Index size() const { return static_cast<Index>(a.size()); }
};

/// The places of --at, --points or --grid; exactly one is given.
/// \throws FileError, InvalidInput  the file has no places for this surface
Places find_places(const Arguments& arguments, const SurfaceDocument& document);

/// first x second places over the domain, borders included, first coordinate slowest.
Places grid_places(const ParameterMap& map, IntegerPair counts);

/// Their parameters in [0,1]^2, n x 2.
/// \throws InvalidInput  a place outside the domain by more than rounding, and not clamp
std::vector<double> parameters_of(const Places& places, const ParameterMap& map, bool clamp);

}  // namespace knotfit::tool
