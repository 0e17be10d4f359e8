#include "knotfit/refine.h"
namespace knotfit {

std::string_view to_string(Status status) {
  switch (status) {
    case Status::not_run:
      return "not_run";
    case Status::fixed_size:
      return "fixed_size";
    case Status::reached:
      return "reached";
    case Status::not_reached:
      return "not_reached";
    case Status::data_too_sparse:
      return "data_too_sparse";
    case Status::tolerance_below_noise:
      return "tolerance_below_noise";
    case Status::swings:
      return "swings";
    case Status::folded:
      return "folded";
    case Status::limit_reached:
      return "limit_reached";
    case Status::time_limit:
      return "time_limit";
    case Status::stopped:
      return "stopped";
    case Status::failed:
      return "failed";
  }
  return "unknown";
}

}  // namespace knotfit
