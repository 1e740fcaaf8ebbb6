// The place where Checkout Unloading happens: the rows of data/benchmark/checkout.json, or of
// another station of its form.
//
// Station frame, that of every pose of the track: origin where the robot stands on the counter's
// top, X over the counter, Z up. Metres.
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "episodes/station_rows.h"
#include "episodes/tool_sets.h"
#include "geometry/pose.h"
#include "physics/settle/bulk_settle.h"
#include "robots/robot_row.h"

namespace marketgen::episodes {

struct CounterRow {
  Pair low_m{}, high_m{};
  double height_m = 0.88, thickness_m = 0.06;
  std::string source;
  static constexpr auto fields = field_list(
      field("low_m", &CounterRow::low_m, "x and y of the top's one corner", on_the_counter),
      field("high_m", &CounterRow::high_m, "of the other", on_the_counter),
      field("height_m", &CounterRow::height_m, "of the top over the floor", range(0.3, 1.5)),
      field("thickness_m", &CounterRow::thickness_m, "of the top", range(0.01, 0.3)),
      field("source", &CounterRow::source, "keys of the sources, by blanks"));
};

// An upright rectangle on the counter.
struct AreaRow {
  Pair low_m{}, high_m{};
  std::string source;
  static constexpr auto fields =
      field_list(field("low_m", &AreaRow::low_m, "x and y of one corner", on_the_counter),
                 field("high_m", &AreaRow::high_m, "of the other", on_the_counter),
                 field("source", &AreaRow::source, "keys of the sources, by blanks"));
  bool holds(double x, double y) const {
    return x >= low_m[0] && x <= high_m[0] && y >= low_m[1] && y <= high_m[1];
  }
};

struct BasketRow {
  Pair center_m{}, top_m{};
  double height_m = 0, taper_m = 0, wall_m = 0, floor_m = 0, ledge_width_m = 0, ledge_height_m = 0;
  double mass_kg = 0;
  std::string source;
  static constexpr auto fields = field_list(
      field("center_m", &BasketRow::center_m, "x and y of its middle", on_the_counter),
      field("top_m", &BasketRow::top_m, "inner, between the upper edges", range(0.1, 1)),
      field("height_m", &BasketRow::height_m, "of the rim over the inner floor", range(0.02, 0.5)),
      field("taper_m", &BasketRow::taper_m, "each wall stands further in below", range(0, 0.1)),
      field("wall_m", &BasketRow::wall_m, "thickness of the walls", range(0.001, 0.05)),
      field("floor_m", &BasketRow::floor_m, "thickness of the floor", range(0.001, 0.05)),
      field("ledge_width_m", &BasketRow::ledge_width_m, "round the inner bottom", range(0, 0.1)),
      field("ledge_height_m", &BasketRow::ledge_height_m, "of the ledge", range(0, 0.1)),
      field("mass_kg", &BasketRow::mass_kg, "kg", range(0.05, 10)),
      field("source", &BasketRow::source, "keys of the sources, by blanks"));
};

struct UnloadingRow {
  Pair center_m{}, size_m{};
  double lip_m = 0;
  std::string source;
  static constexpr auto fields = field_list(
      field("center_m", &UnloadingRow::center_m, "x and y of its middle", on_the_counter),
      field("size_m", &UnloadingRow::size_m, "inside the lip", range(0.05, 2)),
      field("lip_m", &UnloadingRow::lip_m, "height of the lip round it", range(0, 0.05)),
      field("source", &UnloadingRow::source, "keys of the sources, by blanks"));
  AreaRow area() const {
    return {{center_m[0] - size_m[0] / 2, center_m[1] - size_m[1] / 2},
            {center_m[0] + size_m[0] / 2, center_m[1] + size_m[1] / 2},
            source};
  }
};

// Looks along the hand's Z.
struct WristCameraRow {
  robots::Triple hand_m{};
  double fov_deg = 60;
  int width = 640, height = 480;
  std::string source;
  static constexpr auto fields = field_list(
      field("hand_m", &WristCameraRow::hand_m, "place in the hand's frame", on_the_counter),
      field("fov_deg", &WristCameraRow::fov_deg, "across the picture", range(10, 140)),
      field("width", &WristCameraRow::width, "pixels", range(16, 4096)),
      field("height", &WristCameraRow::height, "pixels", range(16, 4096)),
      field("source", &WristCameraRow::source, "keys of the sources, by blanks"));
};

struct CheckoutStation {
  std::string schema = "market-checkout/1";
  std::string id;
  std::vector<robots::SourceRow> sources;
  CounterRow counter;
  AreaRow belt;
  BasketRow basket;
  UnloadingRow unloading;
  AreaRow set_aside;
  std::string robot;
  ToolSets tool_sets;
  std::vector<double> ready_deg;
  StationCameraRow scene_camera;
  WristCameraRow wrist_camera;
  double limit_s = 180;
  std::size_t carries = 0;  // row of tool_sets, no field of the file

  static constexpr auto fields = field_list(
      field("schema", &CheckoutStation::schema, "schema tag", constant("market-checkout/1")),
      field("id", &CheckoutStation::id, "the name of its file", identifier()),
      field("sources", &CheckoutStation::sources, "where its figures come from"),
      field("counter", &CheckoutStation::counter, "what everything stands on", required()),
      field("belt", &CheckoutStation::belt, "part of the counter's top", required()),
      field("basket", &CheckoutStation::basket, "at the infeed end", required()),
      field("unloading", &CheckoutStation::unloading, "where the targets go", required()),
      field("set_aside", &CheckoutStation::set_aside, "where other items may be put", required()),
      field("robot", &CheckoutStation::robot, "row in data/robots", required()),
      field("tool_sets",
            &CheckoutStation::tool_sets,
            "of which an episode names one; the first by itself",
            required(),
            at_most_items(16)),
      field("ready_deg", &CheckoutStation::ready_deg, "the arm's joints at the start, degrees"),
      field("scene_camera", &CheckoutStation::scene_camera, "stands still", required()),
      field("wrist_camera", &CheckoutStation::wrist_camera, "on the hand", required()),
      field("limit_s", &CheckoutStation::limit_s, "simulated, of an episode", range(1, 3600)));

  const ToolSetRow& tools() const { return tool_sets[carries]; }
  physics::OpenContainer container() const;
  Pose basket_pose() const;  // station_from_container at the start
  // Walls and ledge, then the floor's two layers: the upper touches goods, the lower the belt.
  std::vector<physics::ContainerBox> basket_boxes() const;
  // Whether a basket that stands there is on the counter and beside the unloading area and its lip.
  bool has_room_for_basket(const Pose& station_from_container) const;
  std::vector<physics::ContainerBox> lip() const;  // station_from_box; none when it has no height
};

inline constexpr char checkout_station[] = "checkout";

// Rows at which baskets of a store are unloaded: with fingers and a basket that make it easier, and
// with what one can buy.
enum class UnloadingStation { eased, stock };
constexpr std::array<std::string_view, 2> names_of(UnloadingStation) {
  return {checkout_station, "checkout-stock"};
}
inline std::string station_or_own(const std::string& id) {
  return id.empty() ? checkout_station : id;
}

// `data` is usually data_folder(), `id` the name of its file; with one of its tool sets, the first
// when `tools` is empty. Errors: catalog.missing_data, those of read_json, catalog.bad_row when a
// source key is unknown or areas overlap that must not; robot.unknown for a set that there is not,
// with those there are.
Result<CheckoutStation> load_checkout_station(const std::filesystem::path& data,
                                              const std::string& id = checkout_station,
                                              const std::string& tools = {});
Result<robots::Robot> load_station_robot(const std::filesystem::path& data,
                                         const CheckoutStation& station);

// The arm at rest, fingers open.
std::vector<double> ready_state(const CheckoutStation& station, const robots::Robot& robot);

}  // namespace marketgen::episodes
