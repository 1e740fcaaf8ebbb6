// Worlds that are a little other than their episode says: within their limits, repeatable, and for
// oracles the truth.
#include "episodes/perturbation.h"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>
#include <string>

#include "episodes/aisle/perturbed_aisle.h"
#include "io/file.h"
#include "support/realistic_worlds.h"

namespace marketgen {
namespace {

constexpr double degree = std::numbers::pi / 180;

episodes::Perturbation perturbation(std::uint64_t seed, episodes::PerturbationSizes sizes = {}) {
  return {sizes, Seed(seed)};
}

double turn_rad(const Pose& from, const Pose& to) {
  const Quaternion turn = inverse(from.rotation) * to.rotation;
  return 2 * std::atan2(std::hypot(turn.x, turn.y, turn.z), std::abs(turn.w));
}

TEST(Perturbation, KeepsWithinItsLimitsAndUsesThem) {
  const Pose stood{{1, 2, 3}, rotation_about({1, 0, 0}, 0.7)};
  double farthest = 0, max_turned = 0;
  for (int i = 0; i < 500; ++i) {
    const Pose now = perturbation(7).moved(stood, "item-" + std::to_string(i));
    const Vec3 way = now.position - stood.position;
    ASSERT_LE(std::abs(way.x), 0.005);
    ASSERT_LE(std::abs(way.y), 0.005);
    ASSERT_EQ(way.z, 0);
    const double turned = turn_rad(stood, now);
    ASSERT_LE(turned, degree + 1e-9);
    farthest = std::max(farthest, std::abs(way.x));
    max_turned = std::max(max_turned, turned);
  }
  EXPECT_GT(farthest, 0.0045);
  EXPECT_GT(max_turned, 0.9 * degree);
}

TEST(Perturbation, IsAFunctionOfSeedAndName) {
  const Pose stood{};
  const auto x = [&](std::uint64_t seed, const char* name) {
    return perturbation(seed).moved(stood, name).position.x;
  };
  EXPECT_EQ(x(1, "a"), x(1, "a"));
  EXPECT_NE(x(1, "a"), x(1, "b"));
  EXPECT_NE(x(1, "a"), x(2, "a"));
  EXPECT_NEAR(perturbation(1).moved(stood, "a", 0.25).position.x, x(1, "a") / 4, 1e-15);
}

TEST(Perturbation, FrictionsAndMassesKeepWithinTheirs) {
  const std::vector<catalog::FrictionRow>& rows = committed_catalog().frictions;
  const std::vector<catalog::FrictionRow> rubs = perturbation(3).frictions(rows);
  ASSERT_EQ(rubs.size(), rows.size());
  std::set<double> factors;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double factor = rubs[i].sliding / rows[i].sliding;
    EXPECT_NEAR(factor, 1, 0.2 + 1e-12);
    factors.insert(factor);
  }
  EXPECT_GT(factors.size(), rows.size() / 2);
  std::vector<catalog::FrictionRow> turned = rows;
  for (catalog::FrictionRow& row : turned)
    std::swap(row.a, row.b);
  EXPECT_EQ(perturbation(3).frictions(turned).front().sliding, rubs.front().sliding);
  for (const double factor : perturbation(3).mass_factors(committed_catalog().products))
    ASSERT_NEAR(factor, 1, 0.1);
}

// ---- At the counter ----

episodes::CheckoutWorld world_of(const episodes::EpisodeSpec& spec,
                                 const std::optional<episodes::Perturbation>& perturbation) {
  auto made = episodes::CheckoutWorld::create(data_rows(), committed_catalog().frictions);
  if (!made.ok()) fatal(to_string(made.error()).c_str());
  const auto reset = made->reset(spec, checkout_goods_rows(), nullptr, perturbation);
  if (!reset.ok()) fatal(to_string(reset.error()).c_str());
  return std::move(made).value();
}

TEST(PerturbedCheckout, ThingsLieALittleElsewhereAndApart) {
  const episodes::EpisodeSpec spec = drawn(7, 0);
  const episodes::CheckoutWorld was = world_of(spec, {});
  bool basket_moved = false;
  double moved_m = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    episodes::CheckoutWorld world = world_of(spec, perturbation(seed));
    const Vec3 way = world.basket_pose().position - was.basket_pose().position;
    EXPECT_LE(std::max(std::abs(way.x), std::abs(way.y)), 0.005);
    basket_moved = basket_moved || length(way) > 0.001;
    ASSERT_EQ(world.item_count(), spec.items.size());
    for (std::size_t i = 0; i < world.item_count(); ++i) {
      const Pose before = spec.items[i].pose(),
                 now = inverse(world.basket_pose()) * world.item_pose(i);
      EXPECT_LT(length(now.position - before.position), 0.05) << i;  // they settle
      moved_m += length(now.position - before.position);
      EXPECT_LT(length(now.position - world.spec().items[i].pose().position), 1e-9);
    }
    const auto stepped = world.step(episodes::still_action(world.observe()));
    ASSERT_TRUE(stepped.ok()) << to_string(stepped.error());
    EXPECT_LT(world.deepest_overlap_m(), 0.004);
    EXPECT_NEAR(world.time_s(), 0.05, 1e-9) << "what it took to settle is no part of the episode";
  }
  EXPECT_TRUE(basket_moved);
  EXPECT_GT(moved_m / static_cast<double>(3 * spec.items.size()), 0.0005);
}

TEST(PerturbedCheckout, RepeatsBitForBitAndInItsTwin) {
  const episodes::EpisodeSpec spec = drawn(7, 1);
  episodes::CheckoutWorld one = world_of(spec, perturbation(5)),
                          again = world_of(spec, perturbation(5));
  EXPECT_EQ(one.state_hash(), again.state_hash());
  const auto twin = one.twin();
  ASSERT_TRUE(twin.ok()) << to_string(twin.error());
  EXPECT_EQ((*twin)->state_hash(), one.state_hash());
  for (episodes::TrackWorld* world : {static_cast<episodes::TrackWorld*>(&one),
                                      static_cast<episodes::TrackWorld*>(twin->get())}) {
    agent::Action action = episodes::still_action(world->observe());
    action.position[1] += 0.05;
    ASSERT_TRUE(world->step(action).ok());
  }
  EXPECT_EQ((*twin)->state_hash(), one.state_hash()) << "masses and frictions are the same";
  EXPECT_NE(world_of(spec, perturbation(6)).state_hash(), again.state_hash());
  EXPECT_NE(world_of(spec, {}).state_hash(), again.state_hash());
}

// What a policy is told of goods stays what their rows say; what moves weighs something else.
TEST(PerturbedCheckout, GoodsWeighWhatWasDrawn) {
  const episodes::EpisodeSpec spec = drawn(7, 0);
  const episodes::Perturbation other = perturbation(9);
  const episodes::CheckoutWorld world = world_of(spec, other);
  double told = 0, weighs = 0, least = 0;
  for (std::size_t i = 0; i < world.item_count(); ++i) {
    const double mass = world.goods(i).product.mass_kg;
    const double factor = other.mass_factors({world.goods(i).product}).front();
    told += mass;
    weighs += mass * factor;
    least = std::max(least, std::abs(factor - 1));
  }
  ASSERT_GT(least, 0.01);
  double of_bodies = 0, as_told = 0;
  const episodes::CheckoutWorld was = world_of(spec, {});
  for (int body = 1; body < static_cast<int>(world.model().nbody); ++body) {
    of_bodies += world.model().body_mass[body];
    as_told += was.model().body_mass[body];
  }
  EXPECT_NEAR(of_bodies - as_told, weighs - told, 1e-9);
}

// ---- In the aisles ----

TEST(PerturbedAisle, PacksStandALittleElsewhereAndApart) {
  const std::shared_ptr<const episodes::AisleStore> store = can_aisle();
  const auto other = episodes::perturbed_store(*store, perturbation(2));
  ASSERT_EQ(other->scene.products.size(), store->scene.products.size());
  int moved = 0;
  for (std::size_t row = 0; row < store->scene.products.size(); ++row) {
    const Pose stood = scene::world_from_product(store->scene.products[row]),
               stands = scene::world_from_product(other->scene.products[row]);
    const Vec3 way = stands.position - stood.position;
    EXPECT_LE(std::abs(way.x), 0.005 + 1e-6);
    EXPECT_LE(std::abs(way.y), 0.005 + 1e-6);
    EXPECT_NEAR(way.z, 0, 1e-6);
    EXPECT_LE(turn_rad(stood, stands), degree + 1e-3);
    moved += length(way) > 0.0005 ? 1 : 0;
  }
  EXPECT_GE(moved, 3) << "cans that stand 40 mm apart";
}

TEST(PerturbedAisle, RepeatsBitForBitAndInItsTwin) {
  const auto store = can_aisle();
  const episodes::EpisodeSpec spec = can_episode(*store);
  episodes::AisleWorld one(store, committed_catalog().frictions),
      again(store, committed_catalog().frictions);
  ASSERT_TRUE(one.reset(spec, perturbation(4)).ok());
  ASSERT_TRUE(again.reset(spec, perturbation(4)).ok());
  const auto twin = one.twin();
  ASSERT_TRUE(twin.ok()) << to_string(twin.error());
  const auto where = [](const episodes::AisleWorld& world) {
    return world.world().product_pose(0).position;
  };
  EXPECT_EQ(where(one).x, where(again).x);
  EXPECT_EQ(where(one).x, where(**twin).x);
  EXPECT_EQ(one.state_hash(), (*twin)->state_hash());
  ASSERT_TRUE(again.reset(spec).ok());
  EXPECT_NE(where(one).x, where(again).x) << "without a perturbation all stands as it was stocked";
  EXPECT_EQ(where(again).x, scene::world_from_product(store->scene.products[0]).position.x);
}

// ---- By a realism ----

episodes::Realism with_goods(const char* dials) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "goods.json";
  const std::string text =
      std::string(R"({"schema": "market-realism/1", "name": "g", "goods": )") + dials + "}";
  const auto written = io::write_file(file, text);
  if (!written.ok()) fatal(to_string(written.error()).c_str());
  return or_die(episodes::load_realism(data_rows(), file.string()));
}

TEST(RandomizedGoods, WhatIsLeftOutIsOff) {
  const episodes::Realism rough = with_goods(R"({"friction": 0.3})");
  EXPECT_EQ(rough.goods.friction, 0.3);
  EXPECT_EQ(rough.goods.place_m + rough.goods.turn_deg + rough.goods.mass, 0);
  EXPECT_FALSE(episodes::perturbation_of(realism_row("hard").goods, Seed(1)));
  const episodes::PerturbationSizes drawn = realism_row("randomized").goods;
  EXPECT_GT(std::min({drawn.place_m, drawn.turn_deg, drawn.friction, drawn.mass}), 0);
}

// The goods alone: nothing else of the episode is drawn otherwise.
TEST(RandomizedGoods, AreThoseOfTheEpisodesSeedAndOtherInAnother) {
  const episodes::Realism rough =
      with_goods(R"({"place_m": 0.005, "turn_deg": 3, "friction": 0.3, "mass": 0.2})");
  const episodes::EpisodeSpec spec = drawn(7, 0);
  episodes::EpisodeSpec other = spec;
  ++other.seed;
  const auto one = counter_at(rough, spec), again = counter_at(rough, spec);
  EXPECT_EQ(one->state_hash(), again->state_hash());
  EXPECT_EQ(one->state_hash(),
            world_of(spec, episodes::perturbation_of(rough.goods, episodes::goods_seed(spec.seed)))
                .state_hash());
  EXPECT_NE(one->state_hash(), counter_at(rough, other)->state_hash());
  const auto plain = counter_at({}, spec), plain_other = counter_at({}, other);
  EXPECT_NE(one->state_hash(), plain->state_hash());
  EXPECT_EQ(plain->state_hash(), plain_other->state_hash());
}

TEST(RandomizedGoods, StandElsewhereInAislesAndSoDoTheyInATwin) {
  const auto plain = can_world_at({}), rough = can_world_at(with_goods(R"({"place_m": 0.005})"));
  const auto where = [](const episodes::AisleWorld& world) {
    return world.world().product_pose(0).position;
  };
  EXPECT_GT(length(where(*rough) - where(*plain)), 1e-4);
  const auto twin = or_die(rough->twin());
  EXPECT_EQ(length(where(*twin) - where(*rough)), 0);
}

}  // namespace
}  // namespace marketgen
