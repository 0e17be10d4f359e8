// What every search to a tolerance shares, whatever it fits: stop, time, budget, progress, the sizes tried.
#pragma once
#include <string_view>
#include <vector>

#include "base/deadline.h"
#include "knotfit/refine.h"
namespace knotfit {

/// The best surface or curve so far, as progress shows it.
struct BestShown {
  double error = -1;  ///< that counts; -1: there is none
  int size_u = 0, size_v = 0;
};

class SearchRun {
 public:
  /// \param control  outlives the run
  /// \param unit     errors and the tolerance times this are in the unit of what is shown and listed
  /// \param most     linear fits, or rounds of correction
  SearchRun(const Control& control, const Tolerance& tolerance, long most, double unit = 1)
      : deadline_(control), tolerance_(tolerance), most_(most), unit_(unit) {}

  const Tolerance& tolerance() const { return tolerance_; }
  bool holds(double error) const { return error <= tolerance_.value; }

  /// Stopped or out of time; cheap, for inner loops.
  bool stopped() const { return deadline_.over(); }
  /// Stopped, out of time or out of fits.
  bool interrupted(long fits) const { return stopped() || fits >= most_; }
  /// `stopped` or `time_limit` where the run was cut, else the status given.
  Status cut_or(Status otherwise) const {
    return deadline_.stopped() ? Status::stopped : stopped() ? Status::time_limit : otherwise;
  }
  Control time_left() const { return deadline_.left(); }

  void set_stage(std::string_view stage) { stage_ = stage; }
  void show(const BestShown& best, long fits) const {
    const auto& progress = deadline_.control().progress;
    if (!progress) return;
    progress({.stage = stage_,
              .error = best.error > 0 ? best.error * unit_ : best.error,
              .tolerance = tolerance_.value * unit_,
              .size_u = best.size_u,
              .size_v = best.size_v,
              .fits = fits});
  }

  /// A size is done with.
  void list(Index size_u, Index size_v, double error, bool holds) {
    tried_.push_back({static_cast<int>(size_u), static_cast<int>(size_v), error * unit_, holds});
  }
  const std::vector<SizeTried>& tried() const { return tried_; }

 private:
  Deadline deadline_;
  Tolerance tolerance_;
  long most_;
  double unit_;
  std::string_view stage_ = "size search";
  std::vector<SizeTried> tried_;
};

}  // namespace knotfit
