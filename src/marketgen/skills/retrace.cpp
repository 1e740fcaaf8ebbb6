#include "skills/retrace.h"

namespace marketgen::skills {
namespace {

constexpr std::size_t retraced_steps = 20;  // of 0.05 s

}  // namespace

void Retrace::start() {
  told_.clear();
  stopped_ = goes_back_ = false;
}

void Retrace::tell(ToldStep step) {
  told_.push_back(std::move(step));
  if (told_.size() > retraced_steps) told_.pop_front();
}

bool Retrace::begins(const agent::Observation& now) {
  const bool ended = stopped_ && !now.stopped;
  stopped_ = now.stopped;
  if (ended) goes_back_ = true;
  return ended;
}

void Retrace::begin(int steps) {
  while (told_.size() > static_cast<std::size_t>(steps))
    told_.pop_front();
  goes_back_ = true;
}

std::optional<ToldStep> Retrace::back() {
  if (told_.empty()) {
    goes_back_ = false;
    return std::nullopt;
  }
  ToldStep step = std::move(told_.back());
  told_.pop_back();
  step.drive_m_s = -step.drive_m_s;
  step.turn_rad_s = -step.turn_rad_s;
  return step;
}

}  // namespace marketgen::skills
