#include "base/interrupt.h"

#include <csignal>

namespace marketgen {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void on_signal(int number) {
  interrupted = 1;
  std::signal(number, SIG_DFL);
}

}  // namespace

void watch_for_interrupts() {
  std::signal(SIGINT, on_signal);
  std::signal(SIGTERM, on_signal);
}

InterruptWatch::InterruptWatch() : before_(std::signal(SIGINT, on_signal)) {}

InterruptWatch::~InterruptWatch() {
  std::signal(SIGINT, before_ == SIG_ERR ? SIG_DFL : before_);
  interrupted = 0;
}

Result<void> check_interrupt() {
  if (interrupted != 0)
    return Error{"internal.interrupted", "", "interrupted; nothing was left behind"};
  return {};
}

}  // namespace marketgen
