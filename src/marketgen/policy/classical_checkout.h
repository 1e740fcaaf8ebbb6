// The modular system without learned weights: it looks, finds what it is asked for by its pictures
// and shape in the catalogue, takes hold of it where the hand has room, puts it down where there is
// room, and looks again. It knows what a robot at that counter knows and nothing of the simulation
// (tools/check_layers).
#pragma once
#include <memory>

#include "agent/eyes.h"
#include "agent/known_products.h"
#include "agent/policy.h"
#include "agent/workplace.h"
#include "base/seed.h"
#include "perception/goal_reader.h"
#include "perception/grasp_source.h"
#include "perception/look_library.h"
#include "perception/target_choice.h"
#include "robots/grasp_tool.h"
#include "robots/robot.h"

namespace marketgen::policy {

// Its modules; each may be another.
struct ClassicalModules {
  std::unique_ptr<perception::GoalReader> language;
  std::unique_ptr<perception::MaskSource> masks;
  std::unique_ptr<perception::PoseSource> poses;
  std::unique_ptr<perception::TargetChoice> targets;
  std::unique_ptr<perception::GraspSource> grasps;
};

// What the agent is given. Eyes, catalogue, its looks and robot must outlive the policy. Modules
// that are null are its own: GeometricMasks, SweptPoses, CatalogueMatching, FittedGrasps. Without
// `language` goals must be told by SKU.
struct ClassicalSetup {
  agent::Eyes* eyes = nullptr;
  agent::KnownProducts* products = nullptr;
  perception::LookLibrary* looks = nullptr;
  const robots::Robot* robot = nullptr;
  robots::GraspTool tool;
  agent::Workplace place;
  ClassicalModules modules = {};
};

// Errors: those of ArmExecutor.
Result<std::unique_ptr<agent::Policy>> make_classical_checkout(ClassicalSetup setup, Seed seed);

}  // namespace marketgen::policy
