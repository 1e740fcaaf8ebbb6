#include "episodes/recorded_view.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace marketgen::episodes {
namespace {

// The last row that is not after the step; nothing: there is none yet.
std::optional<std::size_t> row_at(const std::vector<std::uint32_t>& steps, std::size_t step) {
  const auto after = std::ranges::upper_bound(steps, step);
  if (after == steps.begin()) return std::nullopt;
  return static_cast<std::size_t>(after - steps.begin()) - 1;
}

Pose pose_in(const ThingMotion& thing, std::size_t row) {
  const float* p = &thing.poses[row * pose_numbers];
  const double size = std::hypot(std::hypot(p[3], p[4]), std::hypot(p[5], p[6]));
  return {{p[0], p[1], p[2]}, {p[3] / size, p[4] / size, p[5] / size, p[6] / size}};
}

}  // namespace

Scenery scenery_at(const Motion& motion, std::size_t step, std::uint32_t first_item) {
  Scenery then;
  then.time_s = static_cast<double>(step) * motion.step_s;
  const auto from = motion.states.begin() + static_cast<std::ptrdiff_t>(step * motion.dofs.size());
  then.robot.assign(from, from + static_cast<std::ptrdiff_t>(motion.dofs.size()));
  for (const ThingMotion& thing : motion.things) {
    const std::optional<std::size_t> row = row_at(thing.steps, step);
    if (!row) continue;
    const Pose pose = pose_in(thing, *row);
    if (thing.kind == ThingKind::basket)
      then.basket = pose;
    else
      then.products.emplace_back(
          thing.kind == ThingKind::item ? first_item + thing.number : thing.number, pose);
  }
  return then;
}

std::vector<render::MovedJoint> joints_at(const Motion& motion, std::size_t step) {
  std::vector<render::MovedJoint> joints;
  for (const JointMotion& joint : motion.joints)
    if (const std::optional<std::size_t> row = row_at(joint.steps, step))
      joints.push_back({joint.joint, joint.positions[*row]});
  return joints;
}

}  // namespace marketgen::episodes
