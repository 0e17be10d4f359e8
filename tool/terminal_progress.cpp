#include "terminal_progress.h"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
namespace knotfit::tool {
namespace {

std::string duration(double seconds) {
  if (seconds < 100) return fmt::format("{:.0f} s", seconds);
  if (seconds < 6000) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

std::size_t terminal_width() {
  winsize size{};
  if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) != 0 || size.ws_col < 20) return 80;
  return size.ws_col;
}

}  // namespace

std::string progress_line(const Progress& p, double elapsed, double stage_elapsed, double time_limit) {
  std::string line(p.stage);
  if (p.fraction >= 0) line += fmt::format(" {:.0f} %", 100 * std::min(1.0, p.fraction));
  if (p.size_u > 0) line += fmt::format(", {} x {} control points", p.size_u, p.size_v);
  if (p.error >= 0) line += fmt::format(", error {:.3g}", p.error);
  if (p.error >= 0 && p.tolerance > 0) line += fmt::format(" (tolerance {:.3g})", p.tolerance);
  if (p.fits > 0) line += fmt::format(", {} fits", p.fits);
  if (elapsed >= 1) line += ", " + duration(elapsed);
  double left = -1;
  if (p.fraction > 0.02 && p.fraction < 1 && stage_elapsed > 1)
    left = stage_elapsed * (1 - p.fraction) / p.fraction;
  if (time_limit > 0) {
    const double limit = std::max(0.0, time_limit - elapsed);
    left = left < 0 ? limit : std::min(left, limit);
    line += fmt::format(", at most {} left", duration(left));
  } else if (left >= 0) {
    line += fmt::format(", about {} left", duration(left));
  }
  return line;
}

TerminalProgress::TerminalProgress(bool wanted, double time_limit)
    : active_(wanted && isatty(STDERR_FILENO) == 1),
      time_limit_(time_limit),
      start_(Clock::now()),
      stage_start_(start_),
      last_(start_ - std::chrono::hours(1)) {}

void TerminalProgress::report(const Progress& progress) {
  if (!active_) return;
  const Clock::time_point now = Clock::now();
  const bool new_stage = progress.stage != stage_;
  if (new_stage) {
    stage_ = progress.stage;
    stage_start_ = now;
  }
  if (!new_stage && now - last_ < std::chrono::milliseconds(100)) return;
  last_ = now;
  const auto seconds = [&](Clock::time_point since) {
    return std::chrono::duration<double>(now - since).count();
  };
  std::string line = progress_line(progress, seconds(start_), seconds(stage_start_), time_limit_);
  line.resize(std::min(line.size(), terminal_width() - 1));
  std::fprintf(stderr, "\r\033[K%s", line.c_str());
  std::fflush(stderr);
  drawn_ = true;
}

Control TerminalProgress::control(std::stop_token stop) {
  Control control;
  if (active_) control.progress = [this](const Progress& progress) { report(progress); };
  control.stop = std::move(stop);
  return control;
}

void TerminalProgress::clear() {
  if (!drawn_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  drawn_ = false;
}

}  // namespace knotfit::tool
