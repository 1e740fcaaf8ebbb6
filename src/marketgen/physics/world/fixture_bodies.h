// Fixtures in a MuJoCo specification: what stands still as still geoms, what a joint moves as
// bodies with a hinge or a slide.
//
// A body's frame is its joint's. A joint that closes itself pulls with k x (1 - (x / h)^2), as in
// export/mjcf_fixtures.h. Belts are still geoms whose surface can be given a velocity.
// Fixtures never touch one another, only goods and actors: their parts overlap by design (0.5 mm).
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "physics/mujoco_guard.h"
#include "physics/world/still_geoms.h"
#include "scene/scene.h"

namespace marketgen::physics {

// MuJoCo's contact bits. A pair meets when one's type is among the other's affinities. Goods that
// stand still have no type: they meet moving goods and actors, but no drawer or door. Those must
// not rub on what stands for ever; the World wakes what they reach. Actors have MuJoCo's defaults,
// 1 and 1, but for a gripper's pads: the balls of a pad (physics/world/pad_balls.h) meet goods
// only, its box all but goods.
constexpr int actor_contact_type = 1, goods_contact_type = 8, furniture_contact_type = 2;
constexpr int still_goods_contact_type = 0, moving_furniture_contact_type = 4;
constexpr int goods_affinity = actor_contact_type | goods_contact_type | furniture_contact_type;
constexpr int furniture_affinity = actor_contact_type | goods_contact_type;
constexpr int pad_ball_contact_type = furniture_contact_type, pad_ball_affinity = 0;
constexpr int pad_box_contact_type = 0, pad_box_affinity = actor_contact_type |
                                                           furniture_contact_type |
                                                           moving_furniture_contact_type;

// A geom of the specification and what it stands for.
struct FixtureGeom {
  mjsGeom* geom = nullptr;
  std::uint32_t part = 0;
};
struct FixtureJointElement {
  mjsJoint* joint = nullptr;  // null for a belt and for a joint that is not in the model
};

struct FixtureElements {
  std::vector<FixtureGeom> geoms;
  std::vector<FixtureJointElement> joints;  // by row of Scene::joints
};

// Adds the parts for which `wanted` holds (by row in parts), those of one joint together: a joint
// moves when all its parts are wanted and `articulated`, otherwise they stand still.
FixtureElements add_fixtures(mjsBody* world,
                             StillGeoms& still,
                             const scene::Scene& scene,
                             const std::function<bool(std::uint32_t)>& wanted,
                             bool articulated);

}  // namespace marketgen::physics
