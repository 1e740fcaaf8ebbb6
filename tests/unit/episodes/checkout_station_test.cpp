// The station's rows: read, and in agreement with what the grasp study uses.
#include "episodes/checkout/checkout_station.h"

#include <gtest/gtest.h>

#include "robots/grasp_tool.h"

namespace marketgen {
namespace {

const std::filesystem::path station_data = std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data";

TEST(CheckoutStation, ItsBasketIsThatOfTheGraspStudy) {
  const auto station = episodes::load_checkout_station(station_data);
  ASSERT_TRUE(station.ok()) << to_string(station.error());
  const physics::OpenContainer made = station->container();
  EXPECT_EQ(made.top_x_m, physics::checkout_basket.top_x_m);
  EXPECT_EQ(made.top_y_m, physics::checkout_basket.top_y_m);
  EXPECT_EQ(made.height_m, physics::checkout_basket.height_m);
  EXPECT_EQ(made.taper_m, physics::checkout_basket.taper_m);
  EXPECT_EQ(made.ledge_width_m, physics::checkout_basket.ledge_width_m);
  EXPECT_EQ(made.ledge_height_m, physics::checkout_basket.ledge_height_m);
}

TEST(CheckoutStation, ItsRobotHasTheLongFingers) {
  const auto station = episodes::load_checkout_station(station_data);
  ASSERT_TRUE(station.ok());
  const auto robot = episodes::load_station_robot(station_data, *station);
  ASSERT_TRUE(robot.ok()) << to_string(robot.error());
  EXPECT_EQ(robot->tools.at(0).row, "panda-long-hand");
  const auto tool = robots::load_grasp_tool(station_data, "panda-long-hand");
  ASSERT_TRUE(tool.ok()) << to_string(tool.error());
  EXPECT_NEAR(tool->pad_x_m, 0.009, 1e-9);  // pads of 18 x 18 mm
  EXPECT_NEAR(tool->pad_z_m, 0.009, 1e-9);
  EXPECT_NEAR(tool->pad_center.z, 0, 1e-9);
}

}  // namespace
}  // namespace marketgen
