// The station's rows: read, and in agreement with what the grasp study uses.
#include "episodes/checkout/checkout_station.h"

#include <gtest/gtest.h>

#include "robots/grasp_tool.h"
#include "support/drawn_checkout.h"

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

TEST(CheckoutStation, TheStockOneHasWhatOneCanBuy) {
  const auto eased = episodes::load_checkout_station(station_data);
  const auto stock = episodes::load_checkout_station(station_data, "checkout-stock");
  ASSERT_TRUE(stock.ok()) << to_string(stock.error());
  EXPECT_EQ(stock->container().ledge_width_m, 0);
  EXPECT_EQ(stock->container().top_x_m, eased->container().top_x_m);
  EXPECT_EQ(stock->container().height_m, eased->container().height_m);
  const auto robot = episodes::load_station_robot(station_data, *stock);
  ASSERT_TRUE(robot.ok()) << to_string(robot.error());
  EXPECT_EQ(robot->tools.at(0).row, "panda-hand");
  EXPECT_LT(stock->basket_boxes().size(), eased->basket_boxes().size()) << "four ledges less";
}

TEST(CheckoutStation, EpisodesOfAnotherSayWhich) {
  const episodes::EpisodeSpec spec = drawn_by({.station = "checkout-stock"}, 7, 0);
  EXPECT_EQ(spec.station, "checkout-stock");
  EXPECT_TRUE(spec.id.starts_with("checkout-stock/")) << spec.id;
  EXPECT_FALSE(drawn(7, 0).station);
  auto eased = episodes::CheckoutWorld::create(data_rows(), committed_catalog().frictions);
  ASSERT_TRUE(eased.ok());
  const auto refused = eased->reset(spec, checkout_goods_rows());
  ASSERT_FALSE(refused.ok()) << "it is of another station";
  EXPECT_EQ(refused.error().code, "robot.unknown");
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
