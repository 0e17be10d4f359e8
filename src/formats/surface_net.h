// The control points of a surface in JSON, in any of the ways that programs write them.
#pragma once
#include <string_view>
#include <vector>

#include "formats/json_reader.h"
#include "knotfit/index.h"
namespace knotfit {

struct ControlNet {
  int dimension = 0;
  std::vector<double> points;  ///< size_u x size_v x dimension
};

/// Nested [size_u][size_v][dimension]; a list of points, or a flat list, u slowest; [size_u][size_v] numbers.
/// With v_major lists have v slowest, and a nested net [size_v][size_u][dimension] is exchanged.
/// \param reader  on `value`, the member's text; its errors name the member
/// \throws FileError  the numbers do not fill the net
ControlNet read_control_net(JsonReader reader, std::string_view value, Index size_u, Index size_v,
                            bool v_major);

}  // namespace knotfit
