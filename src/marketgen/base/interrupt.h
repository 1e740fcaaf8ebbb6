// Interrupts (Ctrl-C, SIGTERM, SIGHUP): the signal only sets a flag. Long work asks for it and
// gives up cleanly; in the program, what does not ask in time is ended by force, and what it would
// have left behind is removed.
//
// Work that returns a Result asks with check_interrupt(). Loops deep inside work without one, and
// every parallel loop between two indices (base/parallel.h), ask with interrupt_point(), which
// throws: Interrupted is the only exception that crosses modules. until_interrupted() turns it into
// the error again, at the borders: main(), Python's calls, threads of our own.
#pragma once
#include <chrono>
#include <filesystem>

#include "base/result.h"

namespace marketgen {

// How long the program's work has to give up after the first signal, before it is ended by force.
constexpr std::chrono::milliseconds interrupt_grace{700};

// For the program's main(), once: from now on the first SIGINT, SIGTERM or SIGHUP sets the flag.
// After `interrupt_grace`, or at the second signal, the process ends with the error
// internal.interrupted, its status, and without its leftovers. SIGHUP stays ignored where it was
// (nohup). A closed pipe and a file that grows too large become errors of write() instead of
// signals.
void watch_for_interrupts();

// The same flag while it lives, for a host that handles signals itself (Python), without the end by
// force: when the last of them goes, the host's own handler of SIGINT comes back, the flag is put
// down, and the host is told if it was set. Any number may live at once, in any threads.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;
};

// The error internal.interrupted once the flag is set.
Result<void> check_interrupt();
Error interrupted_error();

struct Interrupted {};  // no std::exception: what mends the faults of others must not swallow it
// Throws Interrupted once the flag is set. Costs a load: meant for loops.
void interrupt_point();

// What work() returns; internal.interrupted when it threw Interrupted.
template <class Work>
auto until_interrupted(const Work& work) -> decltype(work()) {
  try {
    return work();
  } catch (const Interrupted&) {
    return interrupted_error();
  }
}

// Names a file or folder of ours that is removed when the process is ended by force, until it is
// dropped again: what is being written and does not have its own name yet. Thread-safe.
void add_leftover(const std::filesystem::path& path);
void drop_leftover(const std::filesystem::path& path);

// While it lives, the end by force waits (at most two seconds): several files are put in place
// together, or what was finished is being kept. Never across long work.
class NoForcedEnd {
 public:
  NoForcedEnd();
  ~NoForcedEnd();
  NoForcedEnd(const NoForcedEnd&) = delete;
  NoForcedEnd& operator=(const NoForcedEnd&) = delete;
};

}  // namespace marketgen
