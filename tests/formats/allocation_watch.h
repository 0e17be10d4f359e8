// Every allocation of this test program is counted, so that a reader that believes a header shows up.
#pragma once
#include <atomic>
#include <cstddef>
namespace knotfit::test {

extern std::atomic<std::size_t> largest_request;  ///< since it was last set
extern std::atomic<std::size_t> live_bytes, peak_bytes;

/// The most memory in use at once while this lives, beyond what was in use before.
class PeakMemory {
 public:
  PeakMemory() : before_(live_bytes.load()) { peak_bytes = before_; }
  std::size_t bytes() const { return peak_bytes.load() - before_; }

 private:
  std::size_t before_;
};

}  // namespace knotfit::test
