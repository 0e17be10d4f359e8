// Progress and stop of one piece of work, from the calling thread.
#pragma once
#include <string_view>

#include "base/deadline.h"
namespace knotfit {

class Stage {
 public:
  /// \param name  shown; outlives the stage, as the control does
  Stage(const Control& control, std::string_view name) : deadline_(control), name_(name) {}
  /// \return true where the work should end: stopped, or out of time
  bool report(double fraction, double error = -1, double tolerance = -1) const {
    if (const auto& progress = deadline_.control().progress)
      progress({.stage = name_, .fraction = fraction, .error = error, .tolerance = tolerance});
    return over();
  }
  bool over() const { return deadline_.over(); }

 private:
  Deadline deadline_;
  std::string_view name_;
};

}  // namespace knotfit
