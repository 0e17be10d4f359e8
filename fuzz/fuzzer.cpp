// One target for libFuzzer: KNOTFIT_FUZZ_TARGET names it. A broken promise, or memory beyond the bound, is a crash.
#include <sanitizer/allocator_interface.h>

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "targets.h"
namespace {

// What the reader holds at once, beside what was in use before. The sanitizer tells of every block.
std::atomic<bool> counting{false};
std::atomic<long long> live{0}, peak{0};

void count_block(const volatile void*, std::size_t size) {
  if (!counting) return;
  const long long now = live += static_cast<long long>(size);
  long long most = peak.load();
  while (now > most && !peak.compare_exchange_weak(most, now)) {
  }
}

void count_free(const volatile void* block) {
  if (counting && block != nullptr)
    live -= static_cast<long long>(__sanitizer_get_allocated_size(const_cast<const void*>(block)));
}

[[noreturn]] void fail(const char* what) {
  std::fprintf(stderr, "knotfit: %s\n", what);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  if (knotfit::fuzz::find_target(KNOTFIT_FUZZ_TARGET) == nullptr) fail("no such target");
  if (__sanitizer_install_malloc_and_free_hooks(count_block, count_free) == 0)
    fail("memory cannot be watched");
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const knotfit::fuzz::Target* const target = knotfit::fuzz::find_target(KNOTFIT_FUZZ_TARGET);
  live = peak = 0;
  counting = true;
  try {
    target->read({reinterpret_cast<const char*>(data), size});
  } catch (const std::exception& e) {
    counting = false;
    fail(e.what());
  }
  counting = false;
  if (peak > static_cast<long long>(knotfit::fuzz::memory_bound(size))) {
    std::fprintf(stderr, "%lld bytes in use for a file of %zu\n", peak.load(), size);
    fail("more memory than ten times the file and 64 MB");
  }
  return 0;
}
