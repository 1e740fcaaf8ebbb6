// What a robot reads of itself in a running episode: its joints and tools, and where it believes it
// stands.
//
// What is told is a function of the realism, of the seed, of the truth and of the number of the
// control step; who asks twice is told the same. SI units.
#pragma once
#include "agent/policy.h"
#include "episodes/realism.h"
#include "robots/robot.h"

namespace marketgen::episodes {

// Where the robot believes it is, in the store's frame.
class BelievedPlace {
 public:
  BelievedPlace() = default;
  // It stands at `truth`, and is told that with the first correction's error.
  BelievedPlace(const LocalisationDials& dials,
                Seed seed,
                const robots::BasePlace& truth,
                const robots::BasePlace& reckoned);

  // After a control step, whose number `step` is from 1 on: where its wheels say that it is now,
  // from where it began; and where it is.
  void drive(const robots::BasePlace& reckoned, const robots::BasePlace& truth, int step);
  const robots::BasePlace& told() const { return told_; }

  // What changes; dials and seed it has from its constructor.
  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.told_, self.reckoned_, self.off_);
  }

 private:
  void correct(const robots::BasePlace& truth);

  LocalisationDials dials_;
  Seed seed_{0};
  double distance_ = 1, turn_ = 1;  // reckoned, for 1 that the wheels went
  int steps_between_ = 0;           // corrections; 0: none
  robots::BasePlace told_, reckoned_, off_;
};

// Not thread-safe while it is changed.
class RobotSenses {
 public:
  RobotSenses() = default;
  // `truth` and `reckoned`: where its base is, and where its wheels say so; zeros of a robot that
  // stands still.
  RobotSenses(const Realism& realism,
              Seed seed,
              const robots::Robot& robot,
              const robots::BasePlace& truth,
              const robots::BasePlace& reckoned);

  // Steps of physics after which its drives hear of an action.
  int late_steps() const { return late_steps_; }
  void drive(const robots::BasePlace& reckoned, const robots::BasePlace& truth, int step) {
    place_.drive(reckoned, truth, step);
  }
  // `now`: as its sensors measured it, base.* as its wheels reckon it.
  agent::Observation told(agent::Observation now, int step) const;

  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.place_);
  }

 private:
  JointDials joints_;
  double opening_m_ = 0;  // one sigma
  Seed seed_{0};
  std::vector<bool> slides_;  // by commanded joint
  std::vector<bool> grips_;   // by tool: it has an opening that is read
  bool localises_ = false;    // what its wheels reckon is not all that it is told
  BelievedPlace place_;
  int late_steps_ = 0;
};

}  // namespace marketgen::episodes
