// The robot of In-Aisle Item Collection and what it carries: the rows of data/benchmark/aisle.json.
//
// Poses are in the frame of the robot's base (on the floor, X ahead) or of one of its frames; SI
// units.
#pragma once
#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "episodes/station_rows.h"
#include "episodes/tool_sets.h"
#include "physics/settle/bulk_settle.h"
#include "skills/drop_plan.h"

namespace marketgen::episodes {

// Stands over a frame of the robot, whose Z is up; the frame's Z goes through the middle of its
// inner floor.
struct CarriedBasketRow {
  std::string frame;
  Pair top_m{};
  double above_frame_m = 0, height_m = 0, wall_m = 0, floor_m = 0;
  std::string source;
  static constexpr auto fields = field_list(
      field("frame", &CarriedBasketRow::frame, "of the robot", identifier()),
      field("above_frame_m",
            &CarriedBasketRow::above_frame_m,
            "of the inner floor over the frame's origin",
            range(0, 0.5)),
      field("top_m", &CarriedBasketRow::top_m, "inner, along x and y", range(0.1, 1)),
      field("height_m", &CarriedBasketRow::height_m, "of the rim", range(0.02, 0.5)),
      field("wall_m", &CarriedBasketRow::wall_m, "thickness of the walls", range(0.001, 0.05)),
      field("floor_m", &CarriedBasketRow::floor_m, "thickness of the floor", range(0.001, 0.05)),
      field("source", &CarriedBasketRow::source, "keys of the sources, by blanks"));
};

// Heights of a shelf's board over the floor from which targets are drawn.
struct ShelfRangeRow {
  double lowest_m = 0, highest_m = 2;
  std::string source;
  static constexpr auto fields =
      field_list(field("lowest_m", &ShelfRangeRow::lowest_m, "over the floor", range(0, 3)),
                 field("highest_m", &ShelfRangeRow::highest_m, "over the floor", range(0, 3)),
                 field("source", &ShelfRangeRow::source, "keys of the sources, by blanks"));
};

// In a frame of the robot whose Z looks ahead and whose Y looks down.
struct FrameCameraRow {
  std::string frame;
  double fov_deg = 60;
  int width = 640, height = 480;
  std::string source;
  static constexpr auto fields =
      field_list(field("frame", &FrameCameraRow::frame, "of the robot", identifier()),
                 field("fov_deg", &FrameCameraRow::fov_deg, "across the picture", range(10, 140)),
                 field("width", &FrameCameraRow::width, "pixels", range(16, 4096)),
                 field("height", &FrameCameraRow::height, "pixels", range(16, 4096)),
                 field("source", &FrameCameraRow::source, "keys of the sources, by blanks"));
};

// The robot's cameras: that of its head, as the station's row has it, and those of its wrists,
// which have the lens of the head's.
inline constexpr std::array<std::string_view, 3> aisle_cameras{
    "head_camera", "left_wrist_camera", "right_wrist_camera"};
inline bool is_aisle_camera(std::string_view name) {
  return std::ranges::find(aisle_cameras, name) != aisle_cameras.end();
}

struct AisleStation {
  std::string schema = "market-aisle/1";
  std::string id;
  std::vector<robots::SourceRow> sources;
  std::string robot;
  ToolSets tool_sets;
  std::string posture;
  double lift_m = 0;
  CarriedBasketRow basket;
  ShelfRangeRow shelf;
  FrameCameraRow head_camera;
  StationCameraRow film_camera;
  double limit_s = 900;
  std::size_t carries = 0;  // row of tool_sets, no field of the file

  static constexpr auto fields = field_list(
      field("schema", &AisleStation::schema, "schema tag", constant("market-aisle/1")),
      field("id", &AisleStation::id, "the name of its file", identifier()),
      field("sources", &AisleStation::sources, "where its figures come from"),
      field("robot", &AisleStation::robot, "row in data/robots", required()),
      field("tool_sets",
            &AisleStation::tool_sets,
            "of which an episode names one; the first by itself",
            required(),
            at_most_items(16)),
      field("posture", &AisleStation::posture, "of the robot while it drives", required()),
      field("lift_m", &AisleStation::lift_m, "at the start", range(0, 2)),
      field("basket", &AisleStation::basket, "that it carries", required()),
      field("shelf", &AisleStation::shelf, "boards from which targets are drawn", required()),
      field("head_camera", &AisleStation::head_camera, "on its head", required()),
      field("film_camera", &AisleStation::film_camera, "follows the robot, for films", required()),
      field("limit_s", &AisleStation::limit_s, "simulated, of an episode", range(1, 3600)));

  const ToolSetRow& tools() const { return tool_sets[carries]; }
  // Walls and floor in the basket's frame: origin in the middle of its inner floor.
  std::vector<physics::ContainerBox> basket_boxes() const;
};

// Where one of aisle_cameras is: Z ahead, Y down. A wrist's is on a bracket beside the flange, on a
// side to which no finger opens, and looks at where its gripper closes (own layout, not measured;
// nothing collides with it). No row of the station has it: frozen episodes hold the hash over
// those.
struct CameraMount {
  std::string frame;  // of the robot
  Pose frame_from_camera;
};
CameraMount mount_of_camera(const AisleStation& station, std::string_view camera);

// With one of its tool sets, the first when `tools` is empty. Errors: as load_checkout_station;
// robot.unknown for a set that there is not, with those there are.
Result<AisleStation> load_aisle_station(const std::filesystem::path& data,
                                        const std::string& tools = {});
// Errors: those of load_robot; robot.unknown when it lacks the posture, the basket's frame, a
// drive, or a tool.
Result<robots::Robot> load_station_robot(const std::filesystem::path& data,
                                         const AisleStation& station);

// From the link that carries the basket.
Pose link_from_basket(const AisleStation& station, const robots::Robot& robot);
// In the frame of the robot's base.
skills::CarriedBasket carried_basket(const AisleStation& station, const robots::Robot& robot);

}  // namespace marketgen::episodes
