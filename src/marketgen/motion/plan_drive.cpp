#include "motion/plan_drive.h"

#include <algorithm>
#include <cmath>

namespace marketgen::motion {
namespace {

// Of the robot's limits: the rest is left to whoever keeps it on its way. A drive planned at the
// limits themselves can never catch up.
constexpr double planned_share = 0.8;

// Beside what the follower stops for: it is not to stop on its way past.
constexpr double beside_past_m = 0.02;

int in_mm(double m) {
  return static_cast<int>(std::lround(m * 1e3));
}

}  // namespace

Result<BaseEnvelope> base_envelope(const robots::Robot& robot, std::span<const double> state) {
  MARKETGEN_CHECK(robots::check_state(robot, state));
  if (!robot.drive)
    return Error{"motion.bad_limits", robot.name, "the robot's row has no drive: it stands still"};
  std::vector<double> q(state.begin(), state.end());
  const robots::JointGroup* base = robot.find_group("base");
  if (base != nullptr) {
    for (const int dof : base->dofs)
      q[static_cast<std::size_t>(dof)] = 0;
  }
  const std::vector<Pose> poses =
      robots::link_poses(robot, robots::with_followers(robot, std::move(q)));
  BaseEnvelope envelope;
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    for (const robots::Capsule& capsule : robot.links[link].capsules) {
      for (const Vec3& end : {capsule.a, capsule.b}) {
        const Vec3 at = poses[link] * end;
        const double away = std::hypot(at.x - robot.drive->axle_x, at.y);
        envelope.radius_m = std::max(envelope.radius_m, away + capsule.radius);
        envelope.height_m = std::max(envelope.height_m, at.z + capsule.radius);
      }
    }
  }
  return envelope;
}

Result<DrivePlan> plan_drive(const navigation::VisibilityGraph& graph,
                             const robots::Robot& robot,
                             std::span<const double> state,
                             const FloorPlace& from,
                             const FloorPlace& to,
                             std::span<const MovingDisc> past) {
  for (const FloorPlace& place : {from, to}) {
    if (!std::isfinite(place.position.x + place.position.y + place.heading))
      return Error{"motion.bad_configuration", "place on the floor", "expected finite numbers"};
  }
  MARKETGEN_TRY(const BaseEnvelope envelope, base_envelope(robot, state));
  MARKETGEN_TRY(BaseLimits limits, base_limits(robot));
  for (double* limit :
       {&limits.speed, &limits.acceleration, &limits.turn_rate, &limits.turn_acceleration})
    *limit *= planned_share;
  BaseOptions options;
  options.base_radius = envelope.radius_m;
  std::vector<navigation::DiscMm> discs;
  for (const MovingDisc& disc : past) {
    const double clear = envelope.radius_m + options.margin + disc.radius + beside_past_m;
    discs.push_back({floor_mm(disc.position), in_mm(clear)});
  }
  MARKETGEN_TRY(navigation::FloorPath path,
                graph.shortest_path_past(floor_mm(from.position), floor_mm(to.position), discs));
  MARKETGEN_TRY(BaseFollower follower,
                BaseFollower::make(path, from.heading, to.heading, limits, options));
  return DrivePlan{std::move(path), std::move(follower)};
}

}  // namespace marketgen::motion
