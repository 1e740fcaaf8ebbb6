// A store in which In-Aisle Item Collection happens: what all of its episodes share.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "collect/drive_graph.h"
#include "collect/scene_doors.h"
#include "episodes/aisle/aisle_station.h"
#include "episodes/episode_spec.h"
#include "scene/scene.h"
#include "skills/drop_plan.h"

namespace marketgen::episodes {

constexpr double max_back_off_m = 0.30;  // from a shelf, with an item in the hand

// Why an item is not taken from where it is; the first that applies.
enum class ShelfRefusal {
  none,
  behind_another,  // not in the front row
  unshelved,       // lies in a heap or hangs, or was put somewhere by the plan
  behind_door,     // in a drawer or under a lid, or no door of the kind that is asked for
  no_door,         // before it, and goals stand behind doors
  too_low,         // its board, for the station
  too_high,
  under_another  // of its stack
};
constexpr std::array<std::string_view, 8> names_of(ShelfRefusal) {
  return {"none",
          "behind_another",
          "unshelved",
          "behind_door",
          "no_door",
          "too_low",
          "too_high",
          "under_another"};
}

// Immutable; any number of worlds and threads may share it.
struct AisleStore {
  scene::Scene scene;
  AisleStation station;
  robots::Robot robot;
  std::vector<double> driving;       // the robot's state while it drives, on the origin
  navigation::VisibilityGraph ways;  // for the robot as it drives
  skills::CarriedBasket basket;      // that it carries
  Doors doors = Doors::none;         // where its goals stand

  // Where it may stand to reach a product: in front of it, 0.60 to 0.80 m away, perhaps to a side.
  // Empty when nothing there is free.
  std::optional<PointMm> standing_place(std::uint32_t product) const;
  // Such places for all items of a SKU, at most one a facing.
  std::vector<PointMm> standing_places(const std::string& sku) const;
  // How far it may go straight back, at most max_back_off_m; `past` the door that is open, if any.
  double room_behind_m(const Pose& world_from_base, const navigation::VisibilityGraph& past) const;
  ShelfRefusal shelf_refusal(std::uint32_t product) const;
  ShelfRefusal door_refusal(std::uint32_t product) const;  // of these, what doors have to say
  std::vector<std::uint32_t> items_of(
      const std::string& sku) const;  // rows, of all that is stocked
  // Rows of its items that can be reached from the front, nothing on them; behind the doors that
  // goals stand behind, where they do.
  std::vector<std::uint32_t> front_items(const std::string& sku) const;
  bool carries_another(std::uint32_t row) const;  // a pack stands on it

  // ---- Doors, rows of Scene::joints. ----
  // Of its robot with its basket, for plan_open_door() and plan_shut_door(). Errors: those of
  // collect::door_question and gripper_row.
  Result<skills::DoorQuestion> door_question(const collect::GoodsNow& now,
                                             std::uint32_t joint) const;
  // For the robot as it drives, past a door that stands open so far. Errors: those of drive_graph.
  Result<navigation::VisibilityGraph> ways_past(const skills::HingedDoor& door,
                                                double position_rad) const;
  // Errors: motion.base_blocked where the robot, in that state, would meet its leaf or stand off
  // these ways.
  Result<void> check_standing_past(const skills::HingedDoor& door,
                                   double position_rad,
                                   const navigation::VisibilityGraph& ways_past,
                                   const Pose& world_from_base,
                                   const std::vector<double>& state) const;
};

// `tools`: a tool set of the station, the first when empty. Errors: those of load_aisle_station,
// load_station_robot, drive_graph.
Result<std::shared_ptr<const AisleStore>> open_aisle_store(const std::filesystem::path& data,
                                                           scene::Scene scene,
                                                           const std::string& tools = {},
                                                           Doors doors = Doors::none);

Pose base_pose_of(const FloorPlaceRow& row);  // world_from_base there
// Where the base stands, by the state of all degrees of freedom.
Pose base_of(const robots::Robot& robot, const std::vector<double>& state);
// Of the middle between the wheels.
Vec3 axle_of(const robots::Robot& robot, const Pose& world_from_base);

// Whether a door, a drawer or a flap is part of the fixture.
bool has_doors(const scene::Scene& scene, std::uint32_t fixture);

// Length of the shortest way from `from` past a place for each of the SKUs, in any order, metres.
// Empty when one of them cannot be reached.
std::optional<double> shortest_tour_m(const AisleStore& store,
                                      PointMm from,
                                      const std::vector<std::string>& skus);

}  // namespace marketgen::episodes
