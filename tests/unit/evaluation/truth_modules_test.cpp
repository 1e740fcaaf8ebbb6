// The truth in place of `classical`'s modules: names of such policies, and that each module tells
// what is so.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "environments/policy_name.h"
#include "environments/run_episode.h"
#include "episodes/aisle/aisle_senses.h"
#include "episodes/pictured_products.h"
#include "oracle/aisle_truth.h"
#include "oracle/checkout_truth.h"
#include "oracle/oracle_scene.h"
#include "support/can_aisle.h"
#include "support/drawn_checkout.h"

namespace marketgen {
namespace {

TEST(PolicyName, HasItsModulesInOrder) {
  const auto plain = environments::read_policy_name("oracle");
  ASSERT_TRUE(plain.ok());
  EXPECT_TRUE(plain->truth.empty());
  const auto swapped = environments::read_policy_name("classical+grasp+masks+grasp");
  ASSERT_TRUE(swapped.ok());
  EXPECT_EQ(swapped->name, "classical");
  EXPECT_EQ(swapped->written(), "classical+masks+grasp");
  EXPECT_TRUE(swapped->knows(environments::TrueModule::masks));
  EXPECT_FALSE(swapped->knows(environments::TrueModule::target));
}

TEST(PolicyName, HasItsModel) {
  for (const char* name : {"vlm(openai:gpt-4o)",
                           "vlm(qwen:qwen3-vl-plus)+masks+language",
                           "vlm(openai:odd+name(2))+grasp"}) {
    const auto read = environments::read_policy_name(name);
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    EXPECT_EQ(read->name, "vlm");
    EXPECT_EQ(read->written(), name);
  }
  EXPECT_EQ(environments::read_policy_name("vlm(openai:odd+name(2))+grasp")->model,
            "openai:odd+name(2)");
}

TEST(PolicyName, HasItsParts) {
  for (const char* name :
       {"hybrid(masks=http://127.0.0.1:5002)",
        "hybrid(target=openai:gpt-4o,masks=http://[::1]:5002/a,grasps=https://x.org)+language",
        "hybrid(grasps=http://127.0.0.1:5001/process)+masks+target"}) {
    const auto read = environments::read_policy_name(name);
    ASSERT_TRUE(read.ok()) << to_string(read.error());
    EXPECT_EQ(read->name, "hybrid");
    EXPECT_EQ(read->written(), name);
  }
  EXPECT_EQ(environments::read_policy_name("hybrid(grasps=http://h:1/p)")->grasps_url,
            "http://h:1/p");
  EXPECT_EQ(environments::read_policy_name("hybrid(masks=ftp://h)").error().code, "net.bad_url");
}

TEST(PolicyName, WhatIsNotThereIsAnError) {
  for (const char* name : {"orakel",
                           "classical+eyes",
                           "oracle+masks",
                           "",
                           "vlm",
                           "vlm()",
                           "vlm(openai:x",
                           "vlm+masks",
                           "vlm(openai:x)+target",
                           "vlm(openai:x)grasp",
                           "classical(openai:x)",
                           "hybrid",
                           "hybrid()",
                           "hybrid(masks)",
                           "hybrid(masks=)",
                           "hybrid(eyes=http://h)",
                           "hybrid(masks=http://h,masks=http://g)",
                           "hybrid(masks=http://h)+masks",
                           "hybrid(grasps=http://h)+grasp",
                           "hybrid(target=openai:x)+target"}) {
    const auto read = environments::read_policy_name(name);
    ASSERT_FALSE(read.ok()) << name;
    EXPECT_EQ(read.error().code, "usage.bad_flag") << name;
  }
}

// A basket as `classical` sees it first.
class CheckoutTruth : public ::testing::Test {
 protected:
  CheckoutTruth()
      : spec_(drawn(7, 0)),
        world_(
            episodes::CheckoutWorld::create(data_rows(), committed_catalog().frictions).value()) {
    if (const auto reset = world_.reset(spec_, checkout_goods_rows()); !reset.ok())
      fatal(to_string(reset.error()).c_str());
    eyes_ = std::make_unique<episodes::CheckoutEyes>(world_);
    for (const episodes::StationCamera camera :
         {episodes::StationCamera::scene, episodes::StationCamera::wrist})
      views_.emplace_back(eyes_->look(name_of(camera)).value());
    products_ = std::make_unique<episodes::PicturedProducts>(checkout_goods_rows(),
                                                             committed_catalog().frictions);
  }

  perception::ProductLook look_of(const std::string& sku) {
    return perception::ProductLook::make(sku, products_->pictures({sku}).value().front()).value();
  }

  episodes::EpisodeSpec spec_;
  episodes::CheckoutWorld world_;
  std::unique_ptr<episodes::CheckoutEyes> eyes_;
  std::vector<perception::ViewCloud> views_;
  std::unique_ptr<episodes::PicturedProducts> products_;
};

// Every mask lies about one item, and no two about the same.
TEST_F(CheckoutTruth, MasksAreOfOneItemEach) {
  const std::vector<std::uint8_t> all(views_[0].size(), 1);
  const std::vector<perception::Mask> masks = oracle::TrueMasks(*eyes_).masks(views_[0], all);
  ASSERT_GT(masks.size(), 1U);
  EXPECT_LE(masks.size(), world_.item_count());
  const robots::GraspTool tool = oracle::load_checkout_tool(world_, data_rows()).value();
  const oracle::OracleScene scene(world_, tool);
  std::set<std::size_t> shown;
  for (const perception::Mask& mask : masks) {
    EXPECT_TRUE(std::ranges::is_sorted(mask.pixels));
    Vec3 middle{};
    for (const std::uint32_t pixel : mask.pixels)
      middle += to_double(views_[0].point(pixel)) / static_cast<double>(mask.pixels.size());
    std::size_t nearest = 0;
    for (std::size_t item = 0; item < scene.items(); ++item)
      if (length(scene.middle(item) - middle) < length(scene.middle(nearest) - middle))
        nearest = item;
    shown.insert(nearest);
  }
  EXPECT_GE(shown.size() + 1, masks.size());  // of one that shows a corner the middle may mislead
  EXPECT_TRUE(
      oracle::TrueMasks(*eyes_).masks(views_[0], std::vector<std::uint8_t>(all.size(), 0)).empty());
}

TEST_F(CheckoutTruth, TargetsLieWhereTheyLie) {
  std::vector<perception::ProductLook> looks;
  for (const episodes::EpisodeGoal& goal : spec_.goals)
    looks.push_back(look_of(goal.sku));
  std::vector<perception::WantedProduct> wanted;
  for (const perception::ProductLook& look : looks)
    wanted.push_back({&look, {}});
  const auto found = oracle::TrueTargets(world_).find(wanted, views_, {});
  ASSERT_EQ(found.size(), looks.size());
  for (const perception::FoundProduct& target : found) {
    const auto item =
        std::ranges::find(spec_.items, looks[target.look].sku(), &episodes::EpisodeItem::sku);
    const auto number = static_cast<std::size_t>(item - spec_.items.begin());
    EXPECT_LT(length(target.pose.base_from_product.position - world_.item_pose(number).position),
              1e-9);
  }
}

TEST_F(CheckoutTruth, GraspsAreOfWhatLiesThere) {
  const robots::GraspTool tool = oracle::load_checkout_tool(world_, data_rows()).value();
  const oracle::TrueGrasps source(world_, tool);
  std::size_t grasps = 0;
  for (std::size_t item = 0; item < world_.item_count(); ++item) {
    const agent::KnownProduct& known = *products_->product(world_.goods(item).product.sku).value();
    const std::vector<Vec3f> nothing;
    Pose near = world_.item_pose(item);
    near.position.x += 0.02;
    const auto there = source.grasps({known, near, {}, nothing});
    ASSERT_TRUE(there.ok()) << to_string(there.error());
    grasps += there->size();
    near.position.x += 1;
    EXPECT_TRUE(source.grasps({known, near, {}, nothing})->empty());
  }
  EXPECT_GT(grasps, 0U);
}

TEST(SlowTruthModules, AnEpisodeRunsWithAllOfThem) {
  episodes::EpisodeFile file = pool_file();
  episodes::EpisodeSpec& spec = file.episodes.front();
  spec.limit_s = 20;
  environments::Arena arena(data_rows(), file.header, committed_catalog());
  const auto result =
      environments::run_episode(arena, spec, "classical+masks+target+grasp+language");
  ASSERT_TRUE(result.ok()) << to_string(result.error());
  EXPECT_EQ(result->policy, "classical+masks+target+grasp+language");
  EXPECT_TRUE(result->detail.empty()) << result->detail;
}

// Cans on a board before the robot, in the frame of its base.
TEST(AisleTruth, ACanIsFoundWhereItStands) {
  episodes::EpisodeSpec spec = can_episode(*can_aisle());
  spec.categories = {{"can-cola", "beverages", 3.0, 3.0}};
  const auto world = can_world(spec);
  const std::uint32_t row = world->store().front_items("can-cola").front();
  const Pose can = world->world().product_pose(row);
  const episodes::StoreMap map(world->store());
  std::vector<perception::BoardAhead> boards;
  const Pose base_from_store = inverse(world->world_from_base());
  for (const agent::ShelfBoard& board : map.boards())
    boards.push_back({base_from_store * board.store_from_board,
                      board.width_m,
                      board.depth_m,
                      board.clearance_m});
  episodes::AisleEyes eyes(*world);
  std::vector<perception::ViewCloud> views;
  views.emplace_back(eyes.look("head_camera").value());
  episodes::PicturedProducts products(world->store().scene.catalog, committed_catalog().frictions);
  const perception::ProductLook look =
      perception::ProductLook::make("can-cola", products.pictures({"can-cola"}).value().front())
          .value();

  const auto spots = oracle::TrueSpots(*world).spots(views, boards, {});
  ASSERT_FALSE(spots.empty());
  const oracle::TrueShelfChoice choice(*world);
  const Pose near{base_from_store * can.position + Vec3{0.03, 0, 0}, can.rotation};
  const perception::FittedPose again = choice.again({&look}, views, near);
  EXPECT_EQ(again.evidence.score, 1);
  EXPECT_LT(length(world->world_from_base() * again.base_from_product.position - can.position),
            0.031);
  const Pose far{near.position + Vec3{0, 0, 1}, near.rotation};
  EXPECT_EQ(choice.again({&look}, views, far).evidence.score, 0);
  // What no picture shows is not told.
  EXPECT_TRUE(choice.find({&look, {}}, {}, boards, spots).empty());

  const robots::GraspTool tool = robots::load_grasp_tool(data_rows(), "parallel-gripper").value();
  const oracle::TrueShelfGrasps source(*world, tool);
  const agent::KnownProduct& known = *products.product("can-cola").value();
  const auto grasps = source.grasps({known, can, {}});
  ASSERT_TRUE(grasps.ok()) << to_string(grasps.error());
  ASSERT_FALSE(grasps->empty());
  EXPECT_LT(length(grasps->front().base_from_tip.position - can.position), 0.3);
}

}  // namespace
}  // namespace marketgen
