#include "episodes/cup_commands.h"

namespace marketgen::episodes {

Result<void> use_cups(const physics::SuctionActor& cups,
                      physics::World& world,
                      const robots::Robot& robot,
                      const agent::Action& action) {
  for (std::size_t t = 0; t < robot.tools.size(); ++t) {
    const robots::Tool& tool = robot.tools[t];
    if (tool.kind == robots::ToolKind::suction)
      MARKETGEN_CHECK(cups.suck(world, tool, action.tools[t].opening_m == 0));
  }
  return {};
}

SealedProducts sealed_products(const physics::SuctionActor& cups,
                               const physics::World& world,
                               const robots::Robot& robot) {
  SealedProducts sealed;
  for (const robots::Tool& tool : robot.tools)
    sealed.push_back(cups.sealed_product(world, tool));
  return sealed;
}

void see_cups(const physics::SuctionActor& cups,
              const physics::World& world,
              const robots::Robot& robot,
              agent::Observation& seen) {
  for (std::size_t t = 0; t < robot.tools.size(); ++t) {
    const robots::Tool& tool = robot.tools[t];
    const bool off = tool.kind == robots::ToolKind::suction && !cups.sucks(world, tool);
    if (off) seen.openings_m[t] = agent::cup_off_m;
    seen.sealed.push_back(cups.sealed_product(world, tool).has_value());
  }
}

void turn_cups_off(const robots::Robot& robot, agent::Action& action) {
  for (std::size_t t = 0; t < robot.tools.size(); ++t)
    if (robot.tools[t].kind == robots::ToolKind::suction)
      action.tools[t].opening_m = agent::cup_off_m;
}

}  // namespace marketgen::episodes
