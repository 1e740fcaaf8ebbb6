#include "base/progress.h"

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

#include <fmt/format.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include "base/safe_line.h"

namespace marketgen {

void Progress::begin(std::string_view, std::size_t) {}
void Progress::advance(std::size_t) {}
void Progress::end() {}

Progress& silent_progress() {
  static Progress silent;
  return silent;
}

ConsoleProgress::ConsoleProgress() : terminal_(isatty(STDERR_FILENO) == 1) {}

void ConsoleProgress::begin(std::string_view stage, std::size_t steps) {
  const std::scoped_lock lock(mutex_);
  stage_ = stage;
  steps_ = steps;
  done_ = 0;
  drawn_percent_ = -1;
  start_s_ = monotonic_seconds();
  draw(false);
}

void ConsoleProgress::advance(std::size_t steps) {
  done_ += steps;
  if (!terminal_) return;
  const std::scoped_lock lock(mutex_);
  draw(false);
}

void ConsoleProgress::end() {
  const std::scoped_lock lock(mutex_);
  draw(true);
}

void ConsoleProgress::draw(bool final) {
  if (!terminal_) {
    if (final) fmt::print(stderr, "{:<12} {:6.2f} s\n", stage_, monotonic_seconds() - start_s_);
    return;
  }
  const int percent =
      final || steps_ == 0 ? (final ? 100 : 0) : static_cast<int>(100 * done_.load() / steps_);
  if (percent == drawn_percent_ && !final) return;
  drawn_percent_ = percent;
  constexpr int width = 30;
  const int filled = percent * width / 100;
  fmt::print(stderr,
             "\r{:<12} [{}{}] {:3d}% {:6.2f} s{}",
             stage_,
             std::string(static_cast<std::size_t>(filled), '#'),
             std::string(static_cast<std::size_t>(width - filled), ' '),
             percent,
             monotonic_seconds() - start_s_,
             final ? "\n" : "");
  std::fflush(stderr);
}

namespace {

spdlog::logger& logger() {
  static const auto log = [] {
    auto made = spdlog::stderr_color_mt("marketgen");
    made->set_pattern("%l: %v");
    made->set_level(spdlog::level::warn);
    return made;
  }();
  return *log;
}

}  // namespace

void set_log_level(std::string_view level) {
  logger().set_level(spdlog::level::from_str(std::string(level)));
}
void log_debug(std::string_view message) {
  logger().debug(safe_line(message));
}
void log_info(std::string_view message) {
  logger().info(safe_line(message));
}
void log_warning(std::string_view message) {
  logger().warn(safe_line(message));
}

double monotonic_seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double peak_rss_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

}  // namespace marketgen
