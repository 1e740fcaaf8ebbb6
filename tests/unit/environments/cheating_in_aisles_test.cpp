// Policies that would score in the aisles without doing the task: each gets nothing. What each is
// after is looked at, too, so that none fails for want of trying. Those of the counter:
// cheating_policies_test.cpp.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "environments/run_episode.h"
#include "io/json.h"
#include "oracle/oracle_aisle.h"
#include "support/can_aisle.h"
#include "support/can_cooler.h"
#include "support/drawn_checkout.h"
#include "support/oracle_until.h"
#include "support/recorded_actions.h"

namespace marketgen {
namespace {

// Drives so for so many steps each, and says then that it has done.
class Drives : public agent::Policy {
 public:
  struct Leg {
    double speed_m_s = 0;
    int steps = 0;
  };
  explicit Drives(std::vector<Leg> legs) : legs_(std::move(legs)) {}

  Result<void> begin(const agent::Task&, const agent::Observation&) override { return {}; }
  Result<agent::Action> act(const agent::Observation& now) override {
    agent::Action action = episodes::still_action(now);
    action.stop = legs_.empty();
    if (legs_.empty()) return action;
    action.drive_m_s = legs_.front().speed_m_s;
    if (--legs_.front().steps == 0) legs_.erase(legs_.begin());
    return action;
  }

 private:
  std::vector<Leg> legs_;
};

class AisleCheats : public testing::Test {
 protected:
  void open(double heading_deg, double y_m = 1.6) {
    episodes::EpisodeSpec spec = can_episode(*can_aisle());
    spec.start = {3.0, y_m, heading_deg};
    world_ = can_world(spec);
  }

  episodes::EpisodeResult played(agent::Policy& policy) {
    auto result = environments::run_policy(*world_, policy, "cheat");
    if (!result.ok()) fatal(to_string(result.error()).c_str());
    return std::move(result).value();
  }

  // The oracle, which cheats as soon as it holds a can so far above its basket's floor.
  episodes::EpisodeResult cheats_over_basket(double height_m, const OracleUntil::Cheat& cheat) {
    open(0);
    OracleUntil policy(
        oracle::make_aisle_oracle(*world_, data_rows(), Seed(3)).value(),
        [&](const agent::Action&, bool) { return is_held_over_basket(height_m); },
        cheat);
    const episodes::EpisodeResult result = played(policy);
    EXPECT_TRUE(policy.has_cheated()) << "no can came there";
    return result;
  }

  bool is_held_over_basket(double height_m) const {
    const Vec3 inner = world_->store().basket.size;
    for (std::uint32_t can = 0; can < world_->store().scene.products.size(); ++can) {
      const Vec3 at =
          inverse(world_->world_from_basket()) * world_->world().product_pose(can).position;
      if (std::abs(at.x) < inner.x / 2 - 0.03 && std::abs(at.y) < inner.y / 2 - 0.03 &&
          at.z > height_m && at.z < 1)
        return true;
    }
    return false;
  }

  static void expect_nothing(const episodes::EpisodeResult& result) {
    EXPECT_EQ(result.hits, 0) << io::write_json(result);
    EXPECT_EQ(result.success_partial, 0);
    EXPECT_FALSE(result.success_strict);
    EXPECT_EQ(result.spl, 0);
    EXPECT_TRUE(result.detail.empty()) << result.detail;
  }

  std::unique_ptr<episodes::AisleWorld> world_;
};

TEST_F(AisleCheats, StoppingAtOnceIsWorthNothing) {
  open(0);
  Drives policy({});
  expect_nothing(played(policy));
}

// Goods that fall off the shelf are to fall into the basket on its rear deck.
TEST_F(AisleCheats, BackingIntoTheShelfAgainAndAgainIsWorthNothing) {
  open(-90, 2.2);
  std::vector<Drives::Leg> legs;
  for (int i = 0; i < 6; ++i) {
    legs.push_back({-1.5, 30});
    legs.push_back({1.0, 12});
  }
  Drives policy(legs);
  const episodes::EpisodeResult result = played(policy);
  expect_nothing(result);
  EXPECT_GE(result.side_effects.base_collisions, 1) << "it met nothing";
  EXPECT_FALSE(episodes::is_clean(result.side_effects));
}

TEST_F(AisleCheats, HoldingACanOverTheBasketIsWorthNothing) {
  expect_nothing(cheats_over_basket(0.02, [](agent::Action last, int step) {
    last.stop = step > 20;
    return last;
  }));
}

TEST_F(AisleCheats, LettingACanFallIntoTheBasketIsWorthNothing) {
  const episodes::EpisodeResult result = cheats_over_basket(0.25, [](agent::Action last, int step) {
    for (agent::ToolCommand& tool : last.tools)
      tool.opening_m = 0.09;
    last.stop = step > 40;
    return last;
  });
  expect_nothing(result);
  EXPECT_EQ(world_->in_basket().size(), 1U) << "it fell beside it";
}

// Two cans as the oracle fetches them where two are asked for; here it is one.
TEST_F(AisleCheats, FetchingANeighbourTooCancelsAGoal) {
  episodes::EpisodeSpec spec = can_episode(*can_aisle());
  spec.goals[0].count = 2;
  world_ = can_world(spec);
  Recorder oracle(oracle::make_aisle_oracle(*world_, data_rows(), Seed(3)).value());
  EXPECT_EQ(played(oracle).hits, 2);
  spec.goals[0].count = 1;
  world_ = can_world(spec);
  Recorded policy(oracle.actions());
  const episodes::EpisodeResult result = played(policy);
  expect_nothing(result);
  EXPECT_EQ(result.goals[0].reached, 1);
  EXPECT_EQ(world_->in_basket().size(), 2U);
}

// ---- Behind a door ----

// The can is fetched as it should be; the work of shutting the door is left to others.
TEST_F(AisleCheats, LeavingADoorAjarIsNotClean) {
  const auto store = can_cooler(episodes::Doors::hinged);
  world_ = can_world(can_cooler_episode(*store, 1), store);
  int steps_in_basket = 0;
  OracleUntil policy(
      oracle::make_aisle_oracle(*world_, data_rows(), Seed(1)).value(),
      [&](const agent::Action&, bool) {
        steps_in_basket += world_->in_basket().empty() ? 0 : 1;
        return steps_in_basket > 100;  // it was let go, and the hand has left
      },
      [this](const agent::Action&, int) {
        agent::Action action = episodes::still_action(world_->observe());
        action.stop = true;
        return action;
      });
  const episodes::EpisodeResult result = played(policy);
  ASSERT_TRUE(policy.has_cheated()) << "no can came into the basket";
  EXPECT_TRUE(result.success_strict) << io::write_json(result);
  EXPECT_EQ(result.side_effects.doors_open, 1);
  EXPECT_FALSE(episodes::is_clean(result.side_effects));
  EXPECT_FALSE(result.success_clean);
}

TEST_F(AisleCheats, ActingAfterTheEndIsAnErrorAndChangesNothing) {
  open(0);
  Drives policy({});
  played(policy);
  const std::string before = world_->state_hash();
  agent::Action action = episodes::still_action(world_->observe());
  action.drive_m_s = 0.5;
  const auto stepped = world_->step(action);
  ASSERT_FALSE(stepped.ok());
  EXPECT_EQ(stepped.error().code, "episode.bad_action");
  EXPECT_EQ(world_->state_hash(), before);
}

}  // namespace
}  // namespace marketgen
