#include "episodes/aisle/aisle_station.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "episodes/source_keys.h"
#include "geometry/rotation_axes.h"
#include "io/file.h"
#include "io/json.h"

namespace marketgen::episodes {
namespace {

constexpr char aisle_file[] = "aisle.json";
constexpr Vec3 wrist_bracket_m{0.08, 0, 0.02};  // in the flange's frame; fingers open along its y
constexpr double wrist_tilt_rad = 0.38;         // towards the gripper: tan = 0.08 over 0.2 m
constexpr std::string_view basket_color = "#2f6f4f";

Result<void> check_station(const AisleStation& s) {
  for (const auto& [place, keys] : {std::pair{"/basket", &s.basket.source},
                                    {"/shelf", &s.shelf.source},
                                    {"/head_camera", &s.head_camera.source},
                                    {"/film_camera", &s.film_camera.source}})
    MARKETGEN_CHECK(check_source_keys(s.sources, *keys, aisle_file, place));
  MARKETGEN_CHECK(check_tool_sets(s.tool_sets, s.sources, aisle_file));
  if (s.shelf.lowest_m > s.shelf.highest_m)
    return Error{"catalog.bad_row", std::string(aisle_file) + ":/shelf", "lowest is over highest"};
  return {};
}

Result<void> check_robot(const AisleStation& station, const robots::Robot& robot) {
  const auto lacks = [&](const std::string& what) {
    return Error{"robot.unknown", robot.name, "the robot of the aisles lacks " + what};
  };
  if (!robot.drive) return lacks("a drive");
  if (robot.find_posture(station.posture) == nullptr)
    return lacks("the posture \"" + station.posture + "\"");
  std::vector<std::string> frames{station.basket.frame};
  for (const std::string_view camera : aisle_cameras)
    frames.push_back(mount_of_camera(station, camera).frame);
  for (const std::string& frame : frames)
    if (robot.find_frame(frame) < 0) return lacks("the frame \"" + frame + "\"");
  if (const std::string& row = station.tools().picks_with; !skills::hands_with(robot, row).ok())
    return lacks("an arm with the tool \"" + row + "\"");
  return {};
}

// What is seen of the basket; what is touched of it are its boxes.
void add_basket_look(const AisleStation& station, robots::Robot& robot) {
  const robots::RobotFrame& frame =
      robot.frames[static_cast<std::size_t>(robot.find_frame(station.basket.frame))];
  robots::Link& link = robot.links[static_cast<std::size_t>(frame.link)];
  for (const physics::ContainerBox& box : station.basket_boxes()) {
    robots::BodyShape shape;
    shape.link_from_shape = link_from_basket(station, robot) * box.container_from_box;
    shape.size = box.half_size * 2;
    shape.color = basket_color;
    link.look.push_back(shape);
  }
}

}  // namespace

CameraMount mount_of_camera(const AisleStation& station, std::string_view camera) {
  if (camera == aisle_cameras.front()) return {station.head_camera.frame, {}};
  const std::string_view arm = camera.substr(0, camera.find('_'));
  const double c = std::cos(wrist_tilt_rad), s = std::sin(wrist_tilt_rad);
  return {fmt::format("{}_flange", arm),
          {wrist_bracket_m, rotation_with_axes({-c, 0, -s}, {-s, 0, c})}};
}

std::vector<physics::ContainerBox> AisleStation::basket_boxes() const {
  const CarriedBasketRow& b = basket;
  std::vector<physics::ContainerBox> boxes = physics::boxes_of(
      {.top_x_m = b.top_m[0], .top_y_m = b.top_m[1], .height_m = b.height_m, .wall_m = b.wall_m});
  boxes.push_back({{{0, 0, -b.floor_m / 2}, {}}, {b.top_m[0] / 2, b.top_m[1] / 2, b.floor_m / 2}});
  return boxes;
}

Pose link_from_basket(const AisleStation& station, const robots::Robot& robot) {
  const robots::RobotFrame& frame =
      robot.frames[static_cast<std::size_t>(robot.find_frame(station.basket.frame))];
  return frame.link_from_frame * Pose{{0, 0, station.basket.above_frame_m}, {}};
}

skills::CarriedBasket carried_basket(const AisleStation& station, const robots::Robot& robot) {
  const CarriedBasketRow& row = station.basket;
  skills::CarriedBasket basket;
  basket.base_from_floor =
      robots::frame_pose(robot, robots::neutral_state(robot), robot.find_frame(row.frame)) *
      Pose{{0, 0, row.above_frame_m}, {}};
  basket.size = {row.top_m[0], row.top_m[1], row.height_m};
  for (const physics::ContainerBox& box : station.basket_boxes())
    basket.walls.push_back({basket.base_from_floor * box.container_from_box, box.half_size});
  return basket;
}

Result<AisleStation> load_aisle_station(const std::filesystem::path& data,
                                        const std::string& tools) {
  MARKETGEN_TRY(const std::string text, io::read_file(data / "benchmark" / aisle_file, 1U << 20));
  MARKETGEN_TRY(AisleStation station, io::read_json<AisleStation>(text, aisle_file));
  MARKETGEN_CHECK(check_station(station));
  MARKETGEN_TRY(station.carries, tool_set_named(station.tool_sets, tools, aisle_file));
  return station;
}

Result<robots::Robot> load_station_robot(const std::filesystem::path& data,
                                         const AisleStation& station) {
  MARKETGEN_TRY(robots::Robot robot,
                robots::load_robot(data, station.robot, robot_tools(station.tools())));
  MARKETGEN_CHECK(check_robot(station, robot));
  add_basket_look(station, robot);
  return robot;
}

}  // namespace marketgen::episodes
