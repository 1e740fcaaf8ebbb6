// Difficulties: rows that differ as they say, files of one's own, and episodes that are drawn so.
#include "episodes/difficulty.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "episodes/difficulty_rows.h"
#include "io/json.h"
#include "support/drawn_checkout.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

using episodes::Difficulty;
using episodes::EpisodeSpec;

constexpr int baskets = 3;

Difficulty difficulty_row(const std::string& name) {
  return episodes::load_difficulty(data_rows(), name).value();
}

Result<Difficulty> own(const std::string& dials) {
  const ScratchFolder folder;
  const auto file = folder.path() / "mine.json";
  std::ofstream(file) << R"({"schema": "market-difficulty/1", "name": "mine", )" << dials << "}";
  return episodes::load_difficulty(data_rows(), file.string());
}

// The row is what the program draws by itself.
TEST(Difficulties, StandardIsTheDefault) {
  EXPECT_EQ(io::write_json(difficulty_row("standard")), io::write_json(Difficulty{}));
  EXPECT_EQ(difficulty_row("standard").told(), std::nullopt);
  EXPECT_EQ(difficulty_row("standard").kind_of("checkout"), "checkout");
  EXPECT_EQ(difficulty_row("standard").seed_of(Seed(7)).value(), Seed(7).value());
}

TEST(DifficultyRows, GetHarder) {
  for (std::size_t i = 1; i < episodes::difficulty_rows.size(); ++i) {
    const Difficulty easier = difficulty_row(std::string(episodes::difficulty_rows[i - 1]));
    const Difficulty harder = difficulty_row(std::string(episodes::difficulty_rows[i]));
    EXPECT_GE(harder.goals.min, easier.goals.min);
    EXPECT_GE(harder.goals.max, easier.goals.max);
    EXPECT_GE(harder.others.min, easier.others.min);
    EXPECT_GT(harder.look_alikes, easier.look_alikes);
    EXPECT_GE(harder.way, easier.way);
    EXPECT_NE(harder.seed_of(Seed(7)).value(), easier.seed_of(Seed(7)).value());
  }
}

TEST(Difficulties, OfOnesOwnAreCalledByTheirDials) {
  const Difficulty one = own(R"("goals": {"min": 1, "max": 1})").value();
  EXPECT_TRUE(one.name.starts_with("own-")) << one.name;
  EXPECT_EQ(one.name, own(R"("goals": {"min": 1, "max": 1}, "way": 0)").value().name);
  EXPECT_NE(one.name, own(R"("goals": {"min": 1, "max": 2})").value().name);
}

TEST(Difficulties, ThatContradictThemselvesAreRefused) {
  const auto where = [](const std::string& dials) {
    const auto read = own(dials);
    EXPECT_FALSE(read.ok()) << dials;
    EXPECT_EQ(read.error().code, "catalog.bad_row");
    return read.error().where.substr(read.error().where.rfind(":/"));
  };
  EXPECT_EQ(where(R"("goals": {"min": 3, "max": 2})"), ":/goals/max");
  EXPECT_EQ(where(R"("goals": {"min": 0, "max": 2})"), ":/goals");
  EXPECT_EQ(where(R"("goals": {"min": 1, "max": 5})"), ":/goals");
  EXPECT_EQ(where(R"("levels": [{"low_m": 1, "high_m": 0.5}])"), ":/levels/0/high_m");
}

TEST(Difficulties, LevelsAreBands) {
  EXPECT_TRUE(Difficulty{}.has_level(2.5));
  const Difficulty hard = difficulty_row("hard");
  EXPECT_TRUE(hard.has_level(0.5));
  EXPECT_FALSE(hard.has_level(1.0));
  EXPECT_TRUE(hard.has_level(1.3));
}

std::vector<EpisodeSpec> baskets_of(const Difficulty& difficulty) {
  std::vector<EpisodeSpec> specs;
  for (int i = 0; i < baskets; ++i)
    specs.push_back(drawn_by({.difficulty = difficulty}, 11, i));
  return specs;
}

TEST(Difficulties, BasketsHoldWhatTheySay) {
  const std::vector<EpisodeSpec> easy = baskets_of(difficulty_row("easy")),
                                 hard = baskets_of(difficulty_row("hard"));
  for (const EpisodeSpec& spec : easy) {
    EXPECT_EQ(spec.difficulty, "easy");
    EXPECT_TRUE(spec.id.starts_with("checkout/easy/")) << spec.id;
    EXPECT_LE(spec.goals.size(), 2U);
    EXPECT_LE(spec.items.size(), 6U);
    EXPECT_FALSE(spec.look_alikes);
  }
  for (const EpisodeSpec& spec : hard) {
    EXPECT_EQ(spec.difficulty, "hard");
    EXPECT_EQ(spec.goals.size(), 4U);
    EXPECT_GE(spec.items.size(), 10U);
  }
}

}  // namespace
}  // namespace marketgen
