#include "base/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <memory>
#include <thread>

#include "knotfit/threads.h"
namespace knotfit {

void parallel_for(Index n, const std::function<void(Index)>& body) {
  if (n <= 1) {
    if (n == 1) body(0);
    return;
  }
  tbb::parallel_for(tbb::blocked_range<Index>(0, n), [&](const tbb::blocked_range<Index>& range) {
    for (Index i = range.begin(); i != range.end(); ++i) body(i);
  });
}

void set_thread_count(int threads) {
  static std::unique_ptr<tbb::global_control> limit;
  const int wanted = threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
  limit.reset();
  limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                static_cast<std::size_t>(std::max(1, wanted)));
}

}  // namespace knotfit
