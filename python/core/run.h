// Long work: on a thread of its own with the GIL released, while the caller's thread hears signals and tells progress.
#pragma once
#include <pybind11/pybind11.h>

#include <functional>

#include "knotfit/control.h"
namespace knotfit::python {
namespace py = pybind11;

struct RunOptions {
  int threads = 0;        ///< of this work alone; 0: as many as there are cores
  double time_limit = 0;  ///< as Control
  py::object progress;    ///< called with the members of Progress; None: nobody hears
};

/// Runs `work`; what it throws is thrown. A signal handler or a progress call that raises, or one that returns False,
/// stops it.
/// \return what was raised, or None: the work ended, or was stopped by False
py::object run(const RunOptions& options, const std::function<void(const Control&)>& work);

}  // namespace knotfit::python
