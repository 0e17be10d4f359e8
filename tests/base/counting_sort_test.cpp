#include "base/counting_sort.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "support/two_threads.h"
namespace knotfit::test {
namespace {

/// Keys that look random, some of them never used.
std::vector<std::int32_t> keys_of(Index n, Index keys) {
  std::vector<std::int32_t> key;
  for (Index k = 0; k < n; ++k) key.push_back(static_cast<std::int32_t>(k * 7919 % 104729 % keys / 2 * 2));
  return key;
}

TEST(CountingSort, OrdersAsAStableSortDoes) {
  for (const Index n : {0, 1, 5, 4096, 4097, 100000})
    for (const Index keys : {2, 64, 5000}) {
      const std::vector<std::int32_t> key = keys_of(n, keys);
      std::vector<std::int32_t> expected(static_cast<std::size_t>(n)), order{7, 7, 7};
      std::iota(expected.begin(), expected.end(), 0);
      std::stable_sort(expected.begin(), expected.end(),
                       [&](std::int32_t a, std::int32_t b) { return key[a] < key[b]; });
      const std::vector<Index> start = counting_sort(key, keys, order);
      EXPECT_EQ(order, expected) << n << " items, " << keys << " keys";
      ASSERT_EQ(static_cast<Index>(start.size()), keys + 1);
      for (Index c = 0; c < keys; ++c)
        EXPECT_EQ(start[c + 1] - start[c], std::count(key.begin(), key.end(), static_cast<std::int32_t>(c)));
      EXPECT_EQ(start.front(), 0);
    }
}

TEST(CountingSort, IsTheSameForOneAndTwoThreads) {
  const std::vector<std::int32_t> key = keys_of(200000, 300);
  const auto [one, two] = on_one_and_two_threads([&] {
    std::vector<std::int32_t> order;
    counting_sort(key, 300, order);
    return order;
  });
  EXPECT_EQ(one, two);
}

}  // namespace
}  // namespace knotfit::test
