// Threads whose number never shows in a result: chunks are fixed by the data, every chunk's
// partial result is stored under its number and added in that order.
#pragma once
#include <algorithm>
#include <functional>
#include <vector>

#include "knotfit/index.h"
namespace knotfit {

inline constexpr Index kChunk = 4096;  ///< points a chunk

inline Index chunk_count(Index n, Index chunk = kChunk) {
  return (n + chunk - 1) / chunk;
}

/// Calls body(i) for i = 0..n-1 on the available threads, in any order. An exception of the body
/// reaches the caller.
void parallel_for(Index n, const std::function<void(Index)>& body);

/// Calls body(chunk, begin, end) for every chunk of 0..n-1.
template <class Body>
void parallel_chunks(Index n, const Body& body, Index chunk = kChunk) {
  parallel_for(chunk_count(n, chunk), [&](Index c) { body(c, c * chunk, std::min(n, (c + 1) * chunk)); });
}

/// Sum of terms(begin, end) over the chunks of 0..n-1, added pairwise as a tree in fixed order.
/// T needs +=.
template <class T, class Terms>
T parallel_sum(Index n, const Terms& terms, Index chunk = kChunk) {
  std::vector<T> partial(static_cast<std::size_t>(std::max<Index>(1, chunk_count(n, chunk))), T{});
  parallel_chunks(
      n, [&](Index c, Index begin, Index end) { partial[c] = terms(begin, end); }, chunk);
  for (std::size_t step = 1; step < partial.size(); step *= 2)
    for (std::size_t i = 0; i + step < partial.size(); i += 2 * step) partial[i] += partial[i + step];
  return partial[0];
}

}  // namespace knotfit
