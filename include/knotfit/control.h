// Progress and stop: what a caller hands to long work.
#pragma once
#include <chrono>
#include <functional>
#include <stop_token>
#include <string_view>
namespace [[gnu::visibility("default")]] knotfit {

/// A report on long work. Reports come from the calling thread.
struct Progress {
  std::string_view stage;      ///< "read", "features", "size search", "walk down", ...
  double fraction = -1;        ///< share of the stage done in [0,1]; < 0 where unknown
  double error = -1;           ///< the error asked for, of the best surface so far; < 0: none yet
  double tolerance = -1;       ///< < 0: none
  int size_u = 0, size_v = 0;  ///< control points a direction of the surface at hand
  long fits = 0;               ///< linear fits so far
};

/// How long work is watched and stopped. Default: silent, never stopped.
struct Control {
  std::function<void(const Progress&)> progress;
  std::stop_token stop;
  /// Seconds of wall clock after which the best so far is returned with status time_limit;
  /// 0: no limit, so that a result does not depend on the machine.
  double time_limit = 0;
};

/// The control for what remains of work begun at `start`: its limit is what is left of the time, and a millisecond
/// where none is, since 0 would be no limit.
Control time_left(const Control& control, std::chrono::steady_clock::time_point start);

/// Whether the time limit of work begun at `start` is over; without one it never is.
bool out_of_time(const Control& control, std::chrono::steady_clock::time_point start);

}  // namespace knotfit
