#include "photo/bank.h"

#include <gtest/gtest.h>

#include "io/file.h"
#include "io/json.h"
#include "photo/features.h"
#include "photo/parts.h"
#include "support/run_program.h"

namespace marketgen::photo {
namespace {

// Two classes on one axis: "low" around 0, "high" around 10.
Attribute two_heaps() {
  Attribute attribute;
  attribute.name = "floor";
  attribute.classes = {"high", "low"};
  attribute.groups = {"lamps"};
  attribute.mean.assign(feature_count("lamps"), 0);
  attribute.scale.assign(feature_count("lamps"), 1);
  attribute.axes.assign(feature_count("lamps"), 0);
  attribute.axes[0] = 1;
  attribute.voters = 3;
  attribute.sure_vote = 0.8;
  const auto add = [&](double place, int vote, const char* material) {
    attribute.places.push_back(place);
    attribute.votes.push_back(vote);
    attribute.materials.emplace_back(material);
  };
  add(0, 1, "tile-white");
  add(0.5, 1, "tile-grey");
  add(1, 1, "tile-grey");
  add(10, 0, "wood-oak");
  add(10.5, 0, "wood-oak");
  add(11, 0, "wood-dark");
  return attribute;
}

std::vector<double> at(double place) {
  std::vector<double> features(feature_count("lamps"));
  features[0] = place;
  return features;
}

TEST(Bank, TheNearestVote) {
  const Attribute attribute = two_heaps();
  const Vote low = vote_on(attribute, at(0.7)), high = vote_on(attribute, at(10.2));
  EXPECT_EQ(attribute.classes[low.winner], "low");
  EXPECT_EQ(low.share, 1);
  EXPECT_EQ(weightiest(low.materials), "tile-grey");
  EXPECT_EQ(attribute.classes[high.winner], "high");
  EXPECT_EQ(weightiest(high.materials), "wood-oak");
}

TEST(Bank, NearVotersWeighMore) {
  Attribute attribute = two_heaps();
  attribute.voters = 6;
  const Vote vote = vote_on(attribute, at(2));
  EXPECT_EQ(attribute.classes[vote.winner], "low");
  EXPECT_GT(vote.share, 0.8);
  EXPECT_LT(vote.share, 1);
}

TEST(Bank, ConfidenceIsAHalfWhereItIsSure) {
  Attribute attribute;
  attribute.sure_vote = 0.8;
  EXPECT_DOUBLE_EQ(confidence_of(attribute, 0.8), 0.5);
  EXPECT_DOUBLE_EQ(confidence_of(attribute, 1), 1);
  EXPECT_LT(confidence_of(attribute, 0.79), 0.5);
  double before = 0;
  for (double share = 0.1; share <= 1; share += 0.01) {
    EXPECT_GE(confidence_of(attribute, share), before);
    before = confidence_of(attribute, share);
  }
  attribute.sure_vote = 1.5;
  EXPECT_LT(confidence_of(attribute, 1), 0.5);
  attribute.sure_vote = 1;
  EXPECT_EQ(confidence_of(attribute, 1), 1);
}

TEST(Bank, KnowsWhichMaterialsAreOfAClass) {
  const Attribute attribute = two_heaps();
  EXPECT_TRUE(is_of_class(attribute, 0, "wood-dark"));
  EXPECT_FALSE(is_of_class(attribute, 1, "wood-dark"));
}

class BankFile : public testing::Test {
 protected:
  // What load_bank says of a bank.
  std::string code_of(const Bank& bank) {
    EXPECT_TRUE(io::write_file(folder_.path() / "photo_bank.json", io::write_json(bank)).ok());
    const auto loaded = load_bank(folder_.path());
    return loaded.ok() ? "" : loaded.error().code + " " + loaded.error().where;
  }

  Bank bank_ = [] {
    Bank bank;
    const auto fit = [](PartModel& model, std::size_t numbers) {
      model.mean.assign(numbers, 0);
      model.scale.assign(numbers, 1);
      model.hidden.assign(2 * (numbers + 1), 0);
      model.output.assign(part_count * 3, 0);
    };
    fit(bank.first_parts, first_number_count());
    fit(bank.second_parts, second_number_count());
    bank.attributes = {two_heaps()};
    return bank;
  }();
  ScratchFolder folder_;
};

TEST_F(BankFile, IsReadAsItWasWritten) {
  EXPECT_EQ(code_of(bank_), "");
}

TEST_F(BankFile, SizesThatDoNotFitAreRefused) {
  const std::string file = (folder_.path() / "photo_bank.json").string();
  const Bank good = bank_;
  bank_.first_parts.hidden.pop_back();
  EXPECT_EQ(code_of(bank_), "photo.bad_bank " + file + ":first_parts");
  bank_ = good;
  bank_.attributes[0].places.pop_back();
  EXPECT_EQ(code_of(bank_), "photo.bad_bank " + file + ":floor");
  bank_ = good;
  bank_.attributes[0].votes[0] = 2;
  EXPECT_EQ(code_of(bank_), "photo.bad_bank " + file + ":floor");
  bank_ = good;
  bank_.attributes[0].groups = {"smell"};
  EXPECT_EQ(code_of(bank_), "photo.bad_bank " + file + ":floor");
}

TEST_F(BankFile, MustBeThere) {
  const auto loaded = load_bank(folder_.path());
  ASSERT_FALSE(loaded.ok());
  EXPECT_EQ(loaded.error().code, "input.not_found");
}

}  // namespace
}  // namespace marketgen::photo
