// The suction cups of a robot in a World.
//
// robot_cups() is for WorldOptions::cups, beside add_robot(). Afterwards a SuctionActor turns the
// cups on and off and says what they hold.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "physics/goods/contact_shape.h"
#include "physics/world/robot_actor.h"

namespace marketgen::physics {

// One for each suction tool, in the order of the robot's tools.
std::vector<WorldCup> robot_cups(const robots::Robot& robot, const RobotActorOptions& options);

// What a link that carries a cup touches with, in its frame; none for other links. The lip itself
// touches nothing: solids end where a face that it seals on cannot be.
std::vector<assets::ContactShape> cup_solids(const robots::Robot& robot, std::size_t link);

class SuctionActor {
 public:
  // A robot without cups has an actor, too. Error physics.bad_command: the world lacks one of
  // robot_cups().
  static Result<SuctionActor> find(const World& world,
                                   const robots::Robot& robot,
                                   const std::string& prefix = {});

  // As World::suck; stays until told otherwise. Error physics.bad_command: the tool is no cup of
  // this robot.
  Result<void> suck(World& world, const robots::Tool& tool, bool on) const;
  // False and nothing for what is no cup.
  bool sucks(const World& world, const robots::Tool& tool) const;
  std::optional<std::uint32_t> sealed_product(const World& world, const robots::Tool& tool) const;

 private:
  std::optional<std::uint32_t> cup_of(const robots::Tool& tool) const;

  std::map<std::string, std::uint32_t> cups_;  // by the tool's prefix: row of the World's
};

}  // namespace marketgen::physics
