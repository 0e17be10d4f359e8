// Progress and stop of one piece of work, from the calling thread.
#pragma once
#include <chrono>
#include <string_view>

#include "knotfit/control.h"
namespace knotfit {

class Stage {
 public:
  Stage(const Control& control, std::string_view name)
      : control_(control), name_(name), start_(std::chrono::steady_clock::now()) {}
  /// \return true where the work should end: stopped, or out of time
  bool report(double fraction, double error = -1) const {
    if (control_.progress) control_.progress({.stage = name_, .fraction = fraction, .error = error});
    return over();
  }
  bool over() const { return control_.stop.stop_requested() || out_of_time(control_, start_); }

 private:
  const Control& control_;
  std::string_view name_;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace knotfit
