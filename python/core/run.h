// Long work: on a thread of its own with the GIL released, while the caller's thread hears signals and tells progress.
#pragma once
#include <pybind11/pybind11.h>

#include <functional>
#include <memory>

#include "knotfit/control.h"
namespace knotfit::python {
namespace py = pybind11;

struct RunOptions {
  int threads = 0;        ///< of this work alone; 0: as many as there are cores
  double time_limit = 0;  ///< as Control
  py::object progress;    ///< called with the members of Progress; None: nobody hears
};

/// Runs `work`, which lives as long as this call; what it throws is thrown. A signal handler or a progress call that
/// raises, or one that returns False, stops it.
/// \return what was raised, or None: the work ended, or was stopped by False
py::object run(const RunOptions& options, const std::function<void(const Control&)>& work);

/// Work that may outlive its call: once stopped it ends soon, but not at once.
class Work {
 public:
  /// Starts. \param work  owns all that it uses
  Work(const RunOptions& options, std::function<void(const Control&)> work);
  /// Hears signals and tells progress. After a stop that something raised, returns in 0.1 s at the latest, the work
  /// ended or not. \return what was raised, or None
  py::object watch(const py::object& progress);
  /// Waits for the end. \return what was raised meanwhile, or None; what the work threw is thrown
  py::object wait();
  bool ended() const;

 private:
  struct Shared;
  std::shared_ptr<Shared> shared_;
};

}  // namespace knotfit::python
