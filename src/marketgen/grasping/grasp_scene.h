// The MuJoCo model of a grasp trial: table or shelf, the product, its neighbours and the tool.
#pragma once
#include <vector>

#include "grasping/grasp_trial.h"
#include "physics/mujoco_guard.h"
#include "physics/world/cup_lip.h"

namespace marketgen::grasping {

enum class GraspOwner { still, product, pad, tool };

struct GraspScene {
  physics::MujocoModel model{nullptr, mj_deleteModel};
  std::vector<GraspOwner> owners;  // of each geom
  std::vector<int> owner_index;    // of each geom: which product (0 is the target), which finger
  std::vector<int> products;       // bodies; the target first
  std::vector<int> target;         // its bodies: of a soft pack base, top and flap
  Vec3 target_origin;              // of the first of them, product frame
  int tool_body = 0;               // its orientation may be set in the model
  int base_dof = 0;                // first of three slides along the world's axes
  int finger_dof = -1;             // first of two slides, positive apart; -1: a cup
  physics::LipPoints lip{-1, -1, -1};  // of a cup
  std::vector<int> product_geoms;      // of all products, for rays
  double headroom_m = 0;               // over the product; 0 = none above
};

// Errors: those of try_grasp.
Result<GraspScene> grasp_scene(const GraspTrial& trial);

}  // namespace marketgen::grasping
