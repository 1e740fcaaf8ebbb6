#include "base/interrupt.h"

#include <csignal>
#include <mutex>

namespace marketgen {
namespace {

volatile std::sig_atomic_t interrupted = 0;

std::mutex watching;  // of what follows
int watches = 0;
void (*before_watch)(int) = SIG_DFL;

void on_signal(int number) {
  interrupted = 1;
  std::signal(number, SIG_DFL);
}

}  // namespace

void watch_for_interrupts() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

InterruptWatch::InterruptWatch() {
  const std::scoped_lock lock(watching);
  if (watches++ == 0) before_watch = std::signal(SIGINT, on_signal);
}

InterruptWatch::~InterruptWatch() {
  const std::scoped_lock lock(watching);
  if (--watches > 0) return;
  std::signal(SIGINT, before_watch == SIG_ERR ? SIG_DFL : before_watch);
  if (interrupted == 0) return;
  interrupted = 0;
  std::raise(SIGINT);
}

Result<void> check_interrupt() {
  if (interrupted != 0)
    return Error{"internal.interrupted", "", "interrupted; nothing was left behind"};
  return {};
}

}  // namespace marketgen
