// Ctrl-C: the first asks the work to stop and keep its best, a second ends the program.
#pragma once
#include <stop_token>
#include <thread>
namespace knotfit::tool {

/// While it lives, SIGINT and SIGTERM request a stop; one at a time in a process. A signal that
/// was ignored when the program began (nohup) stays ignored.
class StopOnSignal {
 public:
  StopOnSignal();
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;
  std::stop_token token() const { return source_.get_token(); }
  bool requested() const { return source_.stop_requested(); }

 private:
  std::stop_source source_;
  std::thread waiter_;
};

}  // namespace knotfit::tool
