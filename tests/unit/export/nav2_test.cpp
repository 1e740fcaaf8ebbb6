// What stands on a Nav2 map and what does not, and that the check sees what is wrong with one.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "export/export.h"
#include "export/nav2_map.h"
#include "export/nav2_read.h"
#include "io/file.h"
#include "scene/placements.h"
#include "support/committed_catalog.h"
#include "support/hand_made_scene.h"

namespace marketgen {
namespace {
namespace fs = std::filesystem;
using exporters::Nav2Cell;

class Nav2 : public testing::Test {
 protected:
  Nav2() : folder_(fs::temp_directory_path() / ("marketgen-nav2-" + std::to_string(getpid()))) {
    HandMadeScene made;
    made.stock();
    scene_ = made.scene;
    fs::create_directories(folder_);
  }
  ~Nav2() override { fs::remove_all(folder_); }

  Nav2Cell at(const exporters::Nav2Map& map, double x_m, double y_m) const {
    return map.cells[index(map, x_m, y_m)];
  }
  static std::size_t index(const exporters::Nav2Map& map, double x_m, double y_m) {
    const navigation::OccupancyGrid& frame = map.frame;
    return frame.index(static_cast<int>((x_m * 1000 - frame.bounds.x0) / frame.cell_mm),
                       static_cast<int>((y_m * 1000 - frame.bounds.y0) / frame.cell_mm));
  }
  exporters::Nav2Map map_of(const scene::Scene& scene) const {
    return exporters::make_nav2_map(scene, committed_catalog(), options_);
  }

  void write() const {
    const Result<void> written = exporters::export_scene(scene_, "nav2", file(), options_);
    ASSERT_TRUE(written.ok()) << to_string(written.error());
  }
  // The message of the check's error.
  std::string fault() const {
    const auto checked = exporters::check_export(scene_, "nav2", file(), options_);
    if (checked.ok()) return "";
    EXPECT_EQ(checked.error().code, "export.mismatch");
    return checked.error().where + ": " + checked.error().message;
  }
  void replace(const std::string& name, const std::string& from, const std::string& to) const {
    std::string text = *io::read_file(folder_ / "shop_assets" / name);
    const std::size_t place = text.find(from);
    ASSERT_NE(place, std::string::npos) << name << " has no " << from;
    text.replace(place, from.size(), to);
    ASSERT_TRUE(io::write_file(folder_ / "shop_assets" / name, text).ok());
  }
  // The check's error with one cell of a picture of the shade; the picture is as before afterwards.
  std::string fault_with_cell(const std::string& name, double x_m, double y_m, char shade) const {
    const std::size_t columns = 130, rows = 90, header = std::string("P5\n130 90\n255\n").size();
    const fs::path picture = folder_ / "shop_assets" / name;
    const std::string bytes = *io::read_file(picture);
    EXPECT_TRUE(bytes.starts_with("P5\n130 90\n255\n")) << "6.5 x 4.5 m, 0.25 m beyond the room";
    std::string changed = bytes;
    changed[header + (rows - 1 - static_cast<std::size_t>((y_m + 0.25) / 0.05)) * columns +
            static_cast<std::size_t>((x_m + 0.25) / 0.05)] = shade;
    EXPECT_TRUE(io::write_file(picture, changed).ok());
    const std::string seen = fault();
    EXPECT_TRUE(io::write_file(picture, bytes).ok());
    return seen;
  }
  static testing::AssertionResult says(const std::string& fault, const std::string& what) {
    if (fault.find(what) != std::string::npos) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "\"" << fault << "\" says nothing of " << what;
  }
  fs::path file() const { return folder_ / "shop.yaml"; }

  scene::Scene scene_;
  exporters::ExportOptions options_;
  fs::path folder_;
};

TEST_F(Nav2, WhatStandsIsOccupiedAndWhatIsOutsideUnknown) {  // a room of 6 x 4 m
  const exporters::Nav2Map map = map_of(scene_);
  EXPECT_EQ(at(map, 3, 3.7), Nav2Cell::occupied);     // the shelf
  EXPECT_EQ(at(map, 0.6, 0.6), Nav2Cell::occupied);   // the column
  EXPECT_EQ(at(map, -0.1, 2), Nav2Cell::occupied);    // the west wall
  EXPECT_EQ(at(map, 4.5, -0.1), Nav2Cell::occupied);  // below the window
  EXPECT_EQ(at(map, 1.5, -0.1), Nav2Cell::unknown);   // the open entrance, below its lintel
  EXPECT_EQ(at(map, 3, 2), Nav2Cell::free);
  EXPECT_EQ(at(map, -0.23, -0.23), Nav2Cell::unknown);  // beyond the walls
  EXPECT_EQ(map.keepout[index(map, -0.1, 2)], 1);
  EXPECT_EQ(map.keepout[index(map, 3, 2)], 0);
  EXPECT_EQ(map.speed_percent[index(map, 1.5, 0.5)], 50);  // inside the entrance
  EXPECT_EQ(map.speed_percent[index(map, 4.5, 2.5)], 0);
}

TEST_F(Nav2, ASlantedWallIsClosedAndBeyondItNothingIsKnown) {  // across the north-east corner
  scene_.layout.shell.outline_mm = {{0, 0}, {6000, 0}, {6000, 2500}, {4500, 4000}, {0, 4000}};
  for (const double resolution_m : {0.02, 0.05, 0.25}) {
    options_.resolution_m = resolution_m;
    const exporters::Nav2Map map = map_of(scene_);
    EXPECT_EQ(at(map, 4.6, 2.9), Nav2Cell::free);
    EXPECT_EQ(at(map, 5.32, 3.32), Nav2Cell::occupied);  // the middle of the wall, 0.2 m thick
    EXPECT_EQ(at(map, 5.7, 3.7), Nav2Cell::unknown);
    EXPECT_EQ(map.keepout[index(map, 5.7, 3.7)], 1);
    write();
    EXPECT_EQ(fault(), "");
  }
}

TEST_F(Nav2, WhatHangsOverTheRobotIsNoObstacle) {
  for (scene::ScenePart& part : scene_.parts)
    part.position_m[2] += 1.5F;
  options_.robot_height_m = 1.4;
  EXPECT_EQ(at(map_of(scene_), 3, 3.7), Nav2Cell::free);
  options_.robot_height_m = 1.6;
  EXPECT_EQ(at(map_of(scene_), 3, 3.7), Nav2Cell::occupied);
}

TEST_F(Nav2, AProductOnTheFloorIsInTheWayHoweverSmall) {  // smaller than a cell of 0.25 m
  scene_.products.push_back({1, scene::no_facing, {4.31F, 2.02F, 0}, {1, 0, 0, 0}, 0});
  EXPECT_EQ(at(map_of(scene_), 4.31, 2.02), Nav2Cell::occupied);
  options_.resolution_m = 0.25;
  const exporters::Nav2Map coarse = map_of(scene_);
  EXPECT_EQ(std::ranges::count(coarse.cells, Nav2Cell::occupied) >
                std::ranges::count(map_of(HandMadeScene().scene).cells, Nav2Cell::occupied),
            true);
}

TEST_F(Nav2, TheCheckSeesAWallThatIsGoneAndOneTooMany) {
  write();
  ASSERT_EQ(fault(), "");
  EXPECT_TRUE(says(fault_with_cell("map.pgm", 3, 3.7, '\xfe'), "dry/run-1/module-1"));
  EXPECT_TRUE(says(fault_with_cell("map.pgm", 0.62, 0.62, '\xfe'), "0.625, 0.625 m is taken"));
  EXPECT_TRUE(says(fault_with_cell("map.pgm", 4.5, 2, '\0'), "4.525, 2.025 m is floor"));
  EXPECT_TRUE(says(fault_with_cell("map.pgm", -0.1, 2, '\xfe'), "outside the room"));
  const std::string picture = *io::read_file(folder_ / "shop_assets/map.pgm");
  ASSERT_TRUE(io::write_file(folder_ / "shop_assets/map.pgm", picture.substr(0, 900)).ok());
  EXPECT_TRUE(says(fault(), "pixels"));
}

TEST_F(Nav2, TheCheckSeesAMaskThatIsOpenClosedFastOrSlowInTheWrongPlace) {
  write();
  ASSERT_EQ(fault(), "");
  EXPECT_TRUE(says(fault_with_cell("keepout_mask.pgm", 3, 2, '\0'), "is shoppers' floor"));
  EXPECT_TRUE(says(fault_with_cell("keepout_mask.pgm", -0.2, 2, '\xff'), "is not for robots"));
  EXPECT_TRUE(says(fault_with_cell("speed_mask.pgm", 1.5, 0.5, '\xff'), "where people pass"));
  EXPECT_TRUE(says(fault_with_cell("speed_mask.pgm", 4.5, 2.5, '\x80'), "is open floor"));
  EXPECT_TRUE(says(fault_with_cell("speed_mask.pgm", 1.5, 0.5, '\0'), "has no speed"));
  replace("filters.yaml", "shop_assets/speed_mask.yaml", "shop_assets/map.yaml");
  EXPECT_TRUE(says(fault(), "no server loads speed_mask.yaml"));
}

TEST_F(Nav2, TheCheckSeesAWaypointInAShelfOneThatIsMissingAndAnotherRobot) {
  write();
  const std::string name = "dry/run-1/module-1/side-0";
  replace("waypoints.yaml", name, "dry/run-1/module-1/side-7");
  EXPECT_NE(fault().find(name + "\" is missing"), std::string::npos) << fault();
  write();
  replace("waypoints.yaml", "\"kind\": \"shelf\", \"x\": ", "\"kind\": \"shelf\", \"x\": 5");
  EXPECT_NE(fault().find("no room at \"" + name), std::string::npos) << fault();
  write();
  replace("waypoints.yaml", "robot_radius: 0.42", "robot_radius: 0.3");
  EXPECT_NE(fault().find("another radius"), std::string::npos) << fault();
  write();
  replace("waypoints.yaml", "\"yaw\": 1.5708, \"fixture\"", "\"yaw\": 0.0, \"fixture\"");
  EXPECT_TRUE(says(fault(), "at \"" + name + "\" the robot does not look at its shelf"));
  write();
  replace("waypoints.yaml", "\"categories\": [\"", "\"categories\": [\"no ");
  EXPECT_TRUE(says(fault(), "sells other categories"));
  write();
  replace("waypoints.yaml", "categories:\n  \"", "categories:\n  \"no ");
  EXPECT_TRUE(says(fault(), "names other places than sell it"));
  write();
  replace("waypoints.yaml", "\"kind\": \"shelf\"", "\"kind\": \"checkout\"");
  EXPECT_TRUE(says(fault(), "is no \"checkout\""));
  write();
  replace("keepout_mask.yaml", "resolution: 0.05", "resolution: 0.06");
  EXPECT_NE(fault().find("not those of the map"), std::string::npos) << fault();
}

TEST_F(Nav2, ARobotThatIsTooWideReachesNothing) {
  options_.robot_radius_m = 1.9;
  write();
  EXPECT_EQ(fault(), "");
  const auto read = exporters::read_nav2_waypoints(folder_ / "shop_assets/waypoints.yaml");
  ASSERT_TRUE(read.ok()) << to_string(read.error());
  EXPECT_TRUE(std::ranges::find(read->unreachable, "dry/run-1/module-1/side-0") !=
              read->unreachable.end());
}

}  // namespace
}  // namespace marketgen
