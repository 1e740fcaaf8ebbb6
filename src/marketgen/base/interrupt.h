// Interrupts (Ctrl-C): the signal only sets a flag; long work asks for it between steps and gives
// up cleanly.
#pragma once
#include "base/result.h"

namespace marketgen {

// From now on the first SIGINT or SIGTERM sets the flag; the second one ends the process at once.
void watch_for_interrupts();
// The error internal.interrupted once the flag is set.
Result<void> check_interrupt();

}  // namespace marketgen
