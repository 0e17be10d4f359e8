#include "run.h"

#include <tbb/task_arena.h>

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
namespace knotfit::python {
namespace {

// A signal is heard after at most this.
constexpr std::chrono::milliseconds kTick{20};

/// The newest report, on its way from the working thread.
struct Report {
  std::string stage;
  Progress progress;
};

struct Shared {
  std::mutex mutex;
  std::condition_variable ended;
  bool done = false;
  std::exception_ptr failure;
  std::optional<Report> report;
};

/// The exception that is set, with its traceback.
py::object raised() {
  PyObject *type = nullptr, *value = nullptr, *trace = nullptr;
  PyErr_Fetch(&type, &value, &trace);
  PyErr_NormalizeException(&type, &value, &trace);
  if (trace != nullptr) PyException_SetTraceback(value, trace);
  Py_XDECREF(type);
  Py_XDECREF(trace);
  return py::reinterpret_steal<py::object>(value);
}

/// \return whether the work shall go on
bool tell(const py::object& progress, const Report& r) {
  const Progress& p = r.progress;
  const py::object answer = progress(r.stage, p.fraction, p.error, p.tolerance, p.size_u, p.size_v, p.fits);
  return !answer.is(py::bool_(false));
}

}  // namespace

py::object run(const RunOptions& options, const std::function<void(const Control&)>& work) {
  Shared shared;
  std::stop_source stop;
  const bool heard = !options.progress.is_none();
  Control control{.progress = {}, .stop = stop.get_token(), .time_limit = options.time_limit};
  if (heard)
    control.progress = [&shared](const Progress& p) {
      const std::lock_guard lock(shared.mutex);
      Report& report = shared.report.emplace(Report{std::string(p.stage), p});
      report.progress.stage = {};  // its text lives as long as the call
    };
  std::thread worker([&] {
    try {
      if (options.threads > 0) {
        tbb::task_arena arena(options.threads);
        arena.execute([&] { work(control); });
      } else {
        work(control);
      }
    } catch (...) {
      shared.failure = std::current_exception();
    }
    const std::lock_guard lock(shared.mutex);
    shared.done = true;
    shared.ended.notify_all();
  });

  py::object pending = py::none();
  for (bool done = false; !done;) {
    std::optional<Report> report;
    {
      const py::gil_scoped_release released;
      std::unique_lock lock(shared.mutex);
      done = shared.ended.wait_for(lock, kTick, [&] { return shared.done; });
      report.swap(shared.report);
    }
    if (PyErr_CheckSignals() != 0) {
      pending = raised();
      stop.request_stop();
    }
    if (!heard || !report || stop.stop_requested()) continue;
    try {
      if (!tell(options.progress, *report)) stop.request_stop();
    } catch (py::error_already_set& e) {
      e.restore();
      pending = raised();
      stop.request_stop();
    }
  }
  {
    const py::gil_scoped_release released;
    worker.join();
  }
  if (shared.failure && pending.is_none()) std::rethrow_exception(shared.failure);
  return pending;
}

}  // namespace knotfit::python
