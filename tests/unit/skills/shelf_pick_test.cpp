// Where a robot stands to take a pack from a shelf, and with which of its grasps.
#include "skills/shelf_pick.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "motion/grasp_candidates.h"
#include "support/committed_robot.h"

namespace marketgen {
namespace {

// A can at 1 m above an empty floor, its front to -Y.
class ShelfPick : public testing::Test {
 protected:
  ShelfPick() {
    catalog::Product product;
    product.sku = "test-can";
    product.mass_kg = 0.3;
    assets::ProductBody body;
    body.center_of_mass = {0, 0, 0.06F};
    body.pieces.push_back({.shape = assets::PieceShape::cylinder,
                           .center = {0, 0, 0.06F},
                           .half_size = {0.03F, 0.03F, 0.06F}});
    motion::GraspQuery query;
    query.from_front = true;
    const auto found = motion::grasp_candidates(product, body, tool_, query).value().found;
    for (const motion::GraspCandidate& candidate : found)
      question_.grasps.push_back(candidate.grasp);
    question_.world_from_product = {{2, 3, 1}, {}};
    question_.depth_m = 0.06;
    question_.tool_row = tool_.id;
    question_.driving = skills::stowed_state(robot_, "", 0.3, tool_.opening_m);
    question_.where = product.sku;
  }

  Result<skills::ShelfPick> plan() const {
    return skills::plan_shelf_pick(robot_, question_, Seed(7));
  }

  robots::Robot robot_ = committed_robot("realman-rm75");
  robots::GraspTool tool_ = robots::load_grasp_tool(committed_rows, "parallel-gripper").value();
  skills::ShelfPickQuestion question_;
};

TEST_F(ShelfPick, ABestGraspThatCannotBeLetGoIsPassedOver) {
  const auto first = plan();
  ASSERT_TRUE(first.ok()) << to_string(first.error());
  question_.may_hold = [&](const skills::ShelfPick& pick) -> Result<void> {
    if (pick.number != first->number || pick.group != first->group) return {};
    return Error{"collect.no_drop", "test", "not by this one"};
  };
  const auto other = plan();
  ASSERT_TRUE(other.ok()) << to_string(other.error());
  EXPECT_TRUE(other->number != first->number || other->group != first->group);
}

TEST_F(ShelfPick, EitherHandComesFirst) {
  std::map<std::string, int> picks;
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const auto pick = skills::plan_shelf_pick(robot_, question_, Seed(seed));
    ASSERT_TRUE(pick.ok()) << to_string(pick.error());
    ++picks[pick->group];
  }
  ASSERT_EQ(picks.size(), 2U);
  EXPECT_GE(std::min(picks.begin()->second, picks.rbegin()->second), 4);
}

TEST_F(ShelfPick, WhereNoneCanBeLetGoTheReasonIsSaid) {
  const auto first = plan();
  ASSERT_TRUE(first.ok()) << to_string(first.error());
  question_.grasps = {first->grasp};
  question_.may_hold = [](const skills::ShelfPick&) -> Result<void> {
    return Error{"collect.no_drop", "test", "the basket is full"};
  };
  const auto pick = plan();
  ASSERT_FALSE(pick.ok());
  EXPECT_EQ(pick.error().code, "collect.no_drop");
}

// A base stands some centimetres and a degree off where it was to: at one height of the lift the
// arm comes to fewer grasps than at several.
TEST_F(ShelfPick, AnotherHeightOfTheLiftReachesFromBesideThePlannedPlace) {
  question_.world_from_product.position.z = 1.2;
  const auto planned = plan();
  ASSERT_TRUE(planned.ok());
  int at_one = 0, at_several = 0;
  for (const double aside : {-0.02, 0.02}) {
    for (const double turn : {-0.02, 0.0, 0.02}) {
      question_.world_from_base =
          planned->world_from_base * Pose{{-0.02, aside, 0}, rotation_about({0, 0, 1}, turn)};
      question_.lift_offsets_m = {0};
      at_one += plan().ok() ? 1 : 0;
      question_.lift_offsets_m = {0, -0.05, 0.05, -0.10, 0.10};
      at_several += plan().ok() ? 1 : 0;
    }
  }
  EXPECT_LT(at_one, at_several);
  EXPECT_GE(at_several, 5);
}

}  // namespace
}  // namespace marketgen
