// What a look shows of goals of which there are two, or that may mean two products.
#include "policy/sought_goals.h"

#include <gtest/gtest.h>

#include "support/drawn_boxes.h"

namespace marketgen {
namespace {

perception::ProductLook look_of(const char* sku) {
  auto made =
      perception::ProductLook::make(sku, drawn_pictures({0.06, 0.06, 0.1}, plain({200, 40, 30})));
  if (!made.ok()) fatal(to_string(made.error()).c_str());
  return std::move(made).value();
}

// Every text means both.
class BothReader : public perception::GoalReader {
 public:
  Result<std::vector<std::string>> read(const std::string&) const override {
    return std::vector<std::string>{"tea", "coffee"};
  }
};

class SoughtGoals : public ::testing::Test {
 protected:
  SoughtGoals() : tea_(look_of("tea")), coffee_(look_of("coffee")), catalogue_{&tea_, &coffee_} {}
  // Of those that are wanted, at X.
  static perception::FoundProduct found(std::size_t look, double x) {
    perception::FoundProduct product;
    product.look = look;
    product.pose.base_from_product = {{x, 0, 0}, {}};
    return product;
  }

  perception::ProductLook tea_, coffee_;
  policy::SoughtGoals::Catalogue catalogue_;
  agent::WorkArea unloading_{{1, -1}, {2, 1}};
  policy::Sight sight_;
};

TEST_F(SoughtGoals, TwoAreThereWhenBothAre) {
  policy::SoughtGoals goals;
  ASSERT_TRUE(goals.learn({{"tea", 2}}, nullptr, catalogue_).ok());
  ASSERT_EQ(goals.wanted().size(), 1U);
  EXPECT_EQ(goals.wanted()[0].count, 2);
  sight_.found = {found(0, 0.5), found(0, 0.2)};
  EXPECT_EQ(goals.there_of(sight_, 0, unloading_), 0);
  sight_.found = {found(0, 1.5), found(0, 0.2)};
  EXPECT_EQ(goals.there_of(sight_, 0, unloading_), 1);
  sight_.found = {found(0, 1.5), found(0, 1.2)};
  EXPECT_EQ(goals.there_of(sight_, 0, unloading_), 2);
}

// What was put down and is hidden counts, what is seen elsewhere does not.
TEST_F(SoughtGoals, WhatWasPutDownCountsUntilItIsSeenElsewhere) {
  policy::SoughtGoals goals;
  ASSERT_TRUE(goals.learn({{"tea", 2}}, nullptr, catalogue_).ok());
  goals.note_put_down(0);
  EXPECT_EQ(goals.there_of(sight_, 0, unloading_), 1);
  sight_.found = {found(0, 0.5)};
  EXPECT_EQ(goals.there_of(sight_, 0, unloading_), 1);
  sight_.found = {found(0, 0.5), found(0, 0.2)};
  EXPECT_EQ(goals.there_of(sight_, 0, unloading_), 0);
}

// Of which nothing is seen any more, while something that is a little like it is found.
TEST_F(SoughtGoals, WhatIsMuchLessLikeWhatWasPutDownIsSomethingElse) {
  policy::SoughtGoals goals;
  ASSERT_TRUE(goals.learn({{"tea", 1}}, nullptr, catalogue_).ok());
  const auto like = [&](double color_error) {
    perception::FoundProduct other = found(0, 0.5);
    other.pose.evidence.fit = other.pose.evidence.covered = 1;
    other.pose.evidence.color_error = color_error;
    return other;
  };
  goals.note_taken(0, tea_, like(0.08).pose.evidence.likeness());
  sight_.found = {like(0.14)};
  EXPECT_EQ(goals.found_of(sight_, 0).size(), 1U) << "not put down yet";
  goals.note_put_down(0);
  EXPECT_TRUE(goals.found_of(sight_, 0).empty());
  EXPECT_TRUE(goals.is_there(sight_, 0, unloading_));
  sight_.found = {like(0.09)};
  EXPECT_FALSE(goals.is_there(sight_, 0, unloading_)) << "it is seen where it was";
}

TEST_F(SoughtGoals, TheReadingThatIsFoundBestIsMeantUntilAnotherWasTaken) {
  policy::SoughtGoals goals;
  const BothReader reader;
  ASSERT_TRUE(goals.learn({{"", 1, "the hot drink"}}, &reader, catalogue_).ok());
  ASSERT_EQ(goals.wanted().size(), 2U);
  sight_.found = {found(1, 0.5), found(0, 0.2)};
  ASSERT_EQ(goals.found_of(sight_, 0).size(), 1U);
  EXPECT_EQ(goals.look_of(*goals.found_of(sight_, 0)[0]).sku(), "coffee");
  goals.note_taken(0, tea_, 0);
  EXPECT_EQ(goals.look_of(*goals.found_of(sight_, 0)[0]).sku(), "tea");
}

TEST_F(SoughtGoals, WordsWithoutAReaderAreAnError) {
  policy::SoughtGoals goals;
  const auto learnt = goals.learn({{"", 1, "the tea"}}, nullptr, catalogue_);
  ASSERT_FALSE(learnt.ok());
  EXPECT_EQ(learnt.error().code, "episode.impossible");
}

}  // namespace
}  // namespace marketgen
