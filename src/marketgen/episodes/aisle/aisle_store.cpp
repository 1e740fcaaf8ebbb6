#include "episodes/aisle/aisle_store.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>

#include "collect/collect_plan.h"
#include "scene/placements.h"

namespace marketgen::episodes {
namespace {

constexpr std::array standing_m{0.70, 0.65, 0.75, 0.60, 0.80};  // from the product's front
constexpr std::array beside_m{0.30, -0.30, 0.0};
constexpr std::size_t max_places = 6;       // of a SKU that are looked at
constexpr double driving_opening_m = 0.06;  // of its grippers
constexpr double unreachable = std::numeric_limits<double>::infinity();

double way_m(const navigation::VisibilityGraph& ways, PointMm from, PointMm to) {
  const auto path = ways.shortest_path(from, to);
  return path.ok() ? path->length_m : unreachable;
}

// The shortest way over one place of every group that is left.
class TourSearch {
 public:
  TourSearch(const navigation::VisibilityGraph& ways, std::vector<std::vector<PointMm>> groups)
      : ways_(ways), groups_(std::move(groups)), done_(groups_.size()) {}

  double shortest_from(PointMm from) {
    double best = unreachable;
    bool any = false;
    for (std::size_t group = 0; group < groups_.size(); ++group) {
      if (done_[group]) continue;
      any = true;
      done_[group] = true;
      for (const PointMm& place : groups_[group]) {
        const double first = length(from, place);
        if (first < best) best = std::min(best, first + shortest_from(place));
      }
      done_[group] = false;
    }
    return any ? best : 0;
  }

 private:
  double length(PointMm from, PointMm to) {
    const auto [known, is_new] = lengths_.try_emplace({from, to});
    if (is_new) known->second = way_m(ways_, from, to);
    return known->second;
  }

  const navigation::VisibilityGraph& ways_;
  std::vector<std::vector<PointMm>> groups_;
  std::vector<bool> done_;
  std::map<std::pair<PointMm, PointMm>, double> lengths_;
};

}  // namespace

Pose base_pose_of(const FloorPlaceRow& row) {
  return {{row.x_m, row.y_m, 0},
          rotation_about({0, 0, 1}, row.heading_deg * std::numbers::pi / 180)};
}

Pose base_of(const robots::Robot& robot, const std::vector<double>& state) {
  const auto at = [&](std::string_view name) {
    return state[static_cast<std::size_t>(robot.find_dof(name))];
  };
  return {{at("base_x"), at("base_y"), 0}, rotation_about({0, 0, 1}, at("base_yaw"))};
}

Vec3 axle_of(const robots::Robot& robot, const Pose& world_from_base) {
  return world_from_base * Vec3{robot.drive ? robot.drive->axle_x : 0, 0, 0};
}

bool has_doors(const scene::Scene& scene, std::uint32_t fixture) {
  const scene::SceneFixture& row = scene.fixtures[fixture];
  for (std::uint32_t j = row.first_joint; j < row.first_joint + row.joint_count; ++j)
    if (scene.joints[j].kind != assets::JointKind::belt) return true;
  return false;
}

std::optional<PointMm> AisleStore::standing_place(std::uint32_t product) const {
  const scene::SceneProduct& row = scene.products[product];
  const Pose pose = scene::world_from_product(row);
  const Vec3 out = rotate(pose.rotation, {0, -1, 0}), left{out.y, -out.x, 0};
  const double front = scene.catalog[row.sku].depth_m() / 2;
  for (const double side : beside_m) {
    for (const double distance : standing_m) {
      const PointMm at = floor_mm(pose.position + out * (front + distance) - left * side);
      if (ways.space().free(at)) return at;
    }
  }
  return std::nullopt;
}

double AisleStore::room_behind_m(const Pose& world_from_base,
                                 const navigation::VisibilityGraph& past) const {
  constexpr double step_m = 0.04;
  for (double back = max_back_off_m; back > step_m / 2; back -= step_m) {
    const Pose there = world_from_base * Pose{{-back, 0, 0}, {}};
    if (past.space().free(floor_mm(axle_of(robot, there)))) return back;
  }
  return 0;
}

// Another pack of its facing stands on it.
bool AisleStore::carries_another(std::uint32_t row) const {
  const scene::SceneProduct& product = scene.products[row];
  const scene::Facing& facing = scene.facings[product.facing];
  if (facing.stack < 2) return false;
  const catalog::Product& goods = scene.catalog[product.sku];
  const double near_m = std::min(goods.width_m(), goods.depth_m()) / 2;
  for (std::uint32_t i = 0; i < facing.product_count; ++i) {
    const auto& other = scene.products[facing.first_product + i].position_m;
    const double aside =
        std::hypot(other[0] - product.position_m[0], other[1] - product.position_m[1]);
    if (aside < near_m && other[2] > product.position_m[2] + near_m / 2) return true;
  }
  return false;
}

ShelfRefusal AisleStore::door_refusal(std::uint32_t product) const {
  const std::uint32_t shelf = scene.facings[scene.products[product].facing].shelf;
  const bool shut_in = has_doors(scene, scene.shelves[shelf].fixture);
  if (doors == Doors::none) return shut_in ? ShelfRefusal::behind_door : ShelfRefusal::none;
  if (!shut_in) return ShelfRefusal::no_door;
  return collect::door_before(scene, product) ? ShelfRefusal::none : ShelfRefusal::behind_door;
}

ShelfRefusal AisleStore::shelf_refusal(std::uint32_t product) const {
  const scene::SceneProduct& row = scene.products[product];
  if (row.facing == scene::no_facing) return ShelfRefusal::unshelved;
  const scene::SceneShelf& shelf = scene.shelves[scene.facings[row.facing].shelf];
  const double z = row.position_m[2];
  if ((row.flags & scene::product_front_row) == 0) return ShelfRefusal::behind_another;
  if (shelf.use != assets::ShelfUse::stand) return ShelfRefusal::unshelved;
  if (const ShelfRefusal door = door_refusal(product); door != ShelfRefusal::none) return door;
  if (z < station.shelf.lowest_m) return ShelfRefusal::too_low;
  if (z > station.shelf.highest_m) return ShelfRefusal::too_high;
  return carries_another(product) ? ShelfRefusal::under_another : ShelfRefusal::none;
}

Result<skills::DoorQuestion> AisleStore::door_question(const collect::GoodsNow& now,
                                                       std::uint32_t joint) const {
  MARKETGEN_TRY(skills::DoorQuestion question, collect::door_question(now, joint, robot, driving));
  MARKETGEN_TRY(question.tool_row, collect::gripper_row(robot));
  question.carried = basket.walls;
  return question;
}

Result<navigation::VisibilityGraph> AisleStore::ways_past(const skills::HingedDoor& door,
                                                          double position_rad) const {
  MARKETGEN_TRY(const motion::BaseEnvelope envelope, motion::base_envelope(robot, driving));
  return collect::drive_graph(scene, envelope, {collect::leaf_footprint(door, position_rad)});
}

Result<void> AisleStore::check_standing_past(const skills::HingedDoor& door,
                                             double position_rad,
                                             const navigation::VisibilityGraph& ways_past,
                                             const Pose& world_from_base,
                                             const std::vector<double>& state) const {
  if (!ways_past.space().free(floor_mm(axle_of(robot, world_from_base))))
    return Error{"motion.base_blocked", station.id, "no way leads there past the open door"};
  if (!skills::is_clear_of_leaf(robot, state, world_from_base, door, position_rad))
    return Error{"motion.base_blocked", station.id, "the robot would meet the open door"};
  return {};
}

std::vector<std::uint32_t> AisleStore::items_of(const std::string& sku) const {
  const auto kind = static_cast<std::uint32_t>(
      std::ranges::find(scene.catalog, sku, &catalog::Product::sku) - scene.catalog.begin());
  std::vector<std::uint32_t> rows;
  for (std::uint32_t row = 0; row < scene.products.size(); ++row)
    if (scene.products[row].sku == kind) rows.push_back(row);
  return rows;
}

std::vector<std::uint32_t> AisleStore::front_items(const std::string& sku) const {
  std::vector<std::uint32_t> rows = items_of(sku);
  std::erase_if(rows, [&](std::uint32_t row) { return shelf_refusal(row) != ShelfRefusal::none; });
  return rows;
}

std::vector<PointMm> AisleStore::standing_places(const std::string& sku) const {
  std::vector<PointMm> places;
  std::set<std::uint32_t> facings;
  for (const std::uint32_t row : front_items(sku)) {
    if (!facings.insert(scene.products[row].facing).second) continue;
    if (const auto place = standing_place(row)) places.push_back(*place);
    if (places.size() == max_places) break;
  }
  return places;
}

Result<std::shared_ptr<const AisleStore>> open_aisle_store(const std::filesystem::path& data,
                                                           scene::Scene scene,
                                                           const std::string& tools,
                                                           Doors doors) {
  auto store = std::make_shared<AisleStore>();
  store->doors = doors;
  store->scene = std::move(scene);
  MARKETGEN_TRY(store->station, load_aisle_station(data, tools));
  MARKETGEN_TRY(store->robot, load_station_robot(data, store->station));
  store->basket = carried_basket(store->station, store->robot);
  store->driving = skills::stowed_state(
      store->robot, store->station.posture, store->station.lift_m, driving_opening_m);
  MARKETGEN_TRY(const motion::BaseEnvelope envelope,
                motion::base_envelope(store->robot, store->driving));
  MARKETGEN_TRY(store->ways, collect::drive_graph(store->scene, envelope));
  return std::shared_ptr<const AisleStore>(std::move(store));
}

std::optional<double> shortest_tour_m(const AisleStore& store,
                                      PointMm from,
                                      const std::vector<std::string>& skus) {
  std::vector<std::vector<PointMm>> groups;
  for (const std::string& sku : skus)
    groups.push_back(store.standing_places(sku));
  const double length = TourSearch(store.ways, std::move(groups)).shortest_from(from);
  return std::isfinite(length) ? std::optional(length) : std::nullopt;
}

}  // namespace marketgen::episodes
