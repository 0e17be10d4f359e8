#include "knotfit/control.h"

#include <algorithm>
namespace knotfit {
namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

Control time_left(const Control& control, std::chrono::steady_clock::time_point start) {
  Control rest = control;
  if (control.time_limit > 0) rest.time_limit = std::max(1e-3, control.time_limit - seconds_since(start));
  return rest;
}

bool out_of_time(const Control& control, std::chrono::steady_clock::time_point start) {
  return control.time_limit > 0 && seconds_since(start) > control.time_limit;
}

}  // namespace knotfit
