#include "render/stage/displaced.h"

#include <cmath>
#include <set>
#include <string>

#include "render/stage/actor.h"
#include "scene/articulation.h"

namespace marketgen::render::raytrace {
namespace {

Error bad_move(const std::string& where, const std::string& message) {
  return {"render.bad_move", where, message};
}

}  // namespace

Result<void> check_moves(const scene::Scene& scene,
                         std::span<const MovedProduct> products,
                         std::span<const MovedJoint> joints) {
  std::set<std::uint32_t> seen;
  for (const MovedProduct& moved : products) {
    const std::string where = "product " + std::to_string(moved.product);
    if (moved.product >= scene.products.size())
      return bad_move(where,
                      "the scene has " + std::to_string(scene.products.size()) + " products");
    if (!seen.insert(moved.product).second) return bad_move(where, "it is named twice");
    if (!check_body_pose(moved.world_from_product, where).ok())
      return bad_move(where, "expected a finite position and a unit quaternion");
  }
  seen.clear();
  for (const MovedJoint& moved : joints) {
    const std::string where = "joint " + std::to_string(moved.joint);
    if (moved.joint >= scene.joints.size())
      return bad_move(where, "the scene has " + std::to_string(scene.joints.size()) + " joints");
    if (!seen.insert(moved.joint).second) return bad_move(where, "it is named twice");
    if (!std::isfinite(moved.position)) return bad_move(where, "expected a finite position");
  }
  return {};
}

void add_moved_joints(const World& world,
                      const scene::Scene& scene,
                      std::span<const MovedJoint> joints,
                      std::vector<Displaced>& rows) {
  if (joints.empty()) return;
  std::vector<double> positions(scene.joints.size());
  for (const MovedJoint& moved : joints)
    positions[moved.joint] = moved.position;
  const std::vector<Pose> motions = scene::joint_motions(scene, positions);
  for (std::uint32_t i = 0; i < world.first_product_instance; ++i) {
    const Instance& instance = world.instances[i];
    if (instance.joint < 0) continue;
    const Pose& motion = motions[static_cast<std::size_t>(instance.joint)];
    const bool rests = motion.position == Vec3{} && motion.rotation == Quaternion{};
    if (rests) continue;
    const Pose fixture =
        scene::world_from_fixture(scene, static_cast<std::uint32_t>(instance.fixture));
    rows.push_back({i, instance.shelf, placement_of(fixture * motion)});
  }
}

}  // namespace marketgen::render::raytrace
