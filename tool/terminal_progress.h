// Progress on standard error: one line that is drawn over, only on a terminal.
#pragma once
#include <chrono>
#include <stop_token>
#include <string>

#include "knotfit/control.h"
namespace knotfit::tool {

/// The line for a report: stage, control points, error so far, fits, time left where known.
/// \param elapsed        seconds since the start
/// \param stage_elapsed  seconds since the stage began
std::string progress_line(const Progress& progress, double elapsed, double stage_elapsed, double time_limit);

class TerminalProgress {
 public:
  /// Silent where `wanted` is false or standard error is not a terminal.
  explicit TerminalProgress(bool wanted, double time_limit = 0);
  ~TerminalProgress() { clear(); }
  TerminalProgress(const TerminalProgress&) = delete;
  TerminalProgress& operator=(const TerminalProgress&) = delete;
  /// Work whose progress is reported here and that this token stops; outlived by this.
  Control control(std::stop_token stop);
  void report(const Progress& progress);
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  bool active_ = false, drawn_ = false;
  double time_limit_ = 0;
  std::string stage_;
  Clock::time_point start_, stage_start_, last_;
};

}  // namespace knotfit::tool
