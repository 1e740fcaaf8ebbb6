// Free bodies let go in turns in a MuJoCo model, and stepped until they rest: what heaps and bulk
// settling share.
#pragma once
#include <string>
#include <vector>

#include "base/result.h"
#include "base/seed.h"
#include "geometry/pose.h"
#include "physics/mujoco_guard.h"

namespace marketgen::physics {

// Any way round.
Quaternion any_rotation(Stream& draw);

struct PouredBody {
  int turn = 0;         // when it is let go; until then it is held where the model has it
  double radius_m = 0;  // at which its turning counts as speed
};

struct PourRules {
  // The next turn begins when this time has passed and all that was let go rests, or at the latest.
  double min_pause_s = 0.5, max_pause_s = 0.5;
  double settle_s = 1;     // after the last turn began, at least
  double longest_s = 4;    // in all
  double rest_m_s = 0.01;  // what is slower rests,
  int rest_steps = 1;      // when it was slower for so many steps
};

// The bodies are the first of the model after its world, each with a free joint, in their order.
class Pour {
 public:
  Pour(const mjModel& model, mjData& data, std::vector<PouredBody> bodies, const PourRules& rules);

  bool over() const;  // all rest, or the time is up
  // Errors: physics.failed, naming `where`.
  Result<void> step(const std::string& where);

  int turn() const { return turn_; }  // the last that has begun
  bool poured(std::size_t body) const { return bodies_[body].turn <= turn_; }
  // Held from now on where the model has it.
  void take_away(std::size_t body);

  bool rests() const { return still_steps_ >= rules_.rest_steps; }
  double fastest() const;  // m/s, of what was let go
  double time() const { return data_.time; }

 private:
  void begin_turns();
  void hold() const;

  const mjModel& model_;
  mjData& data_;
  std::vector<PouredBody> bodies_;
  PourRules rules_;
  int turn_ = 0, last_turn_ = 0, steps_ = 0, still_steps_ = 0;
  double turn_began_s_ = 0;
};

}  // namespace marketgen::physics
