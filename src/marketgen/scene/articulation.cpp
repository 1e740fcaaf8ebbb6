#include "scene/articulation.h"

#include <fmt/format.h>

#include <charconv>
#include <numbers>
#include <string>
#include <utility>

namespace marketgen::scene {
namespace {

double volume_of(const ScenePart& part) {
  const double x = part.half_size_m[0], y = part.half_size_m[1], z = part.half_size_m[2];
  return part.shape == assets::PartShape::box ? 8 * x * y * z : 2 * std::numbers::pi * x * x * z;
}

// The motion in the joint's own frame.
Pose own_motion(const SceneJoint& joint, double position) {
  switch (joint.kind) {
    case assets::JointKind::hinge:
      return {{}, rotation_about({0, 0, 1}, position)};
    case assets::JointKind::slide:
      return {{0, 0, position}, {}};
    case assets::JointKind::belt:
      break;
  }
  return {};
}

void move_part(ScenePart& part, const Pose& motion) {
  const Pose moved = motion * fixture_from_part(part);
  const Vec3& p = moved.position;
  const Quaternion& q = moved.rotation;
  part.position_m = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  part.rotation_wxyz = {static_cast<float>(q.w),
                        static_cast<float>(q.x),
                        static_cast<float>(q.y),
                        static_cast<float>(q.z)};
}

std::string states_text(const SceneJoint& joint) {
  std::string text;
  for (const assets::JointState& state : joint.states)
    text += fmt::format("{}{} ({:.4g})", text.empty() ? "" : ", ", state.name, state.position);
  return text;
}

}  // namespace

Pose fixture_from_joint(const SceneJoint& joint) {
  const auto& p = joint.position_m;
  const auto& q = joint.rotation_wxyz;
  return {{p[0], p[1], p[2]}, {q[0], q[1], q[2], q[3]}};
}

std::string joint_id(const Scene& scene, const SceneJoint& joint) {
  return scene.layout.fixtures[joint.fixture].id + "/" + joint.name;
}

std::vector<double> masses_of(const Scene& scene,
                              const SceneJoint& joint,
                              const std::vector<std::uint32_t>& parts) {
  std::vector<double> masses;
  double total = 0;
  for (const std::uint32_t part : parts) {
    masses.push_back(volume_of(scene.parts[part]));
    total += masses.back();
  }
  for (double& mass : masses)
    mass = double(joint.mass_kg) * (mass / total);
  return masses;
}

std::vector<Pose> joint_motions(const Scene& scene, const std::vector<double>& positions) {
  std::vector<Pose> motions;
  motions.reserve(scene.joints.size());
  for (std::size_t row = 0; row < scene.joints.size(); ++row) {
    const SceneJoint& joint = scene.joints[row];
    const Pose frame = fixture_from_joint(joint);
    const Pose own =
        positions[row] == 0 ? Pose{} : frame * own_motion(joint, positions[row]) * inverse(frame);
    motions.push_back(joint.parent < 0 ? own
                                       : motions[static_cast<std::size_t>(joint.parent)] * own);
  }
  return motions;
}

Scene scene_at(Scene scene, const std::vector<double>& positions) {
  const std::vector<Pose> motions = joint_motions(scene, positions);
  for (ScenePart& part : scene.parts) {
    if (part.joint >= 0) move_part(part, motions[static_cast<std::size_t>(part.joint)]);
  }
  return scene;
}

Result<double> joint_position(const SceneJoint& joint, std::string_view text) {
  for (const assets::JointState& state : joint.states) {
    if (state.name == text) return state.position;
  }
  double position = 0;
  const auto [end, failed] = std::from_chars(text.data(), text.data() + text.size(), position);
  const bool number = failed == std::errc() && end == text.data() + text.size();
  if (number && position >= joint.lower && position <= joint.upper) return position;
  return Error{"usage.bad_flag",
               joint.name,
               fmt::format("\"{}\" is no position of this joint; write a number from {} to {}, or "
                           "a state: {}",
                           text,
                           joint.lower,
                           joint.upper,
                           states_text(joint))};
}

}  // namespace marketgen::scene
