// What the classical policy senses in a store, and the whole of it: it looks for a can, finds it by
// its pictures, and brings it into its basket. No truth flag is on.
#include <gtest/gtest.h>

#include <algorithm>

#include "catalog/catalog.h"
#include "collect/collect_plan.h"
#include "environments/aisle/shared_aisle.h"
#include "episodes/aisle/aisle_senses.h"
#include "episodes/pictured_products.h"
#include "perception/goal_reader.h"
#include "policy/classical_aisle.h"
#include "support/can_aisle.h"
#include "support/drawn_checkout.h"

namespace marketgen {
namespace {

episodes::EpisodeSpec hinted_can_episode() {
  episodes::EpisodeSpec spec = can_episode(*can_aisle());
  spec.categories = {{"can-cola", "beverages", 3.0, 3.0}};
  return spec;
}

TEST(AisleSenses, TheHeadLooksOutOfItself) {
  const auto world = can_world(hinted_can_episode());
  episodes::AisleEyes eyes(*world);
  const auto view = eyes.look("head_camera");
  ASSERT_TRUE(view.ok()) << to_string(view.error());
  EXPECT_EQ(view->width(), 640);
  EXPECT_NEAR(view->base_from_camera.position.z, 1.70, 0.01);
  // 0 is what nothing was hit in: the street behind a window.
  const bool in_housing =
      std::ranges::any_of(view->depth_m, [](float depth) { return depth > 0 && depth < 0.3F; });
  EXPECT_FALSE(in_housing) << "its own head is in the picture";
  EXPECT_EQ(eyes.look("scene_camera").error().code, "usage.bad_flag");
}

// From where goals are drawn is not to be read off the map: boards too low and too high for it, of
// heaps and behind doors are on it like the others.
TEST(AisleSenses, TheMapHasEveryBoardOfTheStore) {
  const episodes::EpisodeFile file = pool_file();
  environments::Arena arena(data_rows(), file.header, committed_catalog());
  const auto store = environments::shared_aisle_store(arena, file.header.stores.front().scene_hash);
  ASSERT_TRUE(store.ok()) << to_string(store.error());
  const episodes::StoreMap map(**store);
  EXPECT_EQ(map.boards().size(), (*store)->scene.shelves.size());
  const episodes::ShelfRangeRow& drawn_from = (*store)->station.shelf;
  const auto count = [&](auto&& is) { return std::ranges::count_if(map.boards(), is); };
  EXPECT_GT(count([&](const agent::ShelfBoard& b) {
              return b.store_from_board.position.z < drawn_from.lowest_m;
            }),
            0);
  EXPECT_GT(count([&](const agent::ShelfBoard& b) {
              return b.store_from_board.position.z > drawn_from.highest_m;
            }),
            0);
  EXPECT_GT(count([](const agent::ShelfBoard& b) { return b.has_door; }), 0);
  EXPECT_GT(count([](const agent::ShelfBoard& b) { return !b.has_door; }), 0);
}

TEST(AisleSenses, TheMapHasRoomBeforeBoards) {
  const auto store = can_aisle();
  const episodes::StoreMap map(*store);
  const robots::BasePlace here{2.0, 1.6, 0};
  EXPECT_TRUE(map.has_room(here));
  EXPECT_FALSE(map.has_room({0.05, 0.05, 0}));
  EXPECT_NEAR(map.way_m(here, {2.5, 1.6, 0}).value(), 0.5, 2e-3);
  EXPECT_TRUE(map.way(here, {2.5, 1.6, 0}).ok());
  EXPECT_FALSE(map.way(here, {0.05, 0.05, 0}).ok());
}

// `classical` in a shop with cans, told of its goal as `told` says.
void expect_collects(const std::unique_ptr<episodes::AisleWorld>& world,
                     const agent::TaskGoal& told,
                     std::unique_ptr<perception::GoalReader> reader) {
  const episodes::AisleStore& store = world->store();
  episodes::AisleEyes eyes(*world);
  const episodes::StoreMap map(store);
  episodes::PicturedProducts products(store.scene.catalog, committed_catalog().frictions);
  perception::LookLibrary looks;
  policy::ClassicalAisleSetup setup;
  setup.eyes = &eyes;
  setup.products = &products;
  setup.looks = &looks;
  setup.tool = robots::load_grasp_tool(std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data",
                                       collect::gripper_row(store.robot).value())
                   .value();
  setup.hints = episodes::category_hints(world->spec());
  setup.body = {
      &store.robot, &map, store.basket, store.driving, episodes::commanded_dofs(store.robot)};
  setup.modules.language = std::move(reader);
  const auto policy = policy::make_classical_aisle(std::move(setup), Seed(3));
  ASSERT_NE(policy->decisions(), nullptr);
  policy->decisions()->keep();
  agent::Observation now = world->observe();
  ASSERT_TRUE(policy->begin({"Collect cans", world->spec().limit_s, {told}}, now).ok());
  while (!world->done()) {
    const auto action = policy->act(now);
    ASSERT_TRUE(action.ok()) << to_string(action.error());
    const auto next = world->step(*action);
    ASSERT_TRUE(next.ok()) << to_string(next.error());
    now = *next;
  }
  const auto result = world->finish();
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_TRUE(result->success_strict) << policy->failure() << " after " << result->simulated_s;
  EXPECT_EQ(policy->failure(), "None");
  EXPECT_EQ(world->in_basket().size(), static_cast<std::size_t>(told.count));
  const auto times = [&](agent::DecisionKind kind, std::string_view outcome) {
    return std::ranges::count_if(policy->decisions()->decisions(), [&](const auto& decision) {
      return decision.kind == kind && decision.outcome == outcome;
    });
  };
  EXPECT_EQ(times(agent::DecisionKind::read, "None"), 1);
  EXPECT_GE(times(agent::DecisionKind::look, "None"), told.count);
  EXPECT_GE(times(agent::DecisionKind::reach, "None"), told.count);
  EXPECT_EQ(times(agent::DecisionKind::place, "None"), told.count);
  EXPECT_EQ(times(agent::DecisionKind::stop, "None"), 1);
}

TEST(ClassicalAisle, FindsACanAndFetchesIt) {
  expect_collects(can_world(hinted_can_episode()), {"can-cola", 1}, nullptr);
}

// Of the second one nothing is seen before the first has been taken.
TEST(SlowClassicalAisle, TakesTheOneThatStoodBehind) {
  episodes::EpisodeSpec spec = hinted_can_episode();
  spec.goals = {{"can-cola", 2}};
  spec.limit_s = 300;
  expect_collects(can_world(spec, can_aisle(1, 2)), {"can-cola", 2}, nullptr);
}

TEST(SlowClassicalAisle, FetchesTwoThatItIsToldOfInWords) {
  episodes::EpisodeSpec spec = hinted_can_episode();
  spec.instructions = episodes::Instructions::words;
  spec.goals = {{"can-cola", 2, "two cans of cola"}};
  spec.limit_s = 300;
  expect_collects(can_world(spec),
                  {"", 2, "two cans of cola"},
                  std::make_unique<perception::CatalogueReader>(
                      can_aisle()->scene.catalog, committed_catalog().search_lexicon));
}

}  // namespace
}  // namespace marketgen
