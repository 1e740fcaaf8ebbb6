// Interrupts (Ctrl-C): the signal only sets a flag; long work asks for it between steps and gives
// up cleanly.
#pragma once
#include "base/result.h"

namespace marketgen {

// From now on the first SIGINT or SIGTERM sets the flag; the second one ends the process at once.
void watch_for_interrupts();
// The same while it lives, for a host that handles signals itself (Python): its own handler of
// SIGINT comes back, and the flag is put down.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

 private:
  void (*before_)(int);
};

// The error internal.interrupted once the flag is set.
Result<void> check_interrupt();

}  // namespace marketgen
