// Backing off after a protective stop: the last second of what a robot was told, backwards; after a
// contact that was waited for, less. What it came past without touching it, it gets back past.
#pragma once
#include <deque>
#include <optional>
#include <vector>

#include "agent/policy.h"

namespace marketgen::skills {

// One control step, as it was told.
struct ToldStep {
  std::vector<double> position;          // as in Action
  double drive_m_s = 0, turn_rad_s = 0;  // of the base
};

class Retrace {
 public:
  void start();              // forgets everything
  void tell(ToldStep step);  // of a motion that goes on
  // Whether a stop has just ended: then begins to go back. While the robot is stopped, no motion
  // may be told.
  bool begins(const agent::Observation& now);
  void begin(int steps);  // goes back so many from now on
  bool goes_back() const { return goes_back_; }
  // The next step back, its base the other way; empty when all is gone back.
  std::optional<ToldStep> back();

 private:
  std::deque<ToldStep> told_;
  bool stopped_ = false, goes_back_ = false;
};

}  // namespace marketgen::skills
