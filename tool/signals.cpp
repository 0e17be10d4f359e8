#include "signals.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <string>

#include "exit_status.h"
namespace knotfit::tool {
namespace {

constexpr int kWatched[] = {SIGINT, SIGTERM};
constexpr char kStop = 's', kFinished = 'f';

int pipe_ends[2] = {-1, -1};
std::atomic<int> signals_seen = 0;
static_assert(std::atomic<int>::is_always_lock_free);

// What a handler may do: count, write a byte, end the program.
void on_signal(int) {
  const int saved = errno;
  if (signals_seen.fetch_add(1) > 0) _exit(kStopped);
  // The pipe cannot be full, and there is nothing to do about an error.
  if (write(pipe_ends[1], &kStop, 1) < 0) _exit(kStopped);
  errno = saved;
}

}  // namespace

// A handler and not a thread that waits for blocked signals: a library (BLAS) may have threads from
// before main() that block nothing. A thread for request_stop(), which is not safe in a handler.
StopOnSignal::StopOnSignal() {
  if (pipe2(pipe_ends, O_CLOEXEC) != 0)
    throw std::runtime_error(std::string("no pipe for signals: ") + std::strerror(errno));
  signals_seen = 0;
  waiter_ = std::thread([this] {
    char byte = 0;
    while (read(pipe_ends[0], &byte, 1) != 1 || byte != kFinished)
      if (byte == kStop) source_.request_stop();
  });
  for (const int signal : kWatched) {
    struct sigaction old {
    }, action{};
    action.sa_handler = on_signal;
    action.sa_flags = SA_RESTART;
    if (sigaction(signal, nullptr, &old) == 0 && old.sa_handler != SIG_IGN)
      sigaction(signal, &action, nullptr);
  }
}

StopOnSignal::~StopOnSignal() {
  for (const int signal : kWatched) {
    struct sigaction old {};
    if (sigaction(signal, nullptr, &old) == 0 && old.sa_handler == on_signal) ::signal(signal, SIG_DFL);
  }
  while (write(pipe_ends[1], &kFinished, 1) != 1 && errno == EINTR) {
  }
  waiter_.join();
  close(pipe_ends[0]);
  close(pipe_ends[1]);
}

}  // namespace knotfit::tool
