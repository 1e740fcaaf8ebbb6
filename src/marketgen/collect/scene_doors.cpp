#include "collect/scene_doors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "collect/scene_obstacles.h"
#include "collect/standing_robot.h"
#include "motion/shape_obstacles.h"
#include "physics/goods/contact_shape.h"
#include "scene/articulation.h"
#include "scene/placements.h"

namespace marketgen::collect {
namespace {

constexpr double upright = 0.999;        // of an axis
constexpr double min_bar_half_m = 0.10;  // a hand needs some of it

constexpr double reach_of_door_m = 1.5, at_work_before_m = 0.3;

// Goods of a fixture stand behind its doors: no arm at its door comes to them.
std::vector<std::uint32_t> goods_of(const scene::Scene& scene, std::uint32_t fixture) {
  std::vector<std::uint32_t> rows;
  for (std::uint32_t row = 0; row < scene.products.size(); ++row) {
    const std::uint32_t facing = scene.products[row].facing;
    if (facing != scene::no_facing && scene.shelves[scene.facings[facing].shelf].fixture == fixture)
      rows.push_back(row);
  }
  return rows;
}

// What lies on a joint, along a direction.
struct Span {
  double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();

  void add(const Pose& pose, Vec3 half, Vec3 direction) {
    const Vec3 own = rotate(inverse(pose.rotation), direction);
    const double middle = dot(pose.position, direction),
                 reach =
                     std::abs(own.x) * half.x + std::abs(own.y) * half.y + std::abs(own.z) * half.z;
    low = std::min(low, middle - reach);
    high = std::max(high, middle + reach);
  }
};

struct LeafPart {
  const scene::ScenePart* row;
  Pose pose;  // world
  Vec3 half;
  assets::ContactShape shape;  // world
};

std::vector<LeafPart> parts_on(const scene::Scene& scene, std::uint32_t joint) {
  std::vector<LeafPart> parts;
  const scene::SceneFixture& fixture = scene.fixtures[scene.joints[joint].fixture];
  const Pose world_from_fixture = scene::world_from_fixture(scene, scene.joints[joint].fixture);
  for (std::uint32_t p = fixture.first_part; p < fixture.first_part + fixture.part_count; ++p) {
    const scene::ScenePart& part = scene.parts[p];
    if (part.joint != static_cast<std::int32_t>(joint)) continue;
    const auto& [x, y, z] = part.half_size_m;
    parts.push_back({&part,
                     world_from_fixture * scene::fixture_from_part(part),
                     {x, y, z},
                     world_from_fixture * physics::contact_shape_of(part)});
  }
  return parts;
}

bool is_bar(const LeafPart& part) {
  return part.row->unit == assets::UnitKind::handle &&
         part.row->shape == assets::PartShape::cylinder &&
         std::abs(rotate(part.pose.rotation, {0, 0, 1}).z) > upright &&
         part.half.z > min_bar_half_m;
}

// The level direction to the middle of its leaf along the closed door: that of its widest part.
Vec3 along_of(const std::vector<LeafPart>& parts, Vec3 hinge) {
  const auto farthest = std::ranges::max_element(parts, {}, [&](const LeafPart& part) {
    const Vec3 way = part.pose.position - hinge;
    return std::hypot(way.x, way.y);
  });
  Vec3 way = farthest->pose.position - hinge;
  // A leaf stands square to its fixture, which stands square to the store.
  return std::abs(way.x) > std::abs(way.y) ? Vec3{way.x > 0 ? 1.0 : -1.0, 0, 0}
                                           : Vec3{0, way.y > 0 ? 1.0 : -1.0, 0};
}

// With the leaf's measures; `door` has its hinge and directions.
skills::HingedDoor measured(const std::vector<LeafPart>& parts, skills::HingedDoor door) {
  Span length, height, face;
  for (const LeafPart& part : parts) {
    motion::add_shape(part.shape, door.leaf);
    if (part.row->unit == assets::UnitKind::handle) continue;
    length.add(part.pose, part.half, door.along);
    height.add(part.pose, part.half, {0, 0, 1});
    face.add(part.pose, part.half, door.out);
  }
  door.length_m = length.high - dot(door.hinge, door.along);
  door.low_m = height.low, door.high_m = height.high;
  door.face_m = face.high - dot(door.hinge, door.out);
  door.back_m = face.low - dot(door.hinge, door.out);
  return door;
}

}  // namespace

std::optional<skills::HingedDoor> hinged_door(const scene::Scene& scene, std::uint32_t joint) {
  const scene::SceneJoint& row = scene.joints[joint];
  if (row.kind != assets::JointKind::hinge || row.parent >= 0 || row.lower < 0) return std::nullopt;
  const Pose axis = scene::world_from_fixture(scene, row.fixture) * scene::fixture_from_joint(row);
  const Vec3 up = rotate(axis.rotation, {0, 0, 1});
  const std::vector<LeafPart> parts = parts_on(scene, joint);
  const auto bar = std::ranges::find_if(parts, is_bar);
  if (std::abs(up.z) < upright || bar == parts.end()) return std::nullopt;
  skills::HingedDoor door;
  door.hinge = {axis.position.x, axis.position.y, 0};
  door.along = along_of(parts, door.hinge);
  door.out = cross(up, door.along);
  door.hold_rad = double(row.hold_open);
  door.open_rad = double(row.upper);
  door = measured(parts, std::move(door));
  const Vec3 from_hinge = bar->pose.position - door.hinge;
  door.bar = {dot(from_hinge, door.along),
              dot(from_hinge, door.out),
              bar->pose.position.z - bar->half.z,
              bar->pose.position.z + bar->half.z,
              bar->half.x};
  if (door.bar.out_m - door.bar.radius_m < door.face_m) return std::nullopt;
  return door;
}

Result<skills::HingedDoor> known_door(const scene::Scene& scene, std::uint32_t joint) {
  if (auto door = hinged_door(scene, joint)) return *std::move(door);
  return Error{"collect.no_door",
               scene::joint_id(scene, scene.joints[joint]),
               "it is no door on an upright hinge with a bar"};
}

std::optional<std::uint32_t> door_before(const scene::Scene& scene, std::uint32_t product) {
  const scene::SceneProduct& row = scene.products[product];
  if (row.facing == scene::no_facing) return std::nullopt;
  const std::uint32_t fixture = scene.shelves[scene.facings[row.facing].shelf].fixture;
  const scene::SceneFixture& joints = scene.fixtures[fixture];
  const Vec3 at = scene::world_from_product(row).position;
  const Vec3 front = rotate(scene::world_from_product(row).rotation, {0, -1, 0});
  for (std::uint32_t j = joints.first_joint; j < joints.first_joint + joints.joint_count; ++j) {
    const auto door = hinged_door(scene, j);
    if (!door || dot(door->out, front) < 0.5) continue;
    const Vec3 from_hinge = at - door->hinge;
    const double along = dot(from_hinge, door->along);
    if (along > 0 && along < door->length_m && dot(from_hinge, door->out) < door->face_m &&
        at.z > door->low_m && at.z < door->high_m)
      return j;
  }
  return std::nullopt;
}

RectMm leaf_footprint(const skills::HingedDoor& door, double position_rad) {
  RectMm rect{std::numeric_limits<int>::max(),
              std::numeric_limits<int>::max(),
              std::numeric_limits<int>::lowest(),
              std::numeric_limits<int>::lowest()};
  for (const Vec3& corner : door.outline_at(position_rad)) {
    rect.x0 = std::min(rect.x0, static_cast<int>(std::floor(corner.x * 1e3)));
    rect.y0 = std::min(rect.y0, static_cast<int>(std::floor(corner.y * 1e3)));
    rect.x1 = std::max(rect.x1, static_cast<int>(std::ceil(corner.x * 1e3)));
    rect.y1 = std::max(rect.y1, static_cast<int>(std::ceil(corner.y * 1e3)));
  }
  return rect;
}

Result<skills::DoorQuestion> door_question(const GoodsNow& store,
                                           std::uint32_t joint,
                                           const robots::Robot& robot,
                                           std::vector<double> driving) {
  const scene::Scene& scene = store.scene();
  skills::DoorQuestion question;
  question.where = scene::joint_id(scene, scene.joints[joint]);
  MARKETGEN_TRY(question.door, known_door(scene, joint));
  question.position_rad = store.joint(joint);
  question.driving = std::move(driving);
  const Vec3 middle = question.door.point_at(0,
                                             question.door.bar.along_m,
                                             at_work_before_m,
                                             (question.door.low_m + question.door.high_m) / 2);
  question.around = fixture_obstacles(store, middle, reach_of_door_m, joint);
  MARKETGEN_CHECK(add_product_obstacles(store,
                                        middle,
                                        reach_of_door_m,
                                        goods_of(scene, scene.joints[joint].fixture),
                                        question.around));
  question.may_stand = [&scene, &robot, where = question.where](const Pose& world_from_base,
                                                                const std::vector<double>& state) {
    const robots::PlacedRobot placed{where, robot, state, world_from_base};
    return check_standing(scene, {&placed, 1});
  };
  return question;
}

}  // namespace marketgen::collect
