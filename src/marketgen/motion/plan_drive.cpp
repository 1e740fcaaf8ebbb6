#include "motion/plan_drive.h"

#include <algorithm>
#include <cmath>

#include "geometry/box_extents.h"
#include "layout/layout.h"
#include "plan/plan.h"

namespace marketgen {
namespace {

// Of the robot's limits: the rest is left to whoever keeps it on its way. A drive planned at the
// limits themselves can never catch up.
constexpr double planned_share = 0.8;

int in_mm(double m) {
  return static_cast<int>(std::lround(m * 1e3));
}

// Over the floor, of the lowest corner of any of the fixture's parts.
double underside_m(const Scene& scene, std::uint32_t fixture) {
  const SceneFixture& row = scene.fixtures[fixture];
  double low = 1e9;
  for (std::uint32_t p = row.first_part; p < row.first_part + row.part_count; ++p) {
    const ScenePart& part = scene.parts[p];
    const Pose pose = world_from_fixture(scene, fixture) * fixture_from_part(part);
    const auto& [x, y, z] = part.half_size_m;
    low = std::min(low, pose.position.z - box_half_extents(pose.rotation, {x, y, z}).z);
  }
  return low;
}

std::vector<RectMm> obstacles_below(const Scene& scene, double height_m) {
  std::vector<RectMm> obstacles;
  for (std::uint32_t f = 0; f < scene.fixtures.size(); ++f) {
    if (underside_m(scene, f) < height_m)
      obstacles.push_back(footprint_of(scene.layout.fixtures[f]));
  }
  for (const Column& column : scene.layout.shell.columns)
    obstacles.push_back(footprint_of(column));
  return obstacles;
}

}  // namespace

Result<BaseEnvelope> base_envelope(const Robot& robot, std::span<const double> state) {
  MARKETGEN_CHECK(check_state(robot, state));
  if (!robot.drive)
    return Error{"motion.bad_limits", robot.name, "the robot's row has no drive: it stands still"};
  std::vector<double> q(state.begin(), state.end());
  const JointGroup* base = robot.find_group("base");
  if (base != nullptr) {
    for (const int dof : base->dofs)
      q[static_cast<std::size_t>(dof)] = 0;
  }
  const std::vector<Pose> poses = link_poses(robot, with_followers(robot, std::move(q)));
  BaseEnvelope envelope;
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    for (const Capsule& capsule : robot.links[link].capsules) {
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

Result<VisibilityGraph> drive_graph(const Scene& scene,
                                    const BaseEnvelope& envelope,
                                    double margin_m) {
  return VisibilityGraph::make(floor_of(scene.layout.shell),
                               obstacles_below(scene, envelope.height_m),
                               in_mm(envelope.radius_m + margin_m));
}

Result<DrivePlan> plan_drive(const VisibilityGraph& graph,
                             const Robot& robot,
                             std::span<const double> state,
                             const FloorPlace& from,
                             const FloorPlace& to) {
  for (const FloorPlace& place : {from, to}) {
    if (!std::isfinite(place.position.x + place.position.y + place.heading))
      return Error{"motion.bad_configuration", "place on the floor", "expected finite numbers"};
  }
  MARKETGEN_TRY(const BaseEnvelope envelope, base_envelope(robot, state));
  MARKETGEN_TRY(BaseLimits limits, base_limits(robot));
  for (double* limit :
       {&limits.speed, &limits.acceleration, &limits.turn_rate, &limits.turn_acceleration})
    *limit *= planned_share;
  MARKETGEN_TRY(FloorPath path,
                graph.shortest_path({in_mm(from.position.x), in_mm(from.position.y)},
                                    {in_mm(to.position.x), in_mm(to.position.y)}));
  BaseOptions options;
  options.base_radius = envelope.radius_m;
  MARKETGEN_TRY(BaseFollower follower,
                BaseFollower::make(path, from.heading, to.heading, limits, options));
  return DrivePlan{std::move(path), std::move(follower)};
}

}  // namespace marketgen
