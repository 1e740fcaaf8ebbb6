// The parts that the oracle is made of, on one drawn basket: what it knows of the scene, where it
// may grasp, where it may put down, and the executor that carries it out.
#include <gtest/gtest.h>

#include "episodes/checkout/checkout_goals.h"

#include <algorithm>

#include "oracle/oracle_checkout.h"
#include "oracle/oracle_grasps.h"
#include "oracle/oracle_places.h"
#include "oracle/oracle_witness.h"
#include "support/drawn_checkout.h"

namespace marketgen {
namespace {

template <class T>
T taken(Result<T> result) {
  if (!result.ok()) fatal(to_string(result.error()).c_str());
  return std::move(result).value();
}

// One basket, drawn once: drawing takes a second.
class OracleParts : public testing::Test {
 protected:
  OracleParts()
      : world_(taken(episodes::CheckoutWorld::create(data_rows(), committed_catalog().frictions))),
        tool_(taken(robots::load_grasp_tool(data_rows(), world_.station().tools().picks_with))) {
    const auto reset = world_.reset(spec(), checkout_goods_rows());
    if (!reset.ok()) fatal(to_string(reset.error()).c_str());
  }

  static const episodes::EpisodeSpec& spec() {
    static const episodes::EpisodeSpec made = drawn(3, 0);
    return made;
  }
  skills::ArmExecutor arm() const {
    skills::ArmExecutor made = taken(skills::ArmExecutor::make(world_.robot()));
    made.start(world_.observe());
    return made;
  }

  episodes::CheckoutWorld world_;
  robots::GraspTool tool_;
};

TEST_F(OracleParts, ItemsLieInTheBasketAndNotInTheArea) {
  const oracle::OracleScene scene(world_, tool_);
  for (std::size_t item = 0; item < scene.items(); ++item) {
    EXPECT_TRUE(scene.in_basket(item)) << item;
    EXPECT_FALSE(scene.in_unloading(item)) << item;
  }
}

TEST_F(OracleParts, AnItemOverlapsItselfAndNotThePlaceAboveIt) {
  const oracle::OracleScene scene(world_, tool_);
  const Vec3 middle = scene.middle(0);
  EXPECT_GT(skills::box_overlap(scene.body(0), {middle, {}}, {0.002, 0.002, 0.002}), 0.005);
  EXPECT_EQ(
      skills::box_overlap(scene.body(0), {middle + Vec3{0, 0, 0.5}, {}}, {0.002, 0.002, 0.002}), 0);
  EXPECT_EQ(scene.item_overlap(0, {0, 0, 0.5}, 1), 0);
}

TEST_F(OracleParts, GraspsComeFromAboveAndThoseWithoutBlockersFirst) {
  const oracle::OracleScene scene(world_, tool_);
  std::size_t with_grasps = 0;
  for (std::size_t item = 0; item < scene.items(); ++item) {
    const oracle::ItemGrasps grasps =
        oracle::item_grasps(scene, item, taken(oracle::lone_grasps(scene, item)));
    with_grasps += grasps.choices.empty() ? 0 : 1;
    EXPECT_TRUE(std::ranges::is_sorted(grasps.choices, {}, [](const oracle::GraspChoice& choice) {
      return choice.blockers.size();
    }));
    for (const oracle::GraspChoice& choice : grasps.choices) {
      EXPECT_LT(skills::tilt_deg(choice.base_from_tip.rotation), 65.5);
      EXPECT_GT(choice.opening_m, 0.02);
      EXPECT_LE(choice.opening_m, tool_.opening_m);
      EXPECT_FALSE(std::ranges::count(choice.blockers, item)) << "an item blocks itself";
    }
  }
  EXPECT_GE(2 * with_grasps, scene.items()) << "grasps were found for less than half of the items";
}

TEST_F(OracleParts, PlacesAreInTheAreaOverTheCounterAndInReach) {
  const oracle::OracleScene scene(world_, tool_);
  const skills::ArmExecutor executor = arm();
  std::size_t found = 0;
  for (std::size_t item = 0; item < scene.items(); ++item) {
    const oracle::ItemGrasps grasps =
        oracle::item_grasps(scene, item, taken(oracle::lone_grasps(scene, item)));
    if (grasps.choices.empty()) continue;
    const oracle::GraspChoice& grasp = grasps.choices.front();
    const skills::HeldPack held = oracle::held_pack(
        scene, item, inverse(grasp.base_from_tip) * world_.item_pose(item), grasp.opening_m);
    for (const skills::FreePlace& place :
         skills::free_places(tool_, executor, held, oracle::place_question(scene, item, true), 3)) {
      ++found;
      const episodes::EpisodeGoods& goods = world_.goods(item);
      EXPECT_TRUE(episodes::is_inside(world_.region(),
                                      {goods.product.sku,
                                       place.base_from_product,
                                       to_double(goods.body.center_of_mass),
                                       goods.volume}));
      for (const Vec3& point : goods.volume)
        EXPECT_GT((place.base_from_product * point).z, 0);
      EXPECT_TRUE(executor.effort_to(place.base_from_tip).has_value());
    }
  }
  EXPECT_GT(found, 0U);
}

// ---- The witness of a basket ----

TEST_F(OracleParts, AWitnessTakesEveryTargetOnceAndIsTheSameAgain) {
  const episodes::CheckoutCertifier certify = oracle::checkout_certifier(data_rows());
  const episodes::EpisodeSpec drawn = taken(episodes::sample_checkout(data_rows(),
                                                                      checkout_goods_rows(),
                                                                      committed_catalog().frictions,
                                                                      {"corner", "s", "p"},
                                                                      Seed(5),
                                                                      0,
                                                                      certify));
  EXPECT_EQ(std::ranges::count(drawn.certificate.proved, "reach"), 1);
  for (const episodes::EpisodeGoal& goal : drawn.goals)
    EXPECT_EQ(std::ranges::count(drawn.certificate.witness, goal.sku, &episodes::WitnessPick::sku),
              goal.count);
  ASSERT_TRUE(world_.reset(drawn, checkout_goods_rows()).ok());
  const auto once = taken(certify(world_, Seed(1))), again = taken(certify(world_, Seed(1)));
  ASSERT_TRUE(once && again);
  EXPECT_TRUE(std::ranges::equal(
      *once, *again, {}, &episodes::WitnessPick::product, &episodes::WitnessPick::product));
}

TEST_F(OracleParts, ABasketWithAPackThatNoHandSpansHasNoWitness) {
  const auto wide =
      std::ranges::find_if(committed_catalog().products, [](const catalog::Product& product) {
        const auto& size = product.size_mm;
        return product.archetype == "box" && std::ranges::min(size) > 90 &&
               std::ranges::max(size) < 200;
      });
  ASSERT_NE(wide, committed_catalog().products.end());
  episodes::EpisodeSpec basket = spec();
  basket.items = {{wide->sku, {0, 0, 0.01}, {1, 0, 0, 0}}};
  basket.goals = {{wide->sku, 1}};
  ASSERT_TRUE(world_.reset(basket, {*wide}).ok());
  EXPECT_FALSE(taken(oracle::checkout_certifier(data_rows())(world_, Seed(1))).has_value());
}

TEST_F(OracleParts, TheExecutorStopsOverAPlaceAndGoesStraightDown) {
  const oracle::OracleScene scene(world_, tool_);
  skills::ArmExecutor executor = arm();
  const skills::Surroundings around = scene.surroundings({});
  skills::ReachRequest request{executor.tip(), {0, 0, 0.08}, 0.08, 20};
  request.base_from_tip.position.z -= 0.1;
  request.stops_before = true;
  ASSERT_TRUE(executor.reach(around, request, Seed(1)).ok());
  const Pose over = request.base_from_tip * Pose{{0, 0, -0.08}, {}};
  EXPECT_LT(length(executor.tip().position - over.position), 1e-3);
  ASSERT_TRUE(executor.straight(around, request.base_from_tip, 0.08, 20).ok());
  EXPECT_LT(length(executor.tip().position - request.base_from_tip.position), 1e-3);
  int steps = 0;
  while (!executor.idle()) {
    executor.next(world_.observe());
    ASSERT_LT(++steps, 400) << "20 s for two short motions";
  }
}

TEST_F(OracleParts, LinesThroughTheCounterAreRefused) {
  const oracle::OracleScene scene(world_, tool_);
  skills::ArmExecutor executor = arm();
  Pose under = executor.tip();
  under.position.z = -0.1;
  const auto refused = executor.straight(scene.surroundings({}), under, 0.08, 20);
  ASSERT_FALSE(refused.ok());
  EXPECT_TRUE(executor.idle()) << "a refused motion was queued";
}

TEST(CheckoutRefusal, NamesWhatIsInTheWay) {
  catalog::Product pack;
  pack.archetype = "box";
  pack.size_mm = {60, 50, 120};
  pack.mass_kg = 0.3;
  EXPECT_EQ(episodes::checkout_refusal(pack), episodes::CheckoutRefusal::none);
  pack.archetype = "mesh";  // a model of one's own
  EXPECT_EQ(episodes::checkout_refusal(pack), episodes::CheckoutRefusal::none);
  pack.mass_kg = 1.5;
  EXPECT_EQ(episodes::checkout_refusal(pack), episodes::CheckoutRefusal::too_heavy);
  pack.mass_kg = 0.3;
  pack.size_mm = {90, 80, 120};
  EXPECT_EQ(episodes::checkout_refusal(pack), episodes::CheckoutRefusal::too_wide);
  pack.size_mm = {60, 20, 120};
  EXPECT_EQ(episodes::checkout_refusal(pack), episodes::CheckoutRefusal::too_flat);
  pack.size_mm = {60, 50, 400};
  EXPECT_EQ(episodes::checkout_refusal(pack), episodes::CheckoutRefusal::too_long);
  pack.size_mm = {60, 50, 120};
  pack.rigidity = catalog::Rigidity::soft;
  EXPECT_EQ(episodes::checkout_refusal(pack), episodes::CheckoutRefusal::soft);
  pack.archetype = "chub";  // a casing filled tight
  EXPECT_EQ(episodes::checkout_refusal(pack), episodes::CheckoutRefusal::none);
}

TEST(CheckoutRefusal, RoundGoodsAreTakenBesideTheirMiddle) {
  catalog::Product pack;
  pack.archetype = "box";
  pack.mass_kg = 0.2;
  pack.size_mm = {74, 74, 74};
  EXPECT_EQ(episodes::checkout_refusal(pack), episodes::CheckoutRefusal::none);
  pack.size_mm = {76, 76, 72};
  EXPECT_EQ(episodes::checkout_refusal(pack), episodes::CheckoutRefusal::too_wide);
  pack.archetype = "muffin";
  pack.material = "skin";
  EXPECT_EQ(episodes::checkout_refusal(pack), episodes::CheckoutRefusal::none) << "by its cup";
  pack.size_mm = {78, 78, 72};
  EXPECT_EQ(episodes::checkout_refusal(pack), episodes::CheckoutRefusal::too_wide);
  pack.archetype = "apple";
  pack.orientation = catalog::Orientation::any;
  EXPECT_EQ(episodes::checkout_refusal(pack), episodes::CheckoutRefusal::none);
  pack.size_mm = {80, 80, 78};
  EXPECT_EQ(episodes::checkout_refusal(pack), episodes::CheckoutRefusal::too_wide);
  pack.size_mm = {42, 40, 35};
  EXPECT_EQ(episodes::checkout_refusal(pack), episodes::CheckoutRefusal::none);
  pack.size_mm = {42, 40, 34};
  EXPECT_EQ(episodes::checkout_refusal(pack), episodes::CheckoutRefusal::small_round);
}

// It rehearses in a twin what it decides: what it does in the end is what it foresaw.
TEST_F(OracleParts, TheOracleEmptiesTheBasketWithoutHarm) {
  const auto oracle = taken(oracle::make_checkout_oracle(world_, data_rows(), Seed(1)));
  agent::Observation now = world_.observe();
  ASSERT_TRUE(oracle->begin({"Unload it", spec().limit_s}, now).ok());
  while (!world_.done()) {
    const agent::Action action = taken(oracle->act(now));
    now = taken(world_.step(action));
  }
  const episodes::EpisodeResult result = taken(world_.finish());
  EXPECT_TRUE(result.success_strict) << oracle->failure();
  EXPECT_TRUE(result.success_clean);
}

}  // namespace
}  // namespace marketgen
