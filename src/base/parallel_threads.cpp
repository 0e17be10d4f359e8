// parallel_for on plain threads, for builds with the thread sanitizer: it does not see what a TBB that was built without
// it waits for, and reports every task. Nested calls run where they are.
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "base/parallel.h"
#include "knotfit/threads.h"
namespace knotfit {
namespace {

std::atomic<int> wanted_threads{0};  // 0: as many as there are cores
thread_local bool inside = false;

int thread_count() {
  const int wanted = wanted_threads;
  return wanted > 0 ? wanted : std::max(2, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace

void parallel_for(Index n, const std::function<void(Index)>& body) {
  const Index threads = std::min<Index>(n, thread_count());
  if (threads <= 1 || inside) {
    for (Index i = 0; i < n; ++i) body(i);
    return;
  }
  std::atomic<Index> next{0};
  std::exception_ptr failure;
  std::mutex failing;
  const auto work = [&] {
    inside = true;
    for (Index i = next++; i < n; i = next++) {
      try {
        body(i);
      } catch (...) {
        const std::lock_guard lock(failing);
        if (!failure) failure = std::current_exception();
        next = n;
      }
    }
    inside = false;
  };
  {
    std::vector<std::jthread> others;
    for (Index t = 1; t < threads; ++t) others.emplace_back(work);
    work();
  }
  if (failure) std::rethrow_exception(failure);
}

void set_thread_count(int threads) {
  wanted_threads = threads;
}

}  // namespace knotfit
