// Work under way: whether it is to end, and how long its parts may take.
#pragma once
#include <chrono>

#include "knotfit/control.h"
namespace knotfit {

/// Begins when it is made. The control outlives it.
class Deadline {
 public:
  explicit Deadline(const Control& control) : control_(control) {}
  const Control& control() const { return control_; }
  bool stopped() const { return control_.stop.stop_requested(); }
  /// Stopped or out of time.
  bool over() const { return stopped() || out_of_time(control_, start_); }
  /// For a part of the work: what is left of the time.
  Control left() const { return time_left(control_, start_); }
  /// The same for a part whose progress is shown in its own way.
  Control left(const Control& shown) const { return time_left(shown, start_); }

 private:
  const Control& control_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace knotfit
