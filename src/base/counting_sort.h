// Items in the order of whole-numbered keys: points of cells, triangles of vertices.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "knotfit/index.h"
namespace knotfit {

/// Stable; the same for any number of threads.
/// \param key    n, each in [0, keys)
/// \param order  written: the n items, key after key
/// \return keys + 1: where each key's items begin in the order, and n
std::vector<Index> counting_sort(std::span<const std::int32_t> key, Index keys,
                                 std::vector<std::int32_t>& order);

}  // namespace knotfit
