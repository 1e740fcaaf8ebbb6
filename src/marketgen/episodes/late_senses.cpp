#include "episodes/late_senses.h"

#include <cmath>

#include "physics/goods/contact_shape.h"

namespace marketgen::episodes {
namespace {

int physics_steps(double seconds) {
  return static_cast<int>(std::lround(seconds / physics::time_step_s));
}

}  // namespace

int drawn_lateness(const LatenessDials& dials, Stream draw) {
  return physics_steps(draw.uniform(dials.min_s, dials.max_s));
}

LateSenses::LateSenses(const Realism& realism,
                       Seed seed,
                       const agent::Observation& first,
                       Scenery stands) {
  const int readings =
      drawn_lateness(realism.latency.readings, seed.child("latency", "readings").stream());
  readings_ = {readings, Readings(first)};
  vacuum_ = {readings + physics_steps(realism.tools.vacuum_s), first.sealed};
  pictures_ = {drawn_lateness(realism.latency.images, seed.child("latency", "images").stream()),
               std::move(stands)};
}

agent::Observation LateSenses::told(agent::Observation now) const {
  if (readings_.is_late()) {
    const Readings& read = readings_.told();
    now.position = read.position;
    now.velocity = read.velocity;
    now.openings_m = read.openings_m;
    now.external_force_n = read.external_force_n;
  }
  if (vacuum_.is_late()) now.sealed = vacuum_.told();
  return now;
}

}  // namespace marketgen::episodes
