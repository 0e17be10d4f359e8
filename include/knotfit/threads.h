// How many threads the library uses. Results do not depend on it.
#pragma once
namespace [[gnu::visibility("default")]] knotfit {
/// Threads for all later work of this process; 0: as many as there are cores.
void set_thread_count(int threads);
}  // namespace knotfit
