#include "told_progress.h"

#include <nanobind/stl/string.h>

#include <chrono>

namespace marketgen::python {
namespace {

constexpr std::chrono::milliseconds between_reports{50};

}  // namespace

void ToldProgress::report_and_wait(std::unique_lock<std::mutex>& lock) {
  moved_ = false;
  awaited_.push_back(now_);
  awaited_.back().awaited = true;
  const std::size_t mine = ++asked_;
  changed_.notify_all();
  changed_.wait(lock, [&] { return told_ >= mine || stop_; });
}

void ToldProgress::begin(std::string_view stage, std::size_t steps) {
  std::unique_lock lock(mutex_);
  now_ = {0, steps, std::string(stage)};
  report_and_wait(lock);
}

void ToldProgress::advance(std::size_t steps) {
  const std::scoped_lock lock(mutex_);
  now_.done += steps;
  moved_ = true;
}

void ToldProgress::end() {
  std::unique_lock lock(mutex_);
  now_.done = now_.total;
  report_and_wait(lock);
}

void ToldProgress::close() {
  const std::scoped_lock lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

std::optional<ToldProgress::Report> ToldProgress::next(std::unique_lock<std::mutex>& lock) {
  changed_.wait_for(lock, between_reports, [&] { return !awaited_.empty() || closed_; });
  if (!awaited_.empty()) {
    Report first = std::move(awaited_.front());
    awaited_.pop_front();
    return first;
  }
  if (!moved_ || closed_) return std::nullopt;
  moved_ = false;
  return now_;
}

void ToldProgress::tell(const nb::object& callable) {
  std::exception_ptr raised;
  {
    const nb::gil_scoped_release released;
    std::unique_lock lock(mutex_);
    while (!closed_) {
      const auto report = next(lock);
      if (!report || stop_) continue;
      lock.unlock();
      try {
        const nb::gil_scoped_acquire held;
        callable(report->done, report->total, report->stage);
      } catch (...) {
        raised = std::current_exception();
        stop_ = true;
      }
      lock.lock();
      if (report->awaited) ++told_;
      changed_.notify_all();
    }
  }
  if (raised) std::rethrow_exception(raised);
}

}  // namespace marketgen::python
