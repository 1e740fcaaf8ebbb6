// Parallel loops whose results do not depend on the thread count: every index writes its own slot,
// nothing is reduced in arrival order. Built on oneTBB; every participating thread runs with FTZ
// and DAZ set, the caller's included.
#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <type_traits>
#include <vector>

namespace marketgen {

// Calls body(i) for i in 0..count-1, in any order, on up to the allowed number of threads. `grain`
// indices run as one piece of work. Throws Interrupted (base/interrupt.h), as the body may.
void parallel_for(std::size_t count,
                  const std::function<void(std::size_t)>& body,
                  std::size_t grain = 1);

// results[i] = make(i), in index order. Result types must be default-constructible.
template <class Make>
auto parallel_map(std::size_t count, const Make& make, std::size_t grain = 1) {
  std::vector<std::invoke_result_t<Make, std::size_t>> results(count);
  parallel_for(
      count, [&](std::size_t i) { results[i] = make(i); }, grain);
  return results;
}

// While it lives, at most `threads` threads work (0 = as many as there are cores).
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Control;
  std::unique_ptr<Control> control_;
};

int thread_count();  // threads that may work now

}  // namespace marketgen
