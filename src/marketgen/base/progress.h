// Progress of long work, and the log. Progress goes to stderr: a bar on a terminal, plain lines
// otherwise, nothing when quiet. Results go to stdout and are not this file's business.
#pragma once
#include <atomic>
#include <cstddef>
#include <mutex>
#include <string>
#include <string_view>

namespace marketgen {

// Where long work reports to. The base class says nothing: tests and libraries pass it.
// Thread-safe.
class Progress {
 public:
  virtual ~Progress() = default;
  virtual void begin(std::string_view stage, std::size_t steps);  // a stage of `steps` steps starts
  virtual void advance(std::size_t steps = 1);                    // that many more are done
  virtual void end();                                             // the stage is over
};

Progress& silent_progress();

// Prints to stderr; terminal or not is found out once.
class ConsoleProgress : public Progress {
 public:
  ConsoleProgress();
  void begin(std::string_view stage, std::size_t steps) override;
  void advance(std::size_t steps) override;
  void end() override;

 private:
  void draw(bool final);

  std::mutex mutex_;
  bool terminal_;
  std::string stage_;
  std::size_t steps_ = 0;
  std::atomic<std::size_t> done_ = 0;
  int drawn_percent_ = -1;
  double start_s_ = 0;
};

// Log lines to stderr; `set_log_level("debug" | "info" | "warning" | "error" | "off")`.
void set_log_level(std::string_view level);
void log_debug(std::string_view message);
void log_info(std::string_view message);
void log_warning(std::string_view message);

double monotonic_seconds();  // for timing only, never for results
double peak_rss_mb();        // of this process, from the operating system

}  // namespace marketgen
