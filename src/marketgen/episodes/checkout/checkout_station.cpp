#include "episodes/checkout/checkout_station.h"

#include <algorithm>
#include <numbers>

#include "episodes/source_keys.h"
#include "geometry/box_extents.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen::episodes {
namespace {

constexpr double lip_width_m = 0.01;

std::string file_of(const std::string& id) {
  return id + ".json";
}

Error bad_station(const CheckoutStation& station,
                  const std::string& place,
                  const std::string& message) {
  return {"catalog.bad_row", file_of(station.id) + ":" + place, message};
}

Result<void> check_keys(const CheckoutStation& station,
                        const std::string& place,
                        const std::string& keys) {
  return check_source_keys(station.sources, keys, file_of(station.id), place);
}

bool apart(const AreaRow& a, const AreaRow& b) {
  return a.high_m[0] <= b.low_m[0] || b.high_m[0] <= a.low_m[0] || a.high_m[1] <= b.low_m[1] ||
         b.high_m[1] <= a.low_m[1];
}

Result<void> check_station(const CheckoutStation& s) {
  MARKETGEN_CHECK(check_keys(s, "/counter", s.counter.source));
  MARKETGEN_CHECK(check_keys(s, "/belt", s.belt.source));
  MARKETGEN_CHECK(check_keys(s, "/basket", s.basket.source));
  MARKETGEN_CHECK(check_keys(s, "/unloading", s.unloading.source));
  MARKETGEN_CHECK(check_keys(s, "/set_aside", s.set_aside.source));
  MARKETGEN_CHECK(check_keys(s, "/scene_camera", s.scene_camera.source));
  MARKETGEN_CHECK(check_keys(s, "/wrist_camera", s.wrist_camera.source));
  MARKETGEN_CHECK(check_tool_sets(s.tool_sets, s.sources, file_of(s.id)));
  const AreaRow area = s.unloading.area();
  const AreaRow top{s.counter.low_m, s.counter.high_m, {}};
  if (!top.holds(area.low_m[0], area.low_m[1]) || !top.holds(area.high_m[0], area.high_m[1]))
    return bad_station(s, "/unloading", "expected an area on the counter");
  if (!s.has_room_for_basket(s.basket_pose()))
    return bad_station(s, "/unloading", "expected an area beside the basket, both on the counter");
  return {};
}

}  // namespace

physics::OpenContainer CheckoutStation::container() const {
  return {basket.top_m[0],
          basket.top_m[1],
          basket.height_m,
          basket.taper_m,
          basket.wall_m,
          basket.ledge_width_m,
          basket.ledge_height_m};
}

Pose CheckoutStation::basket_pose() const {
  return {{basket.center_m[0], basket.center_m[1], basket.floor_m}, {}};
}

bool CheckoutStation::has_room_for_basket(const Pose& station_from_container) const {
  const Vec3 reach = box_half_extents(
      station_from_container.rotation,
      {basket.top_m[0] / 2 + basket.wall_m, basket.top_m[1] / 2 + basket.wall_m, 0});
  const Vec3 low = station_from_container.position - reach,
             high = station_from_container.position + reach;
  const double lip = unloading.lip_m > 0 ? lip_width_m : 0;
  const AreaRow area = unloading.area(), top{counter.low_m, counter.high_m, {}};
  const AreaRow kept{
      {area.low_m[0] - lip, area.low_m[1] - lip}, {area.high_m[0] + lip, area.high_m[1] + lip}, {}};
  return apart({{low.x, low.y}, {high.x, high.y}, {}}, kept) && top.holds(low.x, low.y) &&
         top.holds(high.x, high.y);
}

std::vector<physics::ContainerBox> CheckoutStation::basket_boxes() const {
  const BasketRow& b = basket;
  const double x = b.top_m[0] / 2 - b.taper_m + b.wall_m, y = b.top_m[1] / 2 - b.taper_m + b.wall_m;
  std::vector<physics::ContainerBox> boxes = physics::boxes_of(container());
  boxes.push_back({{{0, 0, -b.floor_m / 4}, {}}, {x, y, b.floor_m / 4}});
  boxes.push_back({{{0, 0, -b.floor_m * 0.75}, {}}, {x, y, b.floor_m / 4}});
  return boxes;
}

std::vector<physics::ContainerBox> CheckoutStation::lip() const {
  std::vector<physics::ContainerBox> boxes;
  const auto& [center, size, height, source] = unloading;
  if (height <= 0) return boxes;
  const double w = lip_width_m / 2;
  for (const double side : {-1.0, 1.0}) {
    boxes.push_back({{{center[0] + side * (size[0] / 2 + w), center[1], height / 2}, {}},
                     {w, size[1] / 2 + lip_width_m, height / 2}});
    boxes.push_back({{{center[0], center[1] + side * (size[1] / 2 + w), height / 2}, {}},
                     {size[0] / 2, w, height / 2}});
  }
  return boxes;
}

Result<CheckoutStation> load_checkout_station(const std::filesystem::path& data,
                                              const std::string& id,
                                              const std::string& tools) {
  const std::string file = file_of(id);
  MARKETGEN_TRY(const std::string text, io::read_file(data / "benchmark" / file, 1U << 20));
  MARKETGEN_TRY(CheckoutStation station, io::read_json<CheckoutStation>(text, file));
  if (station.id != id) return bad_station(station, "/id", "expected the name of its file: " + id);
  MARKETGEN_CHECK(check_station(station));
  MARKETGEN_TRY(station.carries, tool_set_named(station.tool_sets, tools, file));
  return station;
}

Result<robots::Robot> load_station_robot(const std::filesystem::path& data,
                                         const CheckoutStation& station) {
  return robots::load_robot(data, station.robot, robot_tools(station.tools()));
}

std::vector<double> ready_state(const CheckoutStation& station, const robots::Robot& robot) {
  std::vector<double> q = robots::neutral_state(robot);
  if (const robots::JointGroup* arm = robot.find_group("arm")) {
    for (std::size_t j = 0; j < std::min(arm->dofs.size(), station.ready_deg.size()); ++j)
      q[static_cast<std::size_t>(arm->dofs[j])] = station.ready_deg[j] * std::numbers::pi / 180;
  }
  if (const robots::JointGroup* fingers = robot.find_group("fingers")) {
    for (const int dof : fingers->dofs)
      q[static_cast<std::size_t>(dof)] = robot.joint_of_dof(static_cast<std::size_t>(dof)).upper;
  }
  return robots::with_followers(robot, std::move(q));
}

}  // namespace marketgen::episodes
