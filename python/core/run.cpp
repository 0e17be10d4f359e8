#include "run.h"

#include <tbb/task_arena.h>

#include <algorithm>
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
// What stopped work is given to end before its caller is let go.
constexpr std::chrono::milliseconds kGrace{100};

/// The newest report, on its way from the working thread.
struct Report {
  std::string stage;
  Progress progress;
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

struct Work::Shared {
  std::mutex mutex;
  std::condition_variable changed;
  bool done = false;
  std::exception_ptr failure;
  std::optional<Report> report;
  std::stop_source stop;
};

Work::Work(const RunOptions& options, std::function<void(const Control&)> work)
    : shared_(std::make_shared<Shared>()) {
  Control control{.progress = {}, .stop = shared_->stop.get_token(), .time_limit = options.time_limit};
  if (!options.progress.is_none())
    control.progress = [shared = shared_.get()](const Progress& p) {
      const std::lock_guard lock(shared->mutex);
      Report& report = shared->report.emplace(Report{std::string(p.stage), p});
      report.progress.stage = {};  // its text lives as long as the call
    };
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int threads = std::min(options.threads, cores);
  std::thread([shared = shared_, control = std::move(control), work = std::move(work), threads]() mutable {
    std::exception_ptr failure;
    try {
      if (threads > 0) {
        tbb::task_arena arena(threads);
        arena.execute([&] { work(control); });
      } else {
        work(control);
      }
    } catch (...) {
      failure = std::current_exception();
    }
    work = {};  // what it owns goes here, before anybody hears of the end
    const std::lock_guard lock(shared->mutex);
    shared->failure = failure;
    shared->done = true;
    shared->changed.notify_all();
  }).detach();
}

py::object Work::watch(const py::object& progress) {
  py::object pending = py::none();
  auto leave = std::chrono::steady_clock::time_point::max();
  for (bool done = false; !done && std::chrono::steady_clock::now() < leave;) {
    std::optional<Report> report;
    {
      const py::gil_scoped_release released;
      std::unique_lock lock(shared_->mutex);
      done = shared_->changed.wait_for(lock, kTick, [&] { return shared_->done; });
      report.swap(shared_->report);
    }
    const auto stop_for = [&] {
      pending = raised();
      shared_->stop.request_stop();
      leave = std::min(leave, std::chrono::steady_clock::now() + kGrace);
    };
    if (PyErr_CheckSignals() != 0) stop_for();
    if (progress.is_none() || !report || shared_->stop.stop_requested()) continue;
    try {
      if (!tell(progress, *report)) shared_->stop.request_stop();
    } catch (py::error_already_set& e) {
      e.restore();
      stop_for();
    }
  }
  return pending;
}

py::object Work::wait() {
  py::object pending = py::none();
  for (bool done = false; !done && pending.is_none();) {
    {
      const py::gil_scoped_release released;
      std::unique_lock lock(shared_->mutex);
      done = shared_->changed.wait_for(lock, kTick, [&] { return shared_->done; });
    }
    if (PyErr_CheckSignals() != 0) pending = raised();
  }
  if (pending.is_none() && shared_->failure) std::rethrow_exception(shared_->failure);
  return pending;
}

bool Work::ended() const {
  const std::lock_guard lock(shared_->mutex);
  return shared_->done;
}

py::object run(const RunOptions& options, const std::function<void(const Control&)>& work) {
  Work running(options, [&work](const Control& control) { work(control); });
  py::object raised = running.watch(options.progress);
  while (!running.ended()) {  // `work` is the caller's: it ends before this call does
    const py::object again = running.wait();
    if (raised.is_none()) raised = again;
  }
  if (raised.is_none()) running.wait();
  return raised;
}

}  // namespace knotfit::python
