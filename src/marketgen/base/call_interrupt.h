// Breaking off one call among many, for hosts that run several side by side (Python): the flag is
// the call's own, and goes with it into the threads that work for it.
#pragma once
#include <atomic>

namespace marketgen {

// While it lives, check_interrupt() in this thread, and in the threads of its parallel loops, also
// fails once `*flag` is set. `flag` must outlive it; nullptr is none. They nest: the inner one
// counts alone.
class CallInterrupt {
 public:
  explicit CallInterrupt(const std::atomic<bool>* flag);
  ~CallInterrupt();
  CallInterrupt(const CallInterrupt&) = delete;
  CallInterrupt& operator=(const CallInterrupt&) = delete;

  // That of this thread, to be handed to a thread that it starts.
  static const std::atomic<bool>* of_this_thread();

 private:
  const std::atomic<bool>* before_;
};

bool call_interrupted();  // in this thread

}  // namespace marketgen
