#include "base/parallel.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <array>
#include <atomic>
#include <cmath>
#include <stdexcept>

#include "knotfit/threads.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {
namespace {

class Parallel : public testing::Test {
 protected:
  void TearDown() override { set_thread_count(0); }
};

TEST_F(Parallel, VisitsEveryIndexOnce) {
  for (int threads : {1, 2, 4}) {
    set_thread_count(threads);
    for (Index n : {0, 1, 2, 3, 1000}) {
      std::vector<std::atomic<int>> visits(static_cast<std::size_t>(n));
      parallel_for(n, [&](Index i) { ++visits[i]; });
      for (const auto& count : visits) EXPECT_EQ(count, 1);
    }
  }
}

TEST_F(Parallel, ChunksCoverTheRangeInOrderOfTheirNumbers) {
  for (Index n : {Index{0}, Index{1}, kChunk - 1, kChunk, kChunk + 1, 5 * kChunk + 7}) {
    std::vector<std::array<Index, 2>> ranges(static_cast<std::size_t>(chunk_count(n)), {-1, -1});
    parallel_chunks(n, [&](Index c, Index begin, Index end) { ranges[c] = {begin, end}; });
    Index at = 0;
    for (const auto& [begin, end] : ranges) {
      EXPECT_EQ(begin, at);
      EXPECT_GT(end, begin);
      EXPECT_LE(end - begin, kChunk);
      at = end;
    }
    EXPECT_EQ(at, n);
  }
}

TEST_F(Parallel, SumHasTheSameBitsForAnyNumberOfThreads) {
  Random random;
  std::vector<double> terms(1000003);
  for (double& x : terms) x = random.uniform(-1, 1) * random.log_uniform(1e-12, 1e12);
  auto sum = [&](Index chunk) {
    return parallel_sum<double>(
        static_cast<Index>(terms.size()),
        [&](Index begin, Index end) {
          double s = 0;
          for (Index k = begin; k < end; ++k) s += terms[k];
          return s;
        },
        chunk);
  };
  for (Index chunk : {Index{100}, kChunk}) {
    set_thread_count(1);
    const double one = sum(chunk);
    for (int threads : {2, 4})
      for (int repeat = 0; repeat < 5; ++repeat) {
        set_thread_count(threads);
        EXPECT_EQ(sum(chunk), one) << threads << " threads, chunks of " << chunk;
      }
  }
}

TEST_F(Parallel, SumIsThePairwiseTreeOfItsChunks) {
  // Five chunks of one term: ((a + b) + (c + d)) + e, whose rounding no other order has.
  const std::array<double, 5> x{1e16, 1, -1e16, 1, 0.5};
  const double sum = parallel_sum<double>(
      5, [&](Index begin, Index) { return x[begin]; }, 1);
  EXPECT_EQ(sum, ((x[0] + x[1]) + (x[2] + x[3])) + x[4]);
}

TEST_F(Parallel, SumOfNothingIsZero) {
  EXPECT_EQ(parallel_sum<double>(0, [](Index, Index) { return 1.0; }), 0);
}

TEST_F(Parallel, SumWorksForAnyTypeWithAddition) {
  struct Pair {
    Index count = 0, sum = 0;
    Pair& operator+=(const Pair& o) {
      count += o.count;
      sum += o.sum;
      return *this;
    }
  };
  const Pair total = parallel_sum<Pair>(10001, [](Index begin, Index end) {
    Pair p;
    for (Index k = begin; k < end; ++k) p += Pair{1, k};
    return p;
  });
  EXPECT_EQ(total.count, 10001);
  EXPECT_EQ(total.sum, Index{10000} * 10001 / 2);
}

TEST_F(Parallel, AnExceptionReachesTheCaller) {
  for (int threads : {1, 2, 4}) {
    set_thread_count(threads);
    for (Index n : {1, 2, 1000})
      expect_throw<std::runtime_error>(
          [&] {
            parallel_for(n, [&](Index i) {
              if (i == n / 2) throw std::runtime_error("index " + std::to_string(i));
            });
          },
          "index " + std::to_string(n / 2));
  }
}

TEST_F(Parallel, ThreadCountIsWhatWasSet) {
#ifdef __SANITIZE_THREAD__
  GTEST_SKIP() << "builds with the thread sanitizer have threads of their own (parallel_threads.cpp)";
#endif
  using tbb::global_control;
  for (int threads : {1, 3, 2}) {
    set_thread_count(threads);
    EXPECT_EQ(global_control::active_value(global_control::max_allowed_parallelism),
              static_cast<std::size_t>(threads));
  }
}

}  // namespace
}  // namespace knotfit::test
