#include "physics/world/suction_actor.h"

#include <algorithm>
#include <cmath>

#include "physics/world/cup_lip.h"
#include "robots/grasp_tool.h"

namespace marketgen::physics {
namespace {

constexpr double along_z = 1 - 1e-6;  // cosine

const robots::RobotFrame& lip_frame(const robots::Robot& robot, const robots::Tool& tool) {
  return robot.frames[static_cast<std::size_t>(tool.frame)];
}

std::string cup_body(const robots::Robot& robot,
                     const robots::Tool& tool,
                     const std::string& prefix) {
  return prefix + robot.links[static_cast<std::size_t>(lip_frame(robot, tool).link)].name;
}

// What of a solid lies behind `end_z`: one along Z is cut there, another is left out if it reaches
// further.
std::optional<robots::ToolSolid> behind(robots::ToolSolid solid, double end_z) {
  const double low = solid.tool_from_solid.position.z - solid.half_size.z,
               high = solid.tool_from_solid.position.z + solid.half_size.z;
  if (high <= end_z) return solid;
  const bool along = rotate(solid.tool_from_solid.rotation, {0, 0, 1}).z > along_z;
  if (!along || low >= end_z) return std::nullopt;
  solid.tool_from_solid.position.z = (low + end_z) / 2;
  solid.half_size.z = (end_z - low) / 2;
  return solid;
}

}  // namespace

std::vector<WorldCup> robot_cups(const robots::Robot& robot, const RobotActorOptions& options) {
  std::vector<WorldCup> cups;
  for (const robots::Tool& tool : robot.tools) {
    if (tool.kind != robots::ToolKind::suction) continue;
    cups.push_back({cup_body(robot, tool, options.prefix),
                    lip_frame(robot, tool).link_from_frame,
                    tool.cup_radius,
                    tool.seal_depth,
                    tool.force,
                    options.finger_material});
  }
  return cups;
}

std::vector<assets::ContactShape> cup_solids(const robots::Robot& robot, std::size_t link) {
  std::vector<assets::ContactShape> shapes;
  for (const robots::Tool& tool : robot.tools) {
    const robots::RobotFrame& lip = lip_frame(robot, tool);
    if (tool.kind != robots::ToolKind::suction || static_cast<std::size_t>(lip.link) != link)
      continue;
    const double end_z = -(bellows_stroke_m + tool.seal_depth);
    for (const robots::ToolSolid& whole :
         robots::solids_of(robot.links[link], inverse(lip.link_from_frame))) {
      const std::optional<robots::ToolSolid> solid = behind(whole, end_z);
      if (!solid) continue;
      const Vec3& h = solid->half_size;
      shapes.push_back(
          {solid->round ? assets::CollisionShape::cylinder : assets::CollisionShape::box,
           lip.link_from_frame * solid->tool_from_solid,
           solid->round ? Vec3{h.x, h.z, 0} : h});
    }
  }
  return shapes;
}

Result<SuctionActor> SuctionActor::find(const World& world,
                                        const robots::Robot& robot,
                                        const std::string& prefix) {
  SuctionActor actor;
  for (const robots::Tool& tool : robot.tools) {
    if (tool.kind != robots::ToolKind::suction) continue;
    MARKETGEN_TRY(const std::uint32_t cup, world.cup(cup_body(robot, tool, prefix)));
    actor.cups_.emplace(tool.prefix, cup);
  }
  return actor;
}

std::optional<std::uint32_t> SuctionActor::cup_of(const robots::Tool& tool) const {
  const auto found = cups_.find(tool.prefix);
  return found == cups_.end() ? std::nullopt : std::optional(found->second);
}

Result<void> SuctionActor::suck(World& world, const robots::Tool& tool, bool on) const {
  const auto cup = cup_of(tool);
  if (!cup)
    return Error{"physics.bad_command", tool.prefix + tool.row, "the tool is no suction cup"};
  if (world.sucks(*cup) == on) return {};
  return world.suck(*cup, on);
}

bool SuctionActor::sucks(const World& world, const robots::Tool& tool) const {
  const auto cup = cup_of(tool);
  return cup && world.sucks(*cup);
}

std::optional<std::uint32_t> SuctionActor::sealed_product(const World& world,
                                                          const robots::Tool& tool) const {
  const auto cup = cup_of(tool);
  return cup ? world.sealed_product(*cup) : std::nullopt;
}

}  // namespace marketgen::physics
