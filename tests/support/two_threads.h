// Results do not depend on the number of threads.
#pragma once
#include <utility>

#include "knotfit/threads.h"
namespace knotfit::test {

/// What the work gives on one thread, and on two.
template <class Work>
auto on_one_and_two_threads(const Work& work) {
  set_thread_count(1);
  auto one = work();
  set_thread_count(2);
  auto two = work();
  set_thread_count(0);
  return std::pair(std::move(one), std::move(two));
}

}  // namespace knotfit::test
