// Checkout Unloading at a lane of a store: how the station stands there, what is round it, and that
// an episode is there what it is in the room.
#include "episodes/checkout/checkout_lanes.h"

#include <gtest/gtest.h>

#include <set>

#include "episodes/checkout/checkout_senses.h"
#include "layout/route.h"
#include "render/picture_objects.h"
#include "scene/scene_file.h"
#include "support/drawn_checkout.h"
#include "support/hand_laid_shop.h"

namespace marketgen {
namespace {

constexpr char lane_id[] = "checkout/run-1/module-1";

// The lane between snacks and canned goods, 3.5 m apart from middle to middle; the last shelf
// stands farther away than what is still round the lane.
HandLaidShop shop_with_lane() {
  return shop_of({"snacks", "checkout", "canned", "household"});
}

scene::Scene stocked(const HandLaidShop& shop) {
  auto built = scene::build_scene(shop.layout, shop.plan, committed_catalog(), Seed(1));
  if (!built.ok()) fatal(to_string(built.error()).c_str());
  return std::move(built).value();
}

const scene::Scene& store_with_lane() {
  static const scene::Scene scene = stocked(shop_with_lane());
  return scene;
}

const episodes::CheckoutStation& station_row() {
  static const episodes::CheckoutStation row = episodes::load_checkout_station(data_rows()).value();
  return row;
}

episodes::EpisodeSpec spec_at_lane(std::uint64_t seed = 7) {
  episodes::EpisodeSpec spec = drawn(seed, 0);
  spec.lane = lane_id;
  return spec;
}

std::shared_ptr<const episodes::CheckoutPlace> the_lane() {
  static const auto place = [] {
    auto made = episodes::checkout_at_lane(
        station_row(), store_with_lane(), committed_catalog(), lane_id, "test");
    if (!made.ok()) fatal(to_string(made.error()).c_str());
    return std::make_shared<const episodes::CheckoutPlace>(std::move(made).value());
  }();
  return place;
}

episodes::CheckoutWorld opened(const episodes::EpisodeSpec& spec) {
  auto world = episodes::CheckoutWorld::create(data_rows(), committed_catalog().frictions).value();
  const auto reset = world.reset(spec, checkout_goods_rows(), spec.lane ? the_lane() : nullptr);
  if (!reset.ok()) fatal(to_string(reset.error()).c_str());
  return world;
}

void wait(episodes::CheckoutWorld& world, int steps) {
  const agent::Action still = episodes::still_action(world.observe());
  for (int i = 0; i < steps; ++i)
    ASSERT_TRUE(world.step(still).ok());
}

// The counter's middle is the lane's; X is towards the passage, Y to where shoppers queue.
TEST(CheckoutLanes, TheStationStandsInTheLaneAsTheCashierSat) {
  HandLaidShop shop = shop_with_lane();
  const auto lane = std::ranges::find(shop.layout.fixtures, lane_id, &layout::Fixture::id);
  ASSERT_NE(lane, shop.layout.fixtures.end());
  const episodes::CounterRow& c = station_row().counter;
  for (const bool along_x : {false, true}) {
    if (along_x) std::swap(lane->width_mm, lane->depth_mm);
    for (const int yaw_deg : {0, 90, 180, 270}) {
      lane->yaw_deg = yaw_deg;
      const episodes::StationPlace place = episodes::place_at_lane(station_row(), *lane);
      const Pose store_from_floor{place.origin, yaw_from_quarter_turns(place.quarter_turns)};
      const Vec3 middle = store_from_floor *
                          Vec3{(c.low_m[0] + c.high_m[0]) / 2, (c.low_m[1] + c.high_m[1]) / 2, 0};
      EXPECT_NEAR(middle.x, lane->x_mm * 1e-3, 1e-9);
      EXPECT_NEAR(middle.y, lane->y_mm * 1e-3, 1e-9);
      const layout::PayingPlace paying =
          layout::paying_places(shop.layout, committed_catalog()).at(0);
      const auto in_station = [&](PointMm at) {
        return inverse(store_from_floor) * Vec3{at[0] * 1e-3, at[1] * 1e-3, 0};
      };
      EXPECT_GT(in_station(paying.till).x, c.high_m[0]) << yaw_deg << along_x;
      EXPECT_GT(in_station(paying.queue).y, in_station(paying.till).y + 1) << yaw_deg << along_x;
    }
  }
}

TEST(CheckoutLanes, TheCounterTakesTheLanesPlaceAmongItsNeighbours) {
  const episodes::CheckoutWorld world = opened(spec_at_lane());
  const scene::Scene& scene = world.scene();
  const auto checked = scene::check_indices(scene, "lane");
  ASSERT_TRUE(checked.ok()) << to_string(checked.error());
  const layout::Fixture& counter = scene.layout.fixtures.back();
  const layout::Fixture& lane = *layout::find_fixture(store_with_lane().layout, lane_id);
  EXPECT_EQ(counter.id, lane_id);
  EXPECT_TRUE(layout::footprint_of(lane).contains(layout::footprint_of(counter)));
  EXPECT_EQ(std::ranges::count(scene.layout.fixtures, lane_id, &layout::Fixture::id), 1);
  EXPECT_EQ(std::ranges::count(scene.parts, assets::UnitKind::scanner, &scene::ScenePart::unit), 0);
  EXPECT_GT(std::ranges::count(
                store_with_lane().parts, assets::UnitKind::scanner, &scene::ScenePart::unit),
            0);
  for (const auto& [id, stays] : {std::pair{"snacks/run-1/module-1", true},
                                  {"canned/run-1/module-1", true},
                                  {"household/run-1/module-1", false}})
    EXPECT_EQ(layout::find_fixture(scene.layout, id) != nullptr, stays) << id;
  EXPECT_GT(scene.products.size(), world.item_count() + 50);
  EXPECT_EQ(scene.layout.shell.width_mm, store_with_lane().layout.shell.width_mm);
}

TEST(CheckoutLanes, AnEpisodeBeginsAndEndsThereAsInTheRoom) {
  episodes::CheckoutWorld lane = opened(spec_at_lane()), room = opened(drawn(7, 0));
  ASSERT_EQ(lane.item_count(), room.item_count());
  for (std::size_t i = 0; i < room.item_count(); ++i) {
    EXPECT_LT(length(lane.item_pose(i).position - room.item_pose(i).position), 1e-6);
    EXPECT_EQ(lane.scene().catalog[lane.scene().products[lane.product_of(i)].sku].sku,
              lane.spec().items[i].sku);
  }
  wait(lane, 20);
  EXPECT_LE(lane.deepest_overlap_m(), 0.002);
  const auto result = lane.finish();
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_EQ(result->hits, 0);
  EXPECT_TRUE(episodes::is_clean(result->side_effects));
  EXPECT_EQ(result->side_effects.displaced, 0);
  for (std::size_t i = 0; i < room.item_count(); ++i)
    EXPECT_LT(length(lane.item_pose(i).position - room.item_pose(i).position), 0.003);
  EXPECT_TRUE(lane.moved_neighbours().empty());
}

TEST(CheckoutLanes, GoingOnFromASavedMomentGivesTheSameState) {
  episodes::CheckoutWorld world = opened(spec_at_lane());
  wait(world, 5);
  const std::string moment = world.save();
  wait(world, 5);
  const std::string end = world.state_hash();
  episodes::CheckoutWorld other = opened(spec_at_lane());
  ASSERT_TRUE(other.restore(moment).ok());
  wait(other, 5);
  EXPECT_EQ(other.state_hash(), end);
  EXPECT_EQ(opened(drawn(7, 0)).restore(moment).error().code, "physics.bad_command");
}

TEST(CheckoutLanes, PicturesShowTheItemsAndTheStoreBehind) {
  const episodes::CheckoutWorld world = opened(spec_at_lane());
  episodes::CheckoutEyes eyes(world);
  const auto looked = eyes.look("scene_camera");
  ASSERT_TRUE(looked.ok()) << to_string(looked.error());
  const std::vector<int>& shown = eyes.items_shown("scene_camera");
  std::set<int> items(shown.begin(), shown.end());
  items.erase(-1);
  EXPECT_GE(items.size(), world.item_count() / 2);
  EXPECT_LT(*items.rbegin(), static_cast<int>(world.item_count()));
  auto view = episodes::CheckoutView::create(world).value();
  render::Camera ahead = view->camera(episodes::StationCamera::scene, 64, 48);
  ahead.at = world.store_from_station() * Vec3{3.2, 0, 0.1};  // over the passage
  const auto frame = view->renderer().render(ahead, {});
  ASSERT_TRUE(frame.ok()) << to_string(frame.error());
  const auto& fixtures = world.scene().layout.fixtures;
  const auto shelf = std::ranges::find(fixtures, "canned", &layout::Fixture::zone);
  ASSERT_NE(shelf, fixtures.end());
  const auto object =
      render::first_fixture_object + static_cast<std::uint32_t>(shelf - fixtures.begin());
  EXPECT_GT(std::ranges::count(frame->instance, object), 0);
}

TEST(CheckoutLanes, ALaneThatTheStoreDoesNotHaveIsAnError) {
  const auto made = episodes::checkout_at_lane(
      station_row(), store_with_lane(), committed_catalog(), "checkout/run-1/module-2", "e/lane");
  ASSERT_FALSE(made.ok());
  EXPECT_EQ(made.error().code, "episode.other_store");
  EXPECT_EQ(made.error().where, "e/lane");
  EXPECT_NE(made.error().message.find(lane_id), std::string::npos) << made.error().message;
  // A shelf is no lane.
  EXPECT_EQ(episodes::checkout_at_lane(
                station_row(), store_with_lane(), committed_catalog(), "snacks/run-1/module-1", "e")
                .error()
                .code,
            "episode.other_store");
  auto world = episodes::CheckoutWorld::create(data_rows(), committed_catalog().frictions).value();
  EXPECT_EQ(world.reset(spec_at_lane(), checkout_goods_rows()).error().code, "episode.other_store");
  EXPECT_EQ(world.reset(drawn(7, 0), checkout_goods_rows(), the_lane()).error().code,
            "episode.other_store");
}

// A shelf stands at the cashier's back, then a column there.
TEST(CheckoutLanes, WithoutRoomTheEpisodeIsInTheRoomAndItIsSaidWhy) {
  for (const bool column : {false, true}) {
    HandLaidShop shop = shop_with_lane();
    const layout::Fixture& lane = *layout::find_fixture(shop.layout, lane_id);
    if (column)
      shop.layout.shell.columns.push_back({lane.x_mm - 700, lane.y_mm, 300});
    else
      std::ranges::find(shop.layout.fixtures, "snacks", &layout::Fixture::zone)->x_mm =
          lane.x_mm - 1250;
    const scene::Scene store = stocked(shop);
    const episodes::CheckoutLanes lanes =
        episodes::checkout_lanes(store, committed_catalog(), station_row());
    EXPECT_TRUE(lanes.suited.empty());
    ASSERT_EQ(lanes.left_out.size(), 1U);
    EXPECT_EQ(lanes.left_out[0].lane, lane_id);
    EXPECT_NE(lanes.left_out[0].reason.find(column ? "column" : "snacks/run-1/module-1"),
              std::string::npos)
        << lanes.left_out[0].reason;
    EXPECT_FALSE(episodes::at_a_lane(drawn(7, 0), lanes).lane);
    const auto made = episodes::checkout_at_lane(
        station_row(), store, committed_catalog(), lane_id, "episode/lane");
    EXPECT_EQ(made.error().code, "episode.impossible");
  }
}

TEST(CheckoutLanes, ALaneIsDrawnAndAllElseStays) {
  const episodes::CheckoutLanes found =
      episodes::checkout_lanes(store_with_lane(), committed_catalog(), station_row());
  EXPECT_EQ(found.suited, std::vector<std::string>{lane_id});
  EXPECT_TRUE(found.left_out.empty());
  const episodes::CheckoutLanes two{{"a", "b"}, {}};
  std::set<std::string> lanes;
  episodes::EpisodeSpec spec = drawn(7, 0);
  for (spec.seed = 1; spec.seed <= 20; ++spec.seed) {
    episodes::EpisodeSpec there = episodes::at_a_lane(spec, two);
    ASSERT_TRUE(there.lane);
    lanes.insert(*there.lane);
    EXPECT_EQ(episodes::at_a_lane(spec, two).lane, there.lane);
    there.lane.reset();
    EXPECT_EQ(episodes::write_episodes({{}, {there}}), episodes::write_episodes({{}, {spec}}));
  }
  EXPECT_EQ(lanes, (std::set<std::string>{"a", "b"}));
}

}  // namespace
}  // namespace marketgen
