// Long work that tells a Python callable how far it is.
#pragma once
#include <nanobind/stl/optional.h>

#include <atomic>
#include <condition_variable>
#include <deque>
#include <exception>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "base/call_interrupt.h"
#include "base/progress.h"
#include "binding.h"

namespace marketgen::python {

// Takes what work reports in its threads to the thread that waits for it. A stage's begin and end
// wait until they were told, so that none is left out and a callable that raises stops the work
// there; what lies between is told as often as there is time for it.
class ToldProgress : public Progress {
 public:
  void begin(std::string_view stage, std::size_t steps) override;
  void advance(std::size_t steps) override;
  void end() override;

  // Calls `callable`(done, total, stage) in this thread until close() was called; the interpreter
  // is let go meanwhile. What it raises sets stop(), and is raised when all is over.
  void tell(const nb::object& callable);
  void close();
  const std::atomic<bool>& stop() const { return stop_; }

 private:
  struct Report {
    std::size_t done = 0, total = 0;
    std::string stage;
    bool awaited = false;  // someone waits until it was told
  };
  void report_and_wait(std::unique_lock<std::mutex>& lock);
  std::optional<Report> next(std::unique_lock<std::mutex>& lock);

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Report> awaited_;
  std::size_t told_ = 0, asked_ = 0;
  Report now_;
  bool moved_ = false, closed_ = false;
  std::atomic<bool> stop_ = false;
};

using Callable = std::optional<nb::object>;  // nanobind takes no None for an nb::object

// work(progress), as without_interpreter() has it. With a callable the work is done in a thread of
// its own, and check_interrupt() breaks it off once the callable has raised.
template <class Work>
auto telling(const Callable& callable, const Work& work) {
  if (!callable) return without_interpreter([&] { return work(silent_progress()); });
  const InterruptWatch watch;
  ToldProgress told;
  std::optional<decltype(work(told))> result;
  std::exception_ptr thrown;
  {
    const std::jthread worker([&] {
      const CallInterrupt of_this_call(&told.stop());
      try {
        result.emplace(until_interrupted([&] { return work(told); }));
      } catch (...) {
        thrown = std::current_exception();
      }
      told.close();
    });
    told.tell(*callable);
  }
  if (thrown) std::rethrow_exception(thrown);
  return *std::move(result);
}

}  // namespace marketgen::python
