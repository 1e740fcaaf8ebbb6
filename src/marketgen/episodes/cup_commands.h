// The suction cups of a track's robot: told what an action says, and what of them is seen.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "agent/policy.h"
#include "physics/world/suction_actor.h"

namespace marketgen::episodes {

using SealedProducts = std::vector<std::optional<std::uint32_t>>;  // one a tool

// Before every step of physics. Errors: those of SuctionActor::suck.
Result<void> use_cups(const physics::SuctionActor& cups,
                      physics::World& world,
                      const robots::Robot& robot,
                      const agent::Action& action);

SealedProducts sealed_products(const physics::SuctionActor& cups,
                               const physics::World& world,
                               const robots::Robot& robot);

// Whether each tool has sealed, and the openings of cups; those of grippers are there.
void see_cups(const physics::SuctionActor& cups,
              const physics::World& world,
              const robots::Robot& robot,
              agent::Observation& seen);

// At the agent's stop cups let go.
void turn_cups_off(const robots::Robot& robot, agent::Action& action);

}  // namespace marketgen::episodes
