// The modular system without learned weights, in a store: it drives to where the map and the
// category's place say that a product may be, looks along the shelves, finds it by its pictures and
// shape in the catalogue, takes it off its board and lets it down into its basket. It knows what a
// robot in that store knows and nothing of the simulation (tools/check_layers).
#pragma once
#include <memory>
#include <vector>

#include "agent/aisle_map.h"
#include "agent/eyes.h"
#include "agent/known_products.h"
#include "agent/policy.h"
#include "perception/goal_reader.h"
#include "perception/look_library.h"
#include "perception/shelf_choice.h"
#include "perception/shelf_grasps.h"
#include "policy/aisle_body.h"
#include "robots/grasp_tool.h"

namespace marketgen::policy {

// Its modules; each may be another.
struct ClassicalAisleModules {
  std::unique_ptr<perception::GoalReader> language;
  std::unique_ptr<perception::SpotSource> spots;
  std::unique_ptr<perception::ShelfChoice> choice;
  std::unique_ptr<perception::ShelfGraspSource> grasps;
};

// What the agent is given. Eyes, catalogue, its looks, map and robot must outlive the policy.
// Modules that are null are its own: SweptSpots, UprightMatching, FrontGrasps. Without `language`
// goals must be told by SKU.
struct ClassicalAisleSetup {
  agent::Eyes* eyes = nullptr;  // "head_camera"; base frame: that of the robot's base
  agent::KnownProducts* products = nullptr;
  perception::LookLibrary* looks = nullptr;
  robots::GraspTool tool;
  std::vector<agent::CategoryHint> hints;
  AisleBodySetup body;
  ClassicalAisleModules modules = {};
};

std::unique_ptr<agent::Policy> make_classical_aisle(ClassicalAisleSetup setup, Seed seed);

}  // namespace marketgen::policy
