// Lifts the highest thing out of a basket and puts it on the area where goods go, as often as there
// are goods to be brought. It sees heights alone, knows no product and never reads what is asked
// for: what it scores is chance (policy/floor_policies.h).
#pragma once
#include <memory>

#include "agent/eyes.h"
#include "agent/policy.h"
#include "agent/workplace.h"
#include "base/seed.h"
#include "robots/grasp_tool.h"
#include "robots/robot.h"

namespace marketgen::policy {

// What the agent is given. Eyes and robot must outlive the policy.
struct HighestFirstSetup {
  agent::Eyes* eyes = nullptr;
  const robots::Robot* robot = nullptr;
  robots::GraspTool tool;
  agent::Workplace place;
};

// The points of the topmost thing in the basket: those about the highest point, none far below it;
// empty when nothing rises over the floor. Points and answer: base frame, metres. Points near one
// of `left_alone` are passed over.
std::vector<Vec3f> highest_patch(const std::vector<Vec3f>& points,
                                 const agent::Workplace& place,
                                 const std::vector<Vec3>& left_alone);

// Errors: those of ArmExecutor.
Result<std::unique_ptr<agent::Policy>> make_highest_first(HighestFirstSetup setup, Seed seed);

}  // namespace marketgen::policy
