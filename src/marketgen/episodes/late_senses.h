// What reaches a policy late: pictures, and readings of joints and tools.
//
// Of each control step one moment is kept, so that at its end the one of exactly so many steps of
// physics before is there. Pictures are not taken beforehand: where everything stood is kept, and
// only who asks for a picture has one rendered.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "agent/policy.h"
#include "episodes/aisle/person_moment.h"
#include "episodes/control_step.h"
#include "episodes/realism.h"
#include "geometry/pose.h"

namespace marketgen::episodes {

// Steps of physics, drawn as the dials say.
int drawn_lateness(const LatenessDials& dials, Stream draw);

// Where everything was that pictures show moving. Store frame.
struct Scenery {
  double time_s = 0;
  std::vector<double> robot = {};                             // all degrees of freedom
  std::vector<std::pair<std::uint32_t, Pose>> products = {};  // those that have moved, by row
  std::optional<Pose> basket = {};                            // one that is loose
  std::vector<PersonMoment> people = {};                      // in the aisles

  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.time_s, self.robot, self.products, self.basket, self.people);
  }
};

// Moments as they come, told so many steps of physics later. `first` is told until one after it is
// old enough.
template <class Moment>
class Delayed {
 public:
  Delayed() = default;
  Delayed(int late_steps, Moment first) : late_(late_steps) {
    if (late_ > 0) moments_.push_back(std::move(first));
  }

  // False: what is told is of now. So it is, too, when a moment was restored of one that was not
  // late, until there is something to tell.
  bool is_late() const { return late_ > 0 && !moments_.empty(); }
  // After the `step`-th step of physics of a control step, from 1 on.
  template <class Now>
  void pass(int step, const Now& now) {
    const int count = ControlStep::count(), whole = late_ / count;
    if (late_ == 0 || step != count - late_ % count) return;
    moments_.push_back(now());
    while (moments_.size() > static_cast<std::size_t>(whole) + 1)
      moments_.erase(moments_.begin());
  }
  // At the end of a control step, or before the first one. Precondition: is_late().
  const Moment& told() const { return moments_.front(); }

  // How late it is stays: another one has its own.
  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.moments_);
  }

 private:
  int late_ = 0;
  std::vector<Moment> moments_;  // oldest first
};

// Not thread-safe while it is changed.
class LateSenses {
 public:
  LateSenses() = default;
  LateSenses(const Realism& realism, Seed seed, const agent::Observation& first, Scenery stands);

  // After the `step`-th step of physics of a control step, from 1 on. `now` and `stands` are asked
  // only when what they say is to be kept.
  template <class Now, class Stands>
  void pass(int step, const Now& now, const Stands& stands) {
    readings_.pass(step, [&] { return Readings(now()); });
    vacuum_.pass(step, [&] { return now().sealed; });
    pictures_.pass(step, stands);
  }

  // `now`, with what is read late as it was: time, place of the base and protective stops are
  // now's.
  agent::Observation told(agent::Observation now) const;
  // What cameras show; null: what they see now.
  const Scenery* pictured() const { return pictures_.is_late() ? &pictures_.told() : nullptr; }

  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.readings_, self.vacuum_, self.pictures_);
  }

 private:
  struct Readings {
    Readings() = default;
    explicit Readings(agent::Observation now)
        : position(std::move(now.position)),
          velocity(std::move(now.velocity)),
          openings_m(std::move(now.openings_m)),
          external_force_n(std::move(now.external_force_n)) {}
    std::vector<double> position, velocity, openings_m, external_force_n;
    template <class Archive, class Self>
    static void bytes(Archive& archive, Self& self) {
      archive(self.position, self.velocity, self.openings_m, self.external_force_n);
    }
  };

  Delayed<Readings> readings_;
  Delayed<std::vector<std::uint8_t>> vacuum_;  // Observation::sealed
  Delayed<Scenery> pictures_;
};

}  // namespace marketgen::episodes
