#include "episodes/robot_senses.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "episodes/late_senses.h"
#include "episodes/track_world.h"

namespace marketgen::episodes {
namespace {

constexpr double rad_of_deg = std::numbers::pi / 180;

robots::BasePlace drawn_place(Stream draw, double off_m, double off_rad) {
  robots::BasePlace off;
  off.x_m = off_m * draw.normal();
  off.y_m = off_m * draw.normal();
  off.heading = off_rad * draw.normal();
  return off;
}

}  // namespace

BelievedPlace::BelievedPlace(const LocalisationDials& dials,
                             Seed seed,
                             const robots::BasePlace& truth,
                             const robots::BasePlace& reckoned)
    : dials_(dials), seed_(seed), told_(truth), reckoned_(reckoned) {
  Stream draw = seed_.child("odometry").stream();
  distance_ = 1 + dials.distance_share * draw.normal();
  turn_ = 1 + dials.turn_share * draw.normal();
  if (dials.period_s > 0)
    steps_between_ =
        std::max(1, static_cast<int>(std::ceil(dials.period_s / control_step_s - 1e-9)));
  off_ =
      drawn_place(seed_.child("correction", 0).stream(), dials.off_m, dials.off_deg * rad_of_deg);
  correct(truth);
}

void BelievedPlace::correct(const robots::BasePlace& truth) {
  told_ = {truth.x_m + off_.x_m, truth.y_m + off_.y_m, truth.heading + off_.heading};
}

// A first-order Gauss-Markov process: off by as much in the mean at any time.
void BelievedPlace::drive(const robots::BasePlace& reckoned,
                          const robots::BasePlace& truth,
                          int step) {
  const double dx = reckoned.x_m - reckoned_.x_m, dy = reckoned.y_m - reckoned_.y_m;
  const double turned = told_.heading - reckoned_.heading;
  const double cosine = std::cos(turned), sine = std::sin(turned);
  told_.x_m += distance_ * (cosine * dx - sine * dy);
  told_.y_m += distance_ * (sine * dx + cosine * dy);
  told_.heading += turn_ * (reckoned.heading - reckoned_.heading);
  reckoned_ = reckoned;
  if (steps_between_ == 0 || step % steps_between_ != 0) return;
  const double keeps = std::exp(-steps_between_ * control_step_s / dials_.memory_s);
  const double fresh = std::sqrt(1 - keeps * keeps);
  const robots::BasePlace drawn =
      drawn_place(seed_.child("correction", static_cast<std::uint64_t>(step)).stream(),
                  dials_.off_m,
                  dials_.off_deg * rad_of_deg);
  off_ = {keeps * off_.x_m + fresh * drawn.x_m,
          keeps * off_.y_m + fresh * drawn.y_m,
          keeps * off_.heading + fresh * drawn.heading};
  correct(truth);
}

RobotSenses::RobotSenses(const Realism& realism,
                         Seed seed,
                         const robots::Robot& robot,
                         const robots::BasePlace& truth,
                         const robots::BasePlace& reckoned)
    : joints_(realism.joints),
      opening_m_(realism.tools.opening_m),
      seed_(seed),
      place_(realism.localisation, seed.child("localisation"), truth, reckoned) {
  for (const int dof : commanded_dofs(robot))
    slides_.push_back(robot.joint_of_dof(static_cast<std::size_t>(dof)).kind ==
                      robots::JointType::prismatic);
  for (const robots::Tool& tool : robot.tools)
    grips_.push_back(tool.kind != robots::ToolKind::suction);
  const LocalisationDials& dials = realism.localisation;
  localises_ =
      robot.drive.has_value() && (dials.distance_share > 0 || dials.turn_share > 0 ||
                                  dials.period_s > 0 || dials.off_m > 0 || dials.off_deg > 0);
  late_steps_ = drawn_lateness(realism.latency.commands, seed_.child("latency").stream());
}

agent::Observation RobotSenses::told(agent::Observation now, int step) const {
  Stream draw = seed_.child("joints", static_cast<std::uint64_t>(step)).stream();
  for (std::size_t j = 0; j < now.position.size(); ++j) {
    const double place = slides_[j] ? joints_.slide_m : joints_.turn_deg * rad_of_deg;
    const double speed = slides_[j] ? joints_.slide_m_s : joints_.turn_deg_s * rad_of_deg;
    if (place > 0) now.position[j] += place * draw.normal();
    if (speed > 0) now.velocity[j] += speed * draw.normal();
  }
  Stream of_tools = seed_.child("tools", static_cast<std::uint64_t>(step)).stream();
  for (std::size_t t = 0; opening_m_ > 0 && t < now.openings_m.size(); ++t)
    if (grips_[t])
      now.openings_m[t] = std::max(0.0, now.openings_m[t] + opening_m_ * of_tools.normal());
  Stream of_force = seed_.child("external_force", static_cast<std::uint64_t>(step)).stream();
  for (double& force : now.external_force_n)
    if (joints_.external_force_n > 0)
      force = std::max(0.0, force + joints_.external_force_n * of_force.normal());
  if (localises_) now.base = place_.told();
  return now;
}

}  // namespace marketgen::episodes
