// Interrupts (Ctrl-C): the signal only sets a flag; long work asks for it between steps and gives
// up cleanly.
#pragma once
#include "base/result.h"

namespace marketgen {

// From now on the first SIGINT or SIGTERM sets the flag; the second one ends the process at once.
void watch_for_interrupts();
// The same while it lives, for a host that handles signals itself (Python): when the last of them
// goes, the host's own handler of SIGINT comes back, the flag is put down, and the host is told if
// it was set. Any number may live at once, in any threads.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;
};

// The error internal.interrupted once the flag is set.
Result<void> check_interrupt();

}  // namespace marketgen
