// The stages in which a store is made: each timed, told to the progress, and a place where Ctrl-C
// is heard.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "base/interrupt.h"
#include "base/progress.h"
#include "store/store.h"

namespace marketgen::store {

class Stages {
 public:
  // `before`: what has been done already.
  explicit Stages(Progress& progress, std::vector<StageTiming> before = {})
      : progress_(progress), timings_(std::move(before)) {}

  template <class Work>
  auto run(std::string name, const Work& work) -> decltype(work()) {
    MARKETGEN_CHECK(check_interrupt());
    progress_.begin(name, 1);
    const double start = monotonic_seconds();
    auto result = work();
    timings_.push_back({std::move(name), monotonic_seconds() - start});
    progress_.end();
    return result;
  }
  std::vector<StageTiming> take() { return std::move(timings_); }

 private:
  Progress& progress_;
  std::vector<StageTiming> timings_;
};

}  // namespace marketgen::store
