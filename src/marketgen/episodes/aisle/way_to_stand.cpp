#include "episodes/aisle/way_to_stand.h"

#include "agent/aisle_map.h"
#include "episodes/aisle/aisle_stage.h"
#include "episodes/aisle/aisle_world.h"

namespace marketgen::episodes {

Result<WayToStand> way_to_stand(const AisleWorld& world) {
  MARKETGEN_TRY(const WitnessPick pick, witness_of(world.spec()));
  const AisleStore& store = world.store();
  const Pose base = world.world_from_base(), stand = base_pose_of(pick.base);
  const Vec3 from = axle_of(store.robot, base), to = axle_of(store.robot, stand);
  WayToStand way;
  Vec3 corner = to;
  way.way_m = length(to - from);
  const auto path = store.ways.shortest_path(floor_mm(from), floor_mm(to));
  if (path.ok() && path->points.size() > 2) {
    corner = {path->points[1][0] * 1e-3, path->points[1][1] * 1e-3, 0};
    way.way_m = path->length_m;
  }
  const Quaternion base_from_world = inverse(base.rotation);
  way.corner = rotate(base_from_world, corner - from);
  way.stand = agent::base_place(inverse(base) * stand);
  const std::vector<double> v = world.controller().actor().velocity(world.world());
  const auto speed = [&](std::string_view dof) {
    return v[static_cast<std::size_t>(store.robot.find_dof(dof))];
  };
  way.speed_m_s = rotate(base_from_world, {speed("base_x"), speed("base_y"), 0}).x;
  way.turn_rad_s = speed("base_yaw");
  return way;
}

}  // namespace marketgen::episodes
