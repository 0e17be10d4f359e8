#include "signals.h"

#include <pthread.h>
#include <signal.h>

#include <cstdlib>

#include "exit_status.h"
namespace knotfit::tool {
namespace {

// SIGUSR1 wakes the waiter when the work is over.
sigset_t watched() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  sigaddset(&set, SIGUSR1);
  return set;
}

}  // namespace

StopOnSignal::StopOnSignal() {
  const sigset_t set = watched();
  pthread_sigmask(SIG_BLOCK, &set, nullptr);
  // A thread, not a handler: request_stop() is not safe inside one.
  waiter_ = std::thread([this, set] {
    for (;;) {
      int signal = 0;
      if (sigwait(&set, &signal) != 0) continue;
      if (finished_) return;
      if (signal == SIGUSR1) continue;
      if (source_.stop_requested()) std::_Exit(kStopped);
      source_.request_stop();
    }
  });
}

StopOnSignal::~StopOnSignal() {
  finished_ = true;
  pthread_kill(waiter_.native_handle(), SIGUSR1);
  waiter_.join();
}

}  // namespace knotfit::tool
