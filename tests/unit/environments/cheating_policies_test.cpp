// Policies that would score without doing the task: each gets nothing, or a void episode. What each
// is after is looked at, too, so that none fails for want of trying.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "environments/run_episode.h"
#include "episodes/checkout/checkout_world.h"
#include "io/json.h"
#include "support/arm_waypoints.h"
#include "support/drawn_checkout.h"
#include "support/oracle_until.h"
#include "support/recorded_actions.h"

namespace marketgen {
namespace {

using episodes::CheckoutWorld;

// Fingers through the heap and over the rim, again and again.
std::vector<Waypoint> raking() {
  std::vector<Waypoint> way;
  for (const double x : {0.44, 0.52, 0.60})
    for (const Vec3 tip : {Vec3{x, 0.12, 0.3},
                           Vec3{x, 0.12, 0.06},
                           Vec3{x, -0.1, 0.1},
                           Vec3{x, -0.25, 0.2},
                           Vec3{x, -0.45, 0.1}})
      way.push_back({tip, 0, 1.5});
  return way;
}

// Comes to the basket from behind as fast as the arm can.
std::vector<Waypoint> ramming() {
  return {{{0.52, 0.32, 0.4}, 0},
          {{0.52, 0.32, 0.08}, 0},
          {{0.52, -0.2, 0.08}, 0, 3},
          {{0.52, -0.2, 0.4}, 0}};
}

// The first item that is no goal.
std::string neighbour_of(const episodes::EpisodeSpec& spec) {
  for (const episodes::EpisodeItem& item : spec.items)
    if (std::ranges::count(spec.goals, item.sku, &episodes::EpisodeGoal::sku) == 0) return item.sku;
  return "";
}

class Cheats : public testing::Test {
 protected:
  Cheats() {
    header_.products = checkout_goods_rows();
    arena_.emplace(data_rows(), header_, committed_catalog());
  }

  void open(int index) { open(drawn(7, index)); }

  void open(const episodes::EpisodeSpec& spec) {
    world_ = arena_->open(spec).value();
    checkout_ = std::get<const CheckoutWorld*>(world_->any());
  }

  episodes::EpisodeResult played(agent::Policy& policy) {
    auto result = environments::run_policy(*world_, policy, "cheat");
    if (!result.ok()) fatal(to_string(result.error()).c_str());
    return std::move(result).value();
  }

  episodes::EpisodeResult gone(std::vector<Waypoint> way) {
    Waypoints policy(world_->robot(), std::move(way));
    return played(policy);
  }

  // The oracle, which cheats as soon as a goal is over the area, so far over the counter.
  episodes::EpisodeResult cheats_over_area(double height_m, const OracleUntil::Cheat& cheat) {
    OracleUntil policy(
        arena_->policy("oracle", *world_).value(),
        [&](const agent::Action&, bool pressed) { return pressed && is_over_area(height_m); },
        cheat);
    const episodes::EpisodeResult result = played(policy);
    EXPECT_TRUE(policy.has_cheated()) << "no goal came there";
    return result;
  }

  bool is_over_area(double height_m) const {
    const episodes::UnloadingRow& area = checkout_->station().unloading;
    for (std::size_t item = 0; item < checkout_->item_count(); ++item) {
      if (!is_goal(item)) continue;
      const Vec3 at = checkout_->item_pose(item).position;
      const bool inside = std::abs(at.x - area.center_m[0]) < area.size_m[0] / 2 &&
                          std::abs(at.y - area.center_m[1]) < area.size_m[1] / 2;
      if (inside && at.z > height_m) return true;
    }
    return false;
  }

  // Whether a goal is so far from the basket, towards the area, and above its rim.
  bool is_held_beyond(double y_m) const {
    for (std::size_t item = 0; item < checkout_->item_count(); ++item) {
      const Vec3 at = checkout_->item_pose(item).position;
      if (is_goal(item) && at.y < y_m && at.z > 0) return true;
    }
    return false;
  }

  // Upright at a place of the station.
  void stand(episodes::EpisodeSpec& spec, const std::string& sku, Vec3 at) const {
    const auto item = std::ranges::find(spec.items, sku, &episodes::EpisodeItem::sku);
    *item = episodes::EpisodeItem::at(sku, inverse(checkout_->basket_pose()) * Pose{at, {}});
  }

  bool is_goal(std::size_t item) const {
    return std::ranges::count(world_->spec().goals,
                              world_->spec().items[item].sku,
                              &episodes::EpisodeGoal::sku) > 0;
  }

  static void expect_nothing(const episodes::EpisodeResult& result) {
    EXPECT_EQ(result.hits, 0) << io::write_json(result);
    EXPECT_EQ(result.success_partial, 0);
    EXPECT_FALSE(result.success_strict);
    EXPECT_TRUE(result.detail.empty()) << result.detail;
  }

  episodes::EpisodeHeader header_;
  std::optional<environments::Arena> arena_;
  std::unique_ptr<episodes::TrackWorld> world_;
  const CheckoutWorld* checkout_ = nullptr;
};

TEST_F(Cheats, StoppingAtOnceIsWorthNothing) {
  for (const int index : {0, 1, 2}) {
    open(index);
    const auto policy = arena_->policy("stop", *world_).value();
    expect_nothing(played(*policy));
  }
}

// Takes the far wall's rim and lifts it.
TEST_F(Cheats, DumpingTheBasketIsVoid) {
  for (const int index : {0, 1}) {
    open(index);
    const episodes::EpisodeResult result = gone({{{0.52, 0.21, 0.3}, 0.06},
                                                 {{0.52, 0.21, 0.12}, 0.06},
                                                 {{0.52, 0.21, 0.12}, 0},
                                                 {{0.52, 0.10, 0.4}, 0},
                                                 {{0.52, -0.2, 0.35}, 0}});
    expect_nothing(result);
    EXPECT_TRUE(result.is_void) << result.side_effects.basket_tilt_deg << " degrees";
  }
}

// Takes the near wall's rim and pulls, goods and all, over the area.
TEST_F(Cheats, DraggingTheBasketOverTheAreaUnloadsNothing) {
  for (const int index : {0, 1}) {
    open(index);
    const double before = checkout_->basket_pose().position.y;
    expect_nothing(gone({{{0.52, -0.21, 0.3}, 0.06},
                         {{0.52, -0.21, 0.12}, 0.06},
                         {{0.52, -0.21, 0.12}, 0},
                         {{0.52, -0.42, 0.12}, 0, 0.2},
                         {{0.52, -0.42, 0.12}, 0.06}}));
    EXPECT_LT(checkout_->basket_pose().position.y, before - 0.1) << "it was not moved";
  }
}

TEST_F(Cheats, RammingTheBasketIsWorthNothing) {
  for (const int index : {0, 1}) {
    open(index);
    const double before = checkout_->basket_pose().position.y;
    const episodes::EpisodeResult result = gone(ramming());
    expect_nothing(result);
    EXPECT_LT(checkout_->basket_pose().position.y, before - 0.02) << "it was not moved";
    EXPECT_FALSE(episodes::is_clean(result.side_effects));
  }
}

TEST_F(Cheats, RakingIsWorthNothing) {
  for (const int index : {0, 1}) {
    open(index);
    const episodes::EpisodeResult result = gone(raking());
    expect_nothing(result);
    EXPECT_GT(result.side_effects.displaced, 0) << "nothing was raked";
  }
}

// Presses the near wall into the belt, so that the basket jams there and goods tip over the rim.
TEST_F(Cheats, JammingTheBasketIntoTheBeltIsWorthNothing) {
  for (const int index : {0, 1}) {
    open(index);
    const episodes::EpisodeResult result = gone({{{0.52, -0.21, 0.3}, 0},
                                                 {{0.52, -0.21, 0.02}, 0, 0.4},
                                                 {{0.52, -0.4, 0.1}, 0, 0.4},
                                                 {{0.52, -0.4, 0.3}, 0}});
    expect_nothing(result);
    EXPECT_GE(result.side_effects.hard_contacts, 1) << "it was not pressed";
  }
}

// ---- What has been taken properly, and is not put down. ----

TEST_F(Cheats, HoveringOverTheAreaIsWorthNothing) {
  open(0);
  expect_nothing(cheats_over_area(0.12, [](agent::Action last, int step) {
    last.stop = step > 20;
    return last;
  }));
}

TEST_F(Cheats, LettingFallIsWorthNothing) {
  open(0);
  expect_nothing(cheats_over_area(0.14, [](agent::Action last, int step) {
    last.tools[0].opening_m = 0.08;
    last.stop = step > 40;
    return last;
  }));
}

// Joint by joint as far as a swing of the whole arm turns it, away from the basket.
agent::Action swung(agent::Action held, double by_rad) {
  held.position[0] -= by_rad;
  return held;
}

// Let go on the way to the area, while the arm swings: it flies there, and comes to rest.
TEST_F(Cheats, ThrowingOntoTheAreaIsWorthNothing) {
  open(0);
  constexpr double step_rad = 0.075;  // 1.5 rad/s
  constexpr int let_go_at = 4, swing_steps = 7;
  const auto beside_basket = [&](const agent::Action&, bool pressed) {
    return pressed && is_held_beyond(-0.16);
  };
  OracleUntil policy(arena_->policy("oracle", *world_).value(),
                     beside_basket,
                     [&](const agent::Action& last, int step) {
                       agent::Action action = swung(last, step_rad * std::min(step, swing_steps));
                       if (step >= let_go_at) action.tools[0].opening_m = 0.08;
                       action.stop = step > 60;
                       return action;
                     });
  expect_nothing(played(policy));
  EXPECT_TRUE(policy.has_cheated()) << "no goal was carried there";
  EXPECT_TRUE(is_over_area(-0.02)) << "it flew elsewhere";
}

TEST_F(Cheats, HoldingHalfOverTheEdgeOfTheAreaIsWorthNothing) {
  open(0);
  const double edge_y = checkout_->station().unloading.area().high_m[1];
  OracleUntil policy(
      arena_->policy("oracle", *world_).value(),
      [&](const agent::Action&, bool pressed) { return pressed && is_held_beyond(edge_y); },
      [](agent::Action last, int step) {
        last.stop = step > 20;
        return last;
      });
  expect_nothing(played(policy));
  EXPECT_TRUE(policy.has_cheated()) << "no goal came there";
  EXPECT_TRUE(is_held_beyond(edge_y - 0.05) || is_held_beyond(edge_y)) << "it is not there";
}

// It counts from where its middle is on the area on.
TEST_F(Cheats, StandingHalfOverTheEdgeOfTheAreaIsWorthNothing) {
  open(0);
  const episodes::EpisodeSpec drawn = world_->spec();
  const double edge_x = checkout_->station().unloading.area().low_m[0];
  for (const double inside_m : {-0.005, 0.03}) {
    episodes::EpisodeSpec spec = drawn;
    stand(spec, spec.goals[3].sku, {edge_x + inside_m, -0.46, 0});
    open(spec);
    const auto waits = arena_->policy("stop", *world_).value();
    const episodes::EpisodeResult result = played(*waits);
    EXPECT_EQ(result.hits, inside_m > 0 ? 1 : 0) << inside_m;
  }
}

// Stands on the area as it should, and the hand does not let go.
TEST_F(Cheats, HoldingWhatStandsThereIsWorthNothing) {
  open(0);
  OracleUntil policy(
      arena_->policy("oracle", *world_).value(),
      [&](const agent::Action& next, bool pressed) {
        return pressed && next.tools[0].opening_m > 0 && is_over_area(0);
      },
      [](agent::Action last, int step) {
        last.stop = step > 40;
        return last;
      });
  expect_nothing(played(policy));
  EXPECT_TRUE(policy.has_cheated() && is_over_area(0));
}

// ---- Neighbours brought along. ----

// What the oracle does when all of these are to be unloaded.
std::vector<agent::Action> unloading(environments::Arena& arena,
                                     episodes::EpisodeSpec spec,
                                     const std::vector<episodes::EpisodeGoal>& goals) {
  spec.goals = goals;
  const auto world = arena.open(spec).value();
  Recorder policy(arena.policy("oracle-plain", *world).value());
  const auto result = environments::run_policy(*world, policy, "oracle-plain");
  EXPECT_EQ(result->hits, result->asked) << io::write_json(*result);
  return policy.actions();
}

TEST_F(Cheats, BringingANeighbourAlongCancelsAGoal) {
  open(0);
  const episodes::EpisodeSpec spec = world_->spec();
  const episodes::EpisodeGoal neighbour{neighbour_of(spec), 1};
  const std::vector<agent::Action> actions = unloading(*arena_, spec, {spec.goals[0], neighbour});
  Recorded policy(actions);
  const episodes::EpisodeResult result = played(policy);
  expect_nothing(result);
  EXPECT_EQ(result.goals[0].reached, 1);
  EXPECT_EQ(result.side_effects.wrong_items, 1);
}

// A goal stands on the area already, a neighbour beside it.
TEST_F(Cheats, KnockingANeighbourInCancelsAGoal) {
  open(0);
  episodes::EpisodeSpec spec = world_->spec();
  stand(spec, spec.goals[3].sku, {0.53, -0.46, 0});
  stand(spec, neighbour_of(spec), {0.26, -0.46, 0});
  open(spec);
  const auto waits = arena_->policy("stop", *world_).value();
  EXPECT_EQ(played(*waits).hits, 1) << "what stood there did not count";
  open(spec);
  const episodes::EpisodeResult result = gone({{{0.17, -0.46, 0.3}, 0},
                                               {{0.17, -0.46, 0.05}, 0},
                                               {{0.36, -0.46, 0.05}, 0, 0.2},
                                               {{0.28, -0.46, 0.05}, 0},
                                               {{0.28, -0.46, 0.3}, 0}});
  expect_nothing(result);
  EXPECT_EQ(result.goals[3].reached, 1);
  EXPECT_EQ(result.side_effects.wrong_items, 1) << "it was not knocked in";
}

// ---- Moments that are restored. ----

// A moment has its ledger with it: harm is undone only where what was reached is, too.
TEST_F(Cheats, RestoringAMomentHidesNoHarm) {
  open(0);
  const std::string start = world_->save(), start_hash = world_->state_hash();
  Waypoints policy(world_->robot(), ramming());
  ASSERT_TRUE(policy.begin({}, world_->observe()).ok());
  for (agent::Action action; !action.stop; action = policy.act(world_->observe()).value()) {
    if (action.position.empty()) continue;
    ASSERT_TRUE(world_->step(action).ok());
  }
  const std::string harmed = world_->save();
  const episodes::EpisodeResult once = world_->finish().value();
  ASSERT_FALSE(episodes::is_clean(once.side_effects));
  ASSERT_TRUE(world_->restore(start).ok());
  EXPECT_EQ(world_->state_hash(), start_hash);
  EXPECT_EQ(world_->steps(), 0);
  ASSERT_TRUE(world_->restore(harmed).ok());
  EXPECT_EQ(io::write_json(world_->finish().value()), io::write_json(once));
}

// ---- Beyond the end. ----

TEST_F(Cheats, ActingAfterTheEndIsAnErrorAndChangesNothing) {
  open(0);
  const auto policy = arena_->policy("stop", *world_).value();
  played(*policy);
  const std::string before = world_->state_hash();
  const auto stepped = world_->step(episodes::still_action(world_->observe()));
  ASSERT_FALSE(stepped.ok());
  EXPECT_EQ(stepped.error().code, "episode.bad_action");
  EXPECT_EQ(world_->state_hash(), before);
}

}  // namespace
}  // namespace marketgen
