#include "episodes/aisle/door_book.h"

#include <cmath>
#include <numbers>

#include "skills/plan_failure.h"

namespace marketgen::episodes {
namespace {

constexpr std::uint64_t doors_seed = 0x0d0025;  // of the arms' ways: the same for every episode

std::optional<double> path_m(const navigation::VisibilityGraph& ways, Vec3 from, Vec3 to) {
  const auto path = ways.shortest_path(floor_mm(from), floor_mm(to));
  return path.ok() ? std::optional(path->length_m) : std::nullopt;
}

}  // namespace

FloorPlaceRow floor_place_row(const Pose& world_from_base) {
  const Vec3 at = world_from_base.position, ahead = rotate(world_from_base.rotation, {1, 0, 0});
  return {at.x, at.y, std::atan2(ahead.y, ahead.x) * 180 / std::numbers::pi};
}

std::optional<double> OpenDoor::way_m(Vec3 from, Vec3 to) const {
  if (!row) return path_m(*before, from, to);
  const auto there = path_m(*before, from, opened_from), past_it = path_m(*past, opened_from, to);
  if (!there || !past_it || !path_m(*past, to, shut_from)) return std::nullopt;
  return *there + *past_it;
}

DoorBook::DoorBook(std::shared_ptr<const AisleStore> store)
    : store_(std::move(store)),
      without_{
          .why_not = {}, .store = store_->scene, .row = {}, .before = {store_, &store_->ways}} {}

Result<OpenDoor> DoorBook::before(std::uint32_t product) {
  if (store_->doors == Doors::none) return without_;
  const auto joint = collect::door_before(store_->scene, product);
  if (!joint) return without_;
  const std::scoped_lock lock(mutex_);
  const auto known = known_.find(*joint);
  if (known != known_.end()) return known->second;
  MARKETGEN_TRY(OpenDoor made, opened(*joint));
  return known_.emplace(*joint, std::move(made)).first->second;
}

Result<OpenDoor> DoorBook::opened(std::uint32_t joint) const {
  OpenDoor made = without_;
  MARKETGEN_TRY(skills::DoorQuestion question, store_->door_question(store_->scene, joint));
  const Seed seed = Seed(doors_seed).child(question.where);
  const auto open = skills::plan_open_door(store_->robot, question, seed.child("open"));
  std::vector<double> joints(store_->scene.joints.size());
  question.position_rad = joints[joint] = question.door.hold_rad;
  const auto shut =
      open.ok() ? skills::plan_shut_door(store_->robot, question, seed.child("shut")) : open;
  if (!shut.ok()) {
    if (!skills::is_of_planning(shut.error())) return shut.error();
    made.why_not = to_string(shut.error());
    return made;
  }
  MARKETGEN_TRY(auto past, store_->ways_past(question.door, question.position_rad));
  made.past = std::make_shared<const navigation::VisibilityGraph>(std::move(past));
  made.store.set_joints(std::move(joints));
  made.opened_from = axle_of(store_->robot, open->world_from_base);
  made.shut_from = axle_of(store_->robot, shut->world_from_base);
  made.row = WitnessDoor{question.where,
                         floor_place_row(open->world_from_base),
                         floor_place_row(shut->world_from_base)};
  made.may_stand = [store = store_,
                    door = std::move(question.door),
                    position = question.position_rad,
                    ways = made.past](const Pose& world_from_base,
                                      const std::vector<double>& state) {
    return store->check_standing_past(door, position, *ways, world_from_base, state);
  };
  return made;
}

}  // namespace marketgen::episodes
