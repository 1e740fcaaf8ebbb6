#include "physics/world/fixture_bodies.h"

#include "physics/goods/contact_shape.h"
#include "physics/goods/spec_geoms.h"
#include "scene/articulation.h"

namespace marketgen::physics {
namespace {

class FixtureBuilder {
 public:
  FixtureBuilder(mjsBody* world, StillGeoms& still, const scene::Scene& scene)
      : world_(world), still_(still), scene_(scene) {
    made_.joints.resize(scene.joints.size());
    parts_on_.resize(scene.joints.size());
    children_.resize(scene.joints.size());
    for (std::uint32_t row = 0; row < scene.joints.size(); ++row) {
      if (const std::int32_t parent = scene.joints[row].parent; parent >= 0)
        children_[static_cast<std::size_t>(parent)].push_back(row);
    }
  }

  bool moves(const scene::ScenePart& part) const {
    return part.joint >= 0 &&
           scene_.joints[static_cast<std::size_t>(part.joint)].kind != assets::JointKind::belt;
  }
  void note_moving(std::uint32_t row) {
    parts_on_[static_cast<std::size_t>(scene_.parts[row].joint)].push_back(row);
  }

  void add_still(std::uint32_t row) {
    const scene::ScenePart& part = scene_.parts[row];
    note_geom(still_.add(scene::world_from_fixture(scene_, part.fixture) * contact_shape_of(part)),
              row,
              furniture_contact_type);
  }

  void add_body(mjsBody* parent, std::uint32_t row, const Pose& owner_from_fixture) {
    const scene::SceneJoint& joint = scene_.joints[row];
    const Pose frame = scene::fixture_from_joint(joint);
    mjsBody* body = mjs_addBody(parent, nullptr);
    set_pose(body->pos, body->quat, owner_from_fixture * frame);
    if (parent == world_) body->sleep = mjSLEEP_INIT;
    made_.joints[row].joint = add_joint(body, joint);
    const Pose body_from_fixture = inverse(frame);
    const std::vector<double> masses = scene::masses_of(scene_, joint, parts_on_[row]);
    for (std::size_t i = 0; i < masses.size(); ++i) {
      const std::uint32_t part = parts_on_[row][i];
      mjsGeom* geom = add_shape(body, body_from_fixture * contact_shape_of(scene_.parts[part]));
      geom->mass = masses[i];
      note_geom(geom, part, moving_furniture_contact_type);
    }
    for (const std::uint32_t child : children_[row])
      add_body(body, child, body_from_fixture);
  }

  // A tree of joints moves when every one of its joints has parts in the model and none is a belt.
  bool complete(std::uint32_t row) const {
    if (parts_on_[row].empty() || scene_.joints[row].kind == assets::JointKind::belt) return false;
    for (const std::uint32_t child : children_[row]) {
      if (!complete(child)) return false;
    }
    return true;
  }

  void add_tree(std::uint32_t root) {
    if (complete(root))
      add_body(world_, root, scene::world_from_fixture(scene_, scene_.joints[root].fixture));
    else
      add_tree_still(root);
  }

  FixtureElements take() { return std::move(made_); }

 private:
  void add_tree_still(std::uint32_t row) {
    for (const std::uint32_t part : parts_on_[row])
      add_still(part);
    for (const std::uint32_t child : children_[row])
      add_tree_still(child);
  }

  void note_geom(mjsGeom* geom, std::uint32_t row, int contact_type) {
    geom->contype = contact_type;
    geom->conaffinity = furniture_affinity;
    made_.geoms.push_back({geom, row});
  }

  mjsJoint* add_joint(mjsBody* body, const scene::SceneJoint& joint) {
    mjsJoint* made = mjs_addJoint(body, nullptr);
    made->type = joint.kind == assets::JointKind::hinge ? mjJNT_HINGE : mjJNT_SLIDE;
    made->axis[0] = made->axis[1] = 0, made->axis[2] = 1;
    made->range[0] = joint.lower, made->range[1] = joint.upper;
    made->limited = mjLIMITED_TRUE;
    made->frictionloss = joint.friction;
    made->damping[0] = joint.damping;
    made->stiffness[0] = joint.stiffness;
    made->springref = joint.spring_rest;
    if (joint.stiffness != 0 && joint.hold_open != 0) {
      const double reach = double(joint.hold_open) - double(joint.spring_rest);
      made->stiffness[2] = -double(joint.stiffness) / (reach * reach);
    }
    return made;
  }

  mjsBody* world_;
  StillGeoms& still_;
  const scene::Scene& scene_;
  FixtureElements made_;
  std::vector<std::vector<std::uint32_t>> parts_on_, children_;  // by joint
};

}  // namespace

FixtureElements add_fixtures(mjsBody* world,
                             StillGeoms& still,
                             const scene::Scene& scene,
                             const std::function<bool(std::uint32_t)>& wanted,
                             bool articulated) {
  FixtureBuilder builder(world, still, scene);
  for (std::uint32_t row = 0; row < scene.parts.size(); ++row) {
    if (!wanted(row)) continue;
    if (articulated && builder.moves(scene.parts[row]))
      builder.note_moving(row);
    else
      builder.add_still(row);
  }
  if (articulated) {
    for (std::uint32_t row = 0; row < scene.joints.size(); ++row) {
      if (scene.joints[row].parent < 0) builder.add_tree(row);
    }
  }
  return builder.take();
}

}  // namespace marketgen::physics
