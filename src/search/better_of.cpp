#include "search/better_of.h"

#include <utility>
namespace knotfit {

Control after(const RefineResult& earlier, const Control& control) {
  if (!control.progress || earlier.surface.empty()) return control;
  Control shown = control;
  shown.progress = [&earlier, report = control.progress](const Progress& later) {
    Progress progress = later;
    const bool beaten = later.error >= 0 && later.error <= (earlier.holds ? later.tolerance : earlier.error);
    if (!beaten) {
      progress.error = earlier.error;
      progress.size_u = static_cast<int>(earlier.surface.size_u());
      progress.size_v = static_cast<int>(earlier.surface.size_v());
    }
    report(progress);
  };
  return shown;
}

RefineResult better_of(RefineResult a, RefineResult b) {
  auto better = [](const RefineResult& x, const RefineResult& y) {
    if (x.surface.empty() || y.surface.empty()) return !x.surface.empty();
    if (x.holds != y.holds) return x.holds;
    if (x.holds) return x.surface.control_point_count() < y.surface.control_point_count();
    if (x.swings != y.swings) return !x.swings;
    return x.error < y.error;
  };
  RefineResult& best = better(b, a) ? b : a;
  const RefineResult& other = &best == &a ? b : a;
  best.fits += other.fits;
  best.tried.insert(best.tried.end(), other.tried.begin(), other.tried.end());
  if (best.metric == InteriorKnots{}) best.metric = other.metric;
  const Status first = a.status, further = b.status;
  if (!best.holds && other.status == Status::swings) best.status = Status::swings;
  if (first == Status::time_limit || (further == Status::time_limit && !best.holds))
    best.status = Status::time_limit;
  if (first == Status::stopped || further == Status::stopped) best.status = Status::stopped;
  return std::move(best);
}

}  // namespace knotfit
