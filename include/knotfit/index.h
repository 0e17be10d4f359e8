// Counts and offsets.
#pragma once
#include <cstddef>
namespace [[gnu::visibility("default")]] knotfit {
/// Counts, offsets and indices: signed, so that `i - degree` is safe.
using Index = std::ptrdiff_t;
}  // namespace knotfit
