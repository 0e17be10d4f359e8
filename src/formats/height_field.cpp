// Height fields over the user's own coordinates.
#include "knotfit/io.h"
namespace knotfit {

Surface height_field_in_space(const Surface& height, const ParameterMap& map) {
  if (!map.sheared()) return height_field_in_space(height, map.u0, map.u1, map.v0, map.v1);
  return height_field_in_space(height, map.from_uv(0, 0), map.from_uv(1, 0), map.from_uv(0, 1));
}

}  // namespace knotfit
