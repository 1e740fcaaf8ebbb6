// Doors of a store as the witnesses of its episodes need them: each opened and shut by plan, once.
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "collect/goods_now.h"
#include "episodes/aisle/aisle_store.h"

namespace marketgen::episodes {

// Why an item is never asked for: no plan opens the door before it, and shuts it.
constexpr std::string_view door_stays_shut = "door_stays_shut";

// A pose of the base as a row.
FloorPlaceRow floor_place_row(const Pose& world_from_base);

// How a store is while the door before an item stands open. Where no door is before it: as it is.
struct OpenDoor {
  std::string why_not;      // an error's text; empty: it is opened and shut
  collect::GoodsNow store;  // with the door open
  std::optional<WitnessDoor> row;
  // As in CollectOptions: clear of the leaf, and where a way leads past it. None without a door.
  std::function<Result<void>(const Pose& world_from_base, const std::vector<double>& state)>
      may_stand = {};
  Vec3 opened_from = {}, shut_from = {};                                      // of the axle
  std::shared_ptr<const navigation::VisibilityGraph> before = {}, past = {};  // the door shut; open

  // Of the axle's way: to the door, and past it to where the item is taken. None: there is no way,
  // or none from there to where the door is shut.
  std::optional<double> way_m(Vec3 from, Vec3 to) const;
  // While the item is taken.
  const navigation::VisibilityGraph& ways() const { return row ? *past : *before; }
  // Where the robot is when it has taken the item from there, and shut the door.
  Vec3 left_from(Vec3 axle) const { return row ? shut_from : axle; }
};

class DoorBook {
 public:
  explicit DoorBook(std::shared_ptr<const AisleStore> store);

  // A row of the scene's products. What is found depends on the store alone; any number of threads
  // may ask. Errors: those of AisleStore::door_question and ways_past; of plan_open_door and
  // plan_shut_door, those that are not about this door.
  Result<OpenDoor> before(std::uint32_t product);

 private:
  Result<OpenDoor> opened(std::uint32_t joint) const;

  std::shared_ptr<const AisleStore> store_;
  OpenDoor without_;  // a door
  std::mutex mutex_;
  std::map<std::uint32_t, OpenDoor> known_;  // by joint
};

}  // namespace marketgen::episodes
