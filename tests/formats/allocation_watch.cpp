#include "allocation_watch.h"

#include <malloc.h>

#include <cstdlib>
#include <new>
namespace knotfit::test {

std::atomic<std::size_t> largest_request{0}, live_bytes{0}, peak_bytes{0};

namespace {

void raise_to(std::atomic<std::size_t>& most, std::size_t size) {
  std::size_t seen = most.load();
  while (size > seen && !most.compare_exchange_weak(seen, size)) {
  }
}

}  // namespace
}  // namespace knotfit::test

[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  using namespace knotfit::test;
  raise_to(largest_request, size);
  void* const p = std::malloc(size > 0 ? size : 1);
  if (p != nullptr) raise_to(peak_bytes, live_bytes += malloc_usable_size(p));
  return p;
}
[[gnu::noinline]] void* operator new(std::size_t size) {
  if (void* p = operator new(size, std::nothrow)) return p;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* p) noexcept {
  if (p != nullptr) knotfit::test::live_bytes -= malloc_usable_size(p);
  std::free(p);
}
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept {
  operator delete(p);
}
[[gnu::noinline]] void operator delete(void* p, const std::nothrow_t&) noexcept {
  operator delete(p);
}
