#include "base/interrupt.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "base/call_interrupt.h"
#include "base/error_codes.h"

namespace marketgen {
namespace {

std::atomic<bool> interrupted = false;  // lock-free: set by signal handlers

std::mutex watching;  // of what follows
int watches = 0;
struct sigaction before_watch {};

std::array<int, 2> wake{-1, -1};  // a byte for every signal, to the thread that ends by force

void on_signal(int) {
  const int kept = errno;
  interrupted = true;
  [[maybe_unused]] const ssize_t told = wake[1] < 0 ? 0 : write(wake[1], "!", 1);
  errno = kept;
}

// The second Ctrl-C under a host ends as the host would have it.
void on_signal_of_host(int number) {
  on_signal(number);
  struct sigaction usual {};
  usual.sa_handler = SIG_DFL;
  sigaction(number, &usual, nullptr);
}

void on_nothing(int) {}

bool is_interrupted() {
  return interrupted.load(std::memory_order_relaxed) || call_interrupted();
}

void handle(int number, void (*handler)(int), struct sigaction* before = nullptr) {
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  sigaction(number, &action, before);
}

// Never destroyed: the process may be ended by force while its statics go.
struct Leftovers {
  std::mutex mutex;
  std::multiset<std::filesystem::path> paths;
  std::atomic<int> holds = 0;  // of NoForcedEnd
};
Leftovers& leftovers() {
  static auto& all = *new Leftovers;
  return all;
}

// Waits for the next signal; forever, or for the grace. Whether one came.
bool signal_came(int timeout_ms) {
  pollfd end{wake[0], POLLIN, 0};
  while (true) {
    const int ready = poll(&end, 1, timeout_ms);
    if (ready < 0 && errno == EINTR) continue;
    char byte = 0;
    return ready > 0 && read(wake[0], &byte, 1) == 1;
  }
}

void wait_for_holds() {
  constexpr int looks = 200, look_us = 10'000;
  for (int i = 0; i < looks && leftovers().holds > 0; ++i)
    usleep(look_us);
}

[[noreturn]] void end_by_force() {
  wait_for_holds();
  std::vector<std::filesystem::path> paths;
  {
    const std::scoped_lock lock(leftovers().mutex);
    paths.assign(leftovers().paths.begin(), leftovers().paths.end());
  }
  std::error_code ignored;
  for (const std::filesystem::path& path : paths)
    std::filesystem::remove_all(path, ignored);
  Error error = interrupted_error();
  error.message = "interrupted, and ended by force; nothing half-written was left behind";
  const std::string line = to_string(error) + "\n";
  pollfd err{STDERR_FILENO, POLLOUT, 0};
  [[maybe_unused]] const ssize_t told =
      poll(&err, 1, 100) > 0 ? write(STDERR_FILENO, line.data(), line.size()) : 0;
  _exit(exit_status_of(error.code));
}

}  // namespace

void watch_for_interrupts() {
  if (pipe2(wake.data(), O_CLOEXEC | O_NONBLOCK) == 0) {
    std::thread([] {
      while (!signal_came(-1)) {
      }
      signal_came(static_cast<int>(interrupt_grace.count()));
      end_by_force();
    }).detach();
  }
  handle(SIGINT, on_signal);
  handle(SIGTERM, on_signal);
  struct sigaction before {};
  sigaction(SIGHUP, nullptr, &before);
  if (before.sa_handler != SIG_IGN) handle(SIGHUP, on_signal);
  handle(SIGPIPE, on_nothing);  // not ignored: programs that we start would inherit that
  handle(SIGXFSZ, on_nothing);
}

InterruptWatch::InterruptWatch() {
  const std::scoped_lock lock(watching);
  if (watches++ == 0) handle(SIGINT, on_signal_of_host, &before_watch);
}

InterruptWatch::~InterruptWatch() {
  const std::scoped_lock lock(watching);
  if (--watches > 0) return;
  sigaction(SIGINT, &before_watch, nullptr);
  if (interrupted.exchange(false)) std::raise(SIGINT);
}

Error interrupted_error() {
  return {"internal.interrupted", "", "interrupted; nothing was left behind"};
}

Result<void> check_interrupt() {
  if (is_interrupted()) return interrupted_error();
  return {};
}

void interrupt_point() {
  if (is_interrupted()) throw Interrupted{};
}

void add_leftover(const std::filesystem::path& path) {
  const std::scoped_lock lock(leftovers().mutex);
  leftovers().paths.insert(path);
}

void drop_leftover(const std::filesystem::path& path) {
  const std::scoped_lock lock(leftovers().mutex);
  const auto found = leftovers().paths.find(path);
  if (found != leftovers().paths.end()) leftovers().paths.erase(found);
}

NoForcedEnd::NoForcedEnd() {
  ++leftovers().holds;
}
NoForcedEnd::~NoForcedEnd() {
  --leftovers().holds;
}

}  // namespace marketgen
