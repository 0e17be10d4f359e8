#include "base/counting_sort.h"

#include <algorithm>

#include "base/parallel.h"
namespace knotfit {

std::vector<Index> counting_sort(std::span<const std::int32_t> key, Index keys,
                                 std::vector<std::int32_t>& order) {
  constexpr Index kBlocks = 16;  // histograms: fixed, whatever the threads
  const Index n = static_cast<Index>(key.size());
  const Index blocks = std::clamp<Index>(n / kChunk, 1, kBlocks),
              block = std::max<Index>(1, (n + blocks - 1) / blocks);
  std::vector<Index> start(keys + 1, 0);
  std::vector<std::vector<std::int32_t>> count(blocks);
  parallel_chunks(
      n,
      [&](Index b, Index begin, Index end) {
        count[b].assign(keys, 0);
        for (Index k = begin; k < end; ++k) ++count[b][key[k]];
      },
      block);
  Index sum = 0;
  for (Index c = 0; c < keys; ++c) {
    start[c] = sum;
    for (auto& h : count) {
      if (h.empty()) continue;
      const std::int32_t here = h[c];
      h[c] = static_cast<std::int32_t>(sum);
      sum += here;
    }
  }
  start[keys] = sum;
  order.resize(n);
  parallel_chunks(
      n,
      [&](Index b, Index begin, Index end) {
        for (Index k = begin; k < end; ++k) order[count[b][key[k]]++] = static_cast<std::int32_t>(k);
      },
      block);
  return start;
}

}  // namespace knotfit
