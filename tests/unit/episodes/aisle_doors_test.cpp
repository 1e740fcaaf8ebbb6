// Goals behind doors: which goods they are, what a world of another variant says, and what of a
// door the ledger keeps.
#include <gtest/gtest.h>

#include "episodes/aisle/door_book.h"
#include "scene/placements.h"
#include "support/can_aisle.h"
#include "support/can_cooler.h"

namespace marketgen {
namespace {

TEST(AisleDoors, GoalsStandBehindDoorsOrBeforeNone) {
  EXPECT_EQ(can_cooler(episodes::Doors::hinged)->front_items("can-cola").size(), 4U);
  const auto without = can_cooler(episodes::Doors::none);
  EXPECT_TRUE(without->front_items("can-cola").empty());
  EXPECT_EQ(without->shelf_refusal(0), episodes::ShelfRefusal::behind_door);
  episodes::AisleStore open = *can_aisle();
  EXPECT_EQ(open.front_items("can-cola").size(), 4U);
  open.doors = episodes::Doors::hinged;
  EXPECT_EQ(open.shelf_refusal(0), episodes::ShelfRefusal::no_door);
}

TEST(AisleDoors, AWorldOfAnotherVariantRefusesTheEpisode) {
  const auto store = can_cooler(episodes::Doors::none);
  episodes::AisleWorld world(store, committed_catalog().frictions);
  const auto reset = world.reset(can_cooler_episode(*store, 1));
  ASSERT_FALSE(reset.ok());
  EXPECT_EQ(reset.error().code, "episode.bad_value");
  EXPECT_EQ(reset.error().where, "aisle/cooler/doors");
}

TEST(AisleDoors, ADoorIsOpenedAndShutByPlanOnce) {
  const auto store = can_cooler(episodes::Doors::hinged);
  episodes::DoorBook doors(store);
  const auto first = doors.before(0), again = doors.before(3);
  ASSERT_TRUE(first.ok()) << to_string(first.error());
  ASSERT_EQ(first->why_not, "");
  ASSERT_TRUE(first->row);
  EXPECT_EQ(first->row->id, "glass_door_cooler/door-2");
  EXPECT_EQ(first->past, again->past) << "it was planned anew";
  EXPECT_GT(first->store.joint(can_cooler_door), 1.4);
  EXPECT_EQ(first->way_m(first->opened_from, first->opened_from), 0.0);
}

// In the leaf's way nobody may stand, and before it is a way.
TEST(AisleDoors, NobodyStandsInTheOpenLeaf) {
  const auto store = can_cooler(episodes::Doors::hinged);
  episodes::DoorBook doors(store);
  const auto open = doors.before(0);
  ASSERT_TRUE(open.ok() && open->row);
  const auto door = collect::hinged_door(store->scene, can_cooler_door).value();
  const Vec3 beside = door.point_at(door.hold_rad, 0.5, 0, 0);
  const auto met = open->may_stand(Pose{beside, {}}, store->driving);
  ASSERT_FALSE(met.ok());
  EXPECT_EQ(met.error().code, "motion.base_blocked");
  EXPECT_TRUE(store->ways.space().free(floor_mm(open->opened_from)));
  EXPECT_TRUE(open->past->space().free(floor_mm(open->shut_from)));
}

// Whoever took an item backs off, and not into the leaf that stands open behind.
TEST(AisleDoors, NobodyBacksOffIntoTheOpenLeaf) {
  const auto store = can_cooler(episodes::Doors::hinged);
  episodes::DoorBook doors(store);
  const auto open = doors.before(0);
  ASSERT_TRUE(open.ok() && open->row);
  const auto door = collect::hinged_door(store->scene, can_cooler_door).value();
  // It looks along the shut door, away from the hinge, and the leaf stands behind it.
  const Pose before{door.point_at(0, 0.55, 0.7, 0),
                    rotation_about({0, 0, 1}, std::atan2(door.along.y, door.along.x))};
  const double shut = store->room_behind_m(before, store->ways),
               past = store->room_behind_m(before, open->ways());
  EXPECT_GT(shut, past);
  const auto backed = [&](double back_m) {
    return floor_mm(episodes::axle_of(store->robot, before * Pose{{-back_m, 0, 0}, {}}));
  };
  EXPECT_FALSE(open->past->space().free(backed(shut)));
  EXPECT_TRUE(past == 0 || open->past->space().free(backed(past)));
}

// A product that the plan has put somewhere stands on no shelf.
TEST(AisleDoors, APinnedProductIsAskedForNowhere) {
  HandMadeScene shop;
  const std::uint32_t row = shop.add(1, {2.8F, 1.0F, 0});
  shop.scene.products[row].facing = scene::no_facing;
  const auto store =
      episodes::open_aisle_store(std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data", shop.scene);
  ASSERT_TRUE(store.ok()) << to_string(store.error());
  EXPECT_EQ((*store)->shelf_refusal(row), episodes::ShelfRefusal::unshelved);
  EXPECT_TRUE((*store)->front_items("can-cola").empty());
}

}  // namespace
}  // namespace marketgen
