// What moves on a fixture moves freely: over the whole range of every joint no part reaches into
// another, at the sizes of the table and for every row of the catalogue.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "fixture_table.h"
#include "geometry/pose.h"
#include "oriented_box.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

constexpr double motion_tolerance_m = 0.0005;
constexpr int steps = 16;
constexpr double one_turn_rad = 6.283185307179586;

bool carries(const assets::FixtureModel& model, int joint, int descendant) {
  while (descendant >= 0 && descendant != joint)
    descendant = model.joints[static_cast<std::size_t>(descendant)].parent;
  return descendant == joint;
}

// A cylinder that turns about its own axis fills the same room all the way; round one that stands
// on the axis, what turns keeps its distance.
bool turns_in_place(const assets::FixturePart& part, const assets::FixtureJoint& joint) {
  if (part.shape != assets::PartShape::cylinder || joint.kind != assets::JointKind::hinge)
    return false;
  const Vec3 axle = rotate(joint.fixture_from_joint.rotation, {0, 0, 1});
  const Vec3 axis = rotate(part.fixture_from_part.rotation, {0, 0, 1});
  const Vec3 apart = part.fixture_from_part.position - joint.fixture_from_joint.position;
  return length(cross(axle, axis)) < 1e-6 && length(cross(apart, axle)) < 1e-6;
}

OrientedBox box_at(const assets::FixturePart& part,
                   const assets::FixtureJoint& joint,
                   double position) {
  if (turns_in_place(part, joint)) return oriented_box(part);
  const Pose motion = joint.kind == assets::JointKind::hinge
                          ? Pose{{}, rotation_about({0, 0, 1}, position)}
                          : Pose{{0, 0, position}, {}};
  assets::FixturePart moved = part;
  moved.fixture_from_part = joint.fixture_from_joint * motion * inverse(joint.fixture_from_joint) *
                            part.fixture_from_part;
  return oriented_box(moved);
}

// The deepest that anything on `joint` reaches into anything else over its range, metres.
double deepest(const assets::FixtureModel& model, int row) {
  const assets::FixtureJoint& joint = model.joints[static_cast<std::size_t>(row)];
  const double low = std::max(joint.lower, -one_turn_rad / 2);
  const double high = std::min(joint.upper, one_turn_rad / 2);
  std::vector<const assets::FixturePart*> moving;
  std::vector<OrientedBox> others;
  for (const assets::FixturePart& part : model.parts) {
    if (carries(model, row, part.joint))
      moving.push_back(&part);
    else if (!turns_in_place(part, joint))
      others.push_back(oriented_box(part));
  }
  double worst = -1;
  for (int step = 0; step <= steps; ++step) {
    const double position = low + (high - low) * step / steps;
    for (const assets::FixturePart* part : moving) {
      const OrientedBox box = box_at(*part, joint, position);
      for (const OrientedBox& other : others)
        worst = std::max(worst, penetration(box, other));
    }
  }
  return worst;
}

void expect_free_motion(const assets::FixtureShape& shape, const assets::FixtureModel& model) {
  for (std::size_t row = 0; row < model.joints.size(); ++row) {
    if (model.joints[row].kind == assets::JointKind::belt) continue;  // its parts stand still
    EXPECT_LE(deepest(model, static_cast<int>(row)), motion_tolerance_m)
        << text_of(shape) << " " << model.joints[row].name;
  }
}

TEST(FixtureSweeps, ADoorHungOnItsBackEdgeIsSeenToHitItsPost) {  // the test sees what it must see
  assets::FixtureModel model;
  assets::FixturePart post, leaf;
  post.half_size = {0.02F, 0.02F, 1};
  post.fixture_from_part.position = {-0.021, 0, 1};  // 1 mm beside the leaf
  leaf.half_size = {0.3F, 0.02F, 1};
  leaf.fixture_from_part.position = {0.3, 0, 1};
  leaf.joint = 0;
  model.parts = {post, leaf};
  assets::FixtureJoint hinge;
  hinge.upper = 1.5;
  hinge.fixture_from_joint.position = {0, 0.02, 0};  // on the side that it opens to
  model.joints = {hinge};
  EXPECT_LT(deepest(model, 0), motion_tolerance_m);  // counter-clockwise: it opens towards +Y
  model.joints[0].fixture_from_joint.position = {0, -0.02, 0};
  EXPECT_GT(deepest(model, 0), 0.01);
}

TEST(FixtureSweeps, EveryTableRowMovesFreely) {
  const catalog::Catalog catalog = small_catalog();
  for (const assets::FixtureShape& shape : table())
    expect_free_motion(shape, made(shape, catalog));
}

TEST(FixtureSweeps, EveryCatalogueRowMovesFreely) {
  const catalog::Catalog& catalog = committed_catalog();
  int articulated = 0;
  for (const catalog::FixtureKind& kind : catalog.fixture_kinds) {
    const assets::FixtureShape shape = shape_of(kind);
    const assets::FixtureModel model = made(shape, catalog);
    articulated += model.joints.empty() ? 0 : 1;
    expect_free_motion(shape, model);
  }
  EXPECT_GE(articulated, 40);
}

}  // namespace
}  // namespace marketgen
