#include "base/parallel.h"

#include <pmmintrin.h>
#include <xmmintrin.h>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "base/call_interrupt.h"
#include "base/interrupt.h"

namespace marketgen {
namespace {

// Flush-to-zero and denormals-are-zero while it lives, so that every thread rounds alike.
class FlushDenormals {
 public:
  FlushDenormals() : saved_(_mm_getcsr()) {
    _MM_SET_FLUSH_ZERO_MODE(_MM_FLUSH_ZERO_ON);
    _MM_SET_DENORMALS_ZERO_MODE(_MM_DENORMALS_ZERO_ON);
  }
  ~FlushDenormals() { _mm_setcsr(saved_); }
  FlushDenormals(const FlushDenormals&) = delete;
  FlushDenormals& operator=(const FlushDenormals&) = delete;

 private:
  unsigned saved_;
};

}  // namespace

void parallel_for(std::size_t count,
                  const std::function<void(std::size_t)>& body,
                  std::size_t grain) {
  const tbb::blocked_range<std::size_t> all(0, count, grain == 0 ? 1 : grain);
  // Isolated: a thread that waits for a loop inside another takes no more of the outer one's work,
  // which might want a lock that this very thread holds.
  const std::atomic<bool>* const interrupt = CallInterrupt::of_this_thread();
  tbb::this_task_arena::isolate([&] {
    tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& piece) {
      const FlushDenormals flush;
      const CallInterrupt same_call(interrupt);
      for (std::size_t i = piece.begin(); i != piece.end(); ++i) {
        interrupt_point();
        body(i);
      }
    });
  });
}

// Made where it stays: TBB knows it by its address, and a copy of it limits nothing.
struct ThreadLimit::Control {
  explicit Control(std::size_t threads)
      : limit(tbb::global_control::max_allowed_parallelism, threads) {}
  Control(const Control&) = delete;
  Control& operator=(const Control&) = delete;

  tbb::global_control limit;
};

ThreadLimit::ThreadLimit(int threads) {
  if (threads > 0) control_ = std::make_unique<Control>(static_cast<std::size_t>(threads));
}
ThreadLimit::~ThreadLimit() = default;

int thread_count() {
  return static_cast<int>(
      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

}  // namespace marketgen
