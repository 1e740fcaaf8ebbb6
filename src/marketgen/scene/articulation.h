// Where a store's moving parts are once its joints are not at rest.
//
// Scene::parts stand with every joint at position 0. A position is in radians for a hinge, metres
// for a slide, metres per second for a belt, whose parts stand still.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "scene/scene.h"

namespace marketgen::scene {

Pose fixture_from_joint(const SceneJoint& joint);  // at position 0

// "FIXTURE/JOINT", unique in the store.
std::string joint_id(const Scene& scene, const SceneJoint& joint);

// How the mass of what a joint moves is spread over its parts (rows of Scene::parts): by volume,
// in kg, in the order of `parts`.
std::vector<double> masses_of(const Scene& scene,
                              const SceneJoint& joint,
                              const std::vector<std::uint32_t>& parts);

// How far each joint has carried what is on it, in its fixture's frame: by row of Scene::joints,
// the identity where nothing moved. `positions` has one entry a row.
std::vector<Pose> joint_motions(const Scene& scene, const std::vector<double>& positions);

// The scene with its parts moved; goods stay where they are.
Scene scene_at(Scene scene, const std::vector<double>& positions);

// A position from what a person writes: the name of a state, or a number within the limits.
// Error: usage.bad_flag.
Result<double> joint_position(const SceneJoint& joint, std::string_view text);

}  // namespace marketgen::scene
