// Stage::open: drawn before a door that is pulled open, the hand before its bar.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "episodes/aisle/aisle_world.h"
#include "episodes/aisle/door_stage.h"
#include "io/json.h"
#include "support/can_cooler.h"

namespace marketgen {
namespace {

using episodes::DoorStages;

const episodes::EpisodeOrigin room{"cooler", "0123456789abcdef0123456789abcdef", ""};

class DoorStage : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    store_ = can_cooler(episodes::Doors::hinged);
    stages_ = std::make_unique<DoorStages>(store_);
  }
  static void TearDownTestSuite() {
    stages_.reset();
    store_.reset();
  }
  static episodes::EpisodeSpec drawn(std::uint64_t seed) {
    auto spec = stages_->draw(room, Seed(seed));
    if (!spec.ok()) fatal(to_string(spec.error()).c_str());
    return *spec;
  }
  static std::shared_ptr<const episodes::AisleStore> store_;
  static std::unique_ptr<DoorStages> stages_;
};
std::shared_ptr<const episodes::AisleStore> DoorStage::store_;
std::unique_ptr<DoorStages> DoorStage::stages_;

TEST_F(DoorStage, IsOfTheDoorBeforeGoodsAndOfItsSeed) {
  const episodes::EpisodeSpec spec = drawn(1);
  const auto door = episodes::witnessed_door(*store_, spec);
  ASSERT_TRUE(door.ok()) << to_string(door.error());
  EXPECT_EQ(*door, can_cooler_door) << "no goods are behind the other";
  EXPECT_EQ(io::write_json(spec), io::write_json(drawn(1)));
  EXPECT_NE(io::write_json(spec), io::write_json(drawn(2)));
  const episodes::FloorPlaceRow stand = spec.certificate.witness.front().base;
  EXPECT_LE(std::abs(spec.start.x_m - stand.x_m), 0.01);
  EXPECT_LE(std::abs(spec.start.y_m - stand.y_m), 0.01);
  EXPECT_LE(std::abs(std::remainder(spec.start.heading_deg - stand.heading_deg, 360)), 1);
}

TEST_F(DoorStage, BeginsWithTheOpenHandSixCentimetresBeforeTheBar) {
  const episodes::EpisodeSpec spec = drawn(3);
  const auto posture = stages_->hand_before_bar(spec);
  ASSERT_TRUE(posture.ok()) << to_string(posture.error());
  episodes::AisleWorld world(store_, committed_catalog().frictions);
  const auto reset = world.reset(spec, {}, {}, *posture);
  ASSERT_TRUE(reset.ok()) << to_string(reset.error());
  const auto seen = episodes::door_seen(world);
  ASSERT_TRUE(seen.ok()) << to_string(seen.error());
  // 6 cm off it, and where the robot stands 1 cm and 1 degree off a metre before it.
  EXPECT_NEAR(length(seen->to_bar), 0.06, 0.035);
  EXPECT_NEAR(seen->behind_rad, -25 * std::numbers::pi / 180, 3 * std::numbers::pi / 180)
      << "the hand is turned ahead of the leaf";
  const Vec3 way = seen->to_bar;
  EXPECT_GT(way.x * std::cos(seen->into_rad) + way.y * std::sin(seen->into_rad), 0.03)
      << "the bar is ahead as the leaf stands";
  EXPECT_EQ(seen->position_rad, 0);
  EXPECT_FALSE(seen->held);
  EXPECT_TRUE(seen->clean);
  EXPECT_EQ(seen->side < 0, seen->arm == "right_arm") << "the arm on the hinge's side pulls";
}

TEST_F(DoorStage, AWitnessWithoutADoorIsSaid) {
  episodes::EpisodeSpec spec = drawn(1);
  spec.certificate.witness.front().door.reset();
  const auto posture = stages_->hand_before_bar(spec);
  ASSERT_FALSE(posture.ok());
  EXPECT_EQ(posture.error().code, "episode.impossible");
}

TEST(DoorStages, AStoreWithoutGoodsBehindDoorsHasNone) {
  scene::Scene scene = can_cooler_scene();
  scene.products.clear();
  scene.facings.clear();
  auto store = episodes::open_aisle_store(std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data",
                                          std::move(scene),
                                          {},
                                          episodes::Doors::hinged);
  ASSERT_TRUE(store.ok());
  const auto spec = DoorStages(*store).draw(room, Seed(1));
  ASSERT_FALSE(spec.ok());
  EXPECT_EQ(spec.error().code, "episode.impossible");
}

}  // namespace
}  // namespace marketgen
