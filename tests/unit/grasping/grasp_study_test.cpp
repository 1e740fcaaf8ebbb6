// The study: the same for any number of threads, honest about what it leaves out, kept and read
// back.
#include "grasping/grasp_study.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <thread>

#include "base/parallel.h"
#include "grasping/grasp_basket.h"
#include "grasping/grasp_database.h"
#include "grasping/grasp_shares.h"
#include "support/committed_catalog.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

std::vector<robots::GraspTool> tools_called(const std::vector<const char*>& ids) {
  const std::filesystem::path data = std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data";
  std::vector<robots::GraspTool> tools;
  for (const char* id : ids) {
    auto tool = robots::load_grasp_tool(data, id);
    if (!tool.ok()) fatal(to_string(tool.error()).c_str());
    tools.push_back(std::move(tool).value());
  }
  return tools;
}

std::vector<robots::GraspTool> all_tools() {
  return tools_called({"panda-hand", "suction-cup"});
}

std::vector<const catalog::Product*> first_of(const std::vector<std::string>& shapes) {
  std::vector<const catalog::Product*> chosen;
  for (const std::string& shape : shapes) {
    for (const catalog::Product& product : committed_catalog().products) {
      if (product.archetype != shape) continue;
      chosen.push_back(&product);
      break;
    }
  }
  return chosen;
}

std::vector<grasping::GraspRate> studied(const std::vector<const catalog::Product*>& products,
                                         int threads) {
  const ThreadLimit limit(threads);
  grasping::StudyOptions options;
  options.tries = 1;
  options.settings = {grasping::GraspSetting::free, grasping::GraspSetting::spaced};
  auto rates = grasping::study_grasps(
      products, all_tools(), committed_catalog().frictions, options, silent_progress());
  if (!rates.ok()) fatal(to_string(rates.error()).c_str());
  return std::move(rates).value();
}

TEST(GraspStudy, TheSameOnOneAndOnManyThreads) {
  const std::vector<const catalog::Product*> products = first_of({"can", "jar", "box", "apple"});
  const std::vector<grasping::GraspRate> one = studied(products, 1), many = studied(products, 4);
  ASSERT_EQ(one.size(), products.size() * 4);
  ASSERT_EQ(one.size(), many.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].sku, many[i].sku);
    ASSERT_EQ(one[i].tries.size(), many[i].tries.size());
    for (std::size_t k = 0; k < one[i].tries.size(); ++k) {
      EXPECT_EQ(one[i].tries[k].end, many[i].tries[k].end);
      EXPECT_EQ(one[i].tries[k].slip_mm, many[i].tries[k].slip_mm);
    }
  }
}

std::vector<grasping::GraspRate> studied_in_basket(
    const std::vector<const catalog::Product*>& products, int threads) {
  const ThreadLimit limit(threads);
  grasping::StudyOptions options;
  options.tries = 1;
  options.settings = {grasping::GraspSetting::basket};
  auto rates =
      grasping::study_grasps(products,
                             tools_called({"panda-hand", "parallel-gripper", "suction-cup"}),
                             committed_catalog().frictions,
                             options,
                             silent_progress());
  if (!rates.ok()) fatal(to_string(rates.error()).c_str());
  return std::move(rates).value();
}

TEST(SlowGraspStudy, InABasketEveryRateIsATryOrHasItsReason) {
  const std::vector<const catalog::Product*> products =
      first_of({"can", "gable_carton", "box", "pouch", "apple"});
  const std::vector<grasping::GraspRate> one = studied_in_basket(products, 1);
  const std::vector<grasping::GraspRate> two = studied_in_basket(products, 2);
  ASSERT_EQ(one.size(), products.size() * 3);
  int held = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    SCOPED_TRACE(one[i].sku + " " + one[i].tool);
    EXPECT_EQ(one[i].setting, grasping::GraspSetting::basket);
    EXPECT_EQ(one[i].fits(), !one[i].tries.empty());
    EXPECT_EQ(one[i].fits(), one[i].reason.empty());
    EXPECT_EQ(one[i].excluded, two[i].excluded);
    ASSERT_EQ(one[i].tries.size(), two[i].tries.size());
    for (std::size_t k = 0; k < one[i].tries.size(); ++k) {
      const grasping::GraspTry& tried = one[i].tries[k];
      EXPECT_EQ(tried.end, two[i].tries[k].end);
      EXPECT_EQ(tried.slip_mm, two[i].tries[k].slip_mm);
      if (tried.end != grasping::GraspEnd::held) continue;
      ++held;
      EXPECT_LE(tried.slip_mm, 1);
      EXPECT_LE(tried.neighbour_n, 50);
    }
  }
  EXPECT_GE(held, 3);
}

TEST(GraspStudy, WhatTheBasketIsTooSmallForIsLeftOut) {
  catalog::Product wide = *first_of({"box"}).front();
  wide.size_mm = {300, 200, 280};
  wide.mass_kg = 1.2;
  for (const grasping::GraspRate& rate : studied_in_basket({&wide}, 1)) {
    EXPECT_EQ(name_of(rate.excluded), "does_not_fit");
    EXPECT_FALSE(rate.reason.empty());
  }
}

// The inside of the basket is 17.2 l: six cans, one box of more than a quarter of it.
TEST(GraspStudy, SoManyLieInTheBasket) {
  catalog::Product pack = *first_of({"can"}).front();
  EXPECT_EQ(grasping::likes_in_basket(pack), 6);
  pack.size_mm = {200, 150, 200};  // 6 l
  EXPECT_EQ(grasping::likes_in_basket(pack), 1);
  pack.size_mm = {200, 100, 200};  // 4 l
  EXPECT_EQ(grasping::likes_in_basket(pack), 2);
  pack.size_mm = {300, 200, 300};  // fills it
  EXPECT_EQ(grasping::likes_in_basket(pack), 1);
}

TEST(GraspStudy, WhatIsLeftOutHasItsReason) {
  catalog::Product wide = *first_of({"food_tin"}).front();
  wide.size_mm = {160, 160, 110};
  wide.mass_kg = 1.2;
  const std::vector<grasping::GraspRate> rates = studied({&wide}, 1);
  EXPECT_EQ(name_of(rates[0].excluded), "too_wide");
  EXPECT_FALSE(rates[0].reason.empty());
  EXPECT_TRUE(rates[0].tries.empty());

  const std::vector<grasping::GraspRate> loose = studied(first_of({"apple"}), 1);
  EXPECT_EQ(name_of(loose[1].excluded), "unshelved");  // spaced
}

TEST(GraspStudy, NoMassIsAnError) {
  catalog::Product weightless = *first_of({"can"}).front();
  weightless.mass_kg = 0;
  const auto rates = grasping::study_grasps(
      {&weightless}, all_tools(), committed_catalog().frictions, {}, silent_progress());
  ASSERT_FALSE(rates.ok());
  EXPECT_EQ(rates.error().code, "catalog.bad_row");
}

// 81 of 263 (Newcombe, "Two-sided confidence intervals", Statistics in Medicine 1998, table I).
TEST(GraspShares, WilsonIntervalsAreThePublishedOnes) {
  const grasping::Share share = grasping::share_of(81, 263);
  EXPECT_NEAR(share.low, 0.2553, 5e-5);
  EXPECT_NEAR(share.high, 0.3662, 5e-5);
  EXPECT_NEAR(grasping::share_of(0, 20).high, 0.1611, 5e-5);
  EXPECT_EQ(grasping::share_of(0, 20).low, 0);
  EXPECT_EQ(grasping::share_of(0, 0).of, 0);
}

TEST(GraspShares, CountByHand) {
  grasping::GraspRate held{
      "a", "can", "hand", grasping::GraspSetting::free, {}, {}, {grasping::GraspTry{}}};
  grasping::GraspRate second{"b",
                             "can",
                             "hand",
                             grasping::GraspSetting::free,
                             {},
                             {},
                             {grasping::GraspTry{}, grasping::GraspTry{}}};
  second.tries[0].end = grasping::GraspEnd::slipped;
  second.tries[0].slip_mm = 2;
  grasping::GraspRate wide{"c",
                           "tray",
                           "hand",
                           grasping::GraspSetting::free,
                           grasping::GraspExclusion::too_wide,
                           "wide",
                           {}};
  const std::vector<grasping::GraspShare> shares = grasping::grasp_shares({held, second, wide});
  ASSERT_EQ(shares.size(), 3U);  // all, can, tray
  EXPECT_EQ(shares[0].products, 3);
  EXPECT_EQ(shares[0].fit.number, 2);
  EXPECT_EQ(shares[0].first.number, 1);
  EXPECT_EQ(shares[0].any.number, 2);
  EXPECT_EQ(shares[0].slip_p99_mm, 2);
  EXPECT_EQ(shares[2].archetype, "tray");
  EXPECT_EQ(shares[2].fit.number, 0);
  ASSERT_EQ(shares[2].excluded.size(), 1U);
  EXPECT_EQ(shares[2].excluded[0].products, 1);
}

TEST(GraspDatabase, RatesComeBackAsTheyWere) {
  const auto folder = std::filesystem::temp_directory_path() / "marketgen-grasp-database";
  std::filesystem::remove_all(folder);
  setenv("MARKETGEN_CACHE", folder.c_str(), 1);
  grasping::GraspRate rate{"a",
                           "can",
                           "hand",
                           grasping::GraspSetting::stocked,
                           {},
                           {},
                           {grasping::GraspTry{}, grasping::GraspTry{}}};
  rate.tries[1] = {motion::GraspStrategy::neck, grasping::GraspEnd::pressed, 30, 70, 0.1, 2, 61};
  grasping::GraspRate wide{"b",
                           "tray",
                           "hand",
                           grasping::GraspSetting::free,
                           grasping::GraspExclusion::too_wide,
                           "wide",
                           {}};
  ASSERT_TRUE(grasping::keep_grasp_rates({rate, wide}, "rows", 7).ok());
  rate.tries.pop_back();
  ASSERT_TRUE(grasping::keep_grasp_rates({rate}, "rows", 8).ok());  // replaces one, keeps the other
  const auto kept = grasping::kept_grasp_rates("rows");
  ASSERT_EQ(kept.size(), 2U);
  EXPECT_EQ(kept[0].tries.size(), 1U);
  EXPECT_EQ(kept[0].setting, grasping::GraspSetting::stocked);
  EXPECT_EQ(kept[1].excluded, grasping::GraspExclusion::too_wide);
  EXPECT_EQ(kept[1].reason, "wide");
  EXPECT_TRUE(grasping::kept_grasp_rates("other rows").empty());
  unsetenv("MARKETGEN_CACHE");
  std::filesystem::remove_all(folder);
}

// One that was damaged, or that another version wrote, costs the rates that it held; new ones are
// kept all the same.
TEST(GraspDatabase, ADamagedOneIsMadeAnew) {
  const ScratchFolder scratch;
  setenv("MARKETGEN_CACHE", scratch.path().c_str(), 1);
  const grasping::GraspRate rate{
      "a", "can", "hand", grasping::GraspSetting::stocked, {}, {}, {grasping::GraspTry{}}};
  ASSERT_TRUE(grasping::keep_grasp_rates({rate}, "rows", 7).ok());
  const std::string whole = contents_of(grasping::grasp_database_file());
  for (const std::string& damaged :
       {std::string(), std::string("nonsense"), whole.substr(0, whole.size() / 2), whole + whole}) {
    std::ofstream(grasping::grasp_database_file(), std::ios::binary) << damaged;
    EXPECT_TRUE(grasping::kept_grasp_rates("rows").empty());
    std::ofstream(grasping::grasp_database_file(), std::ios::binary) << damaged;
    ASSERT_TRUE(grasping::keep_grasp_rates({rate}, "rows", 7).ok());
    EXPECT_EQ(contents_of(grasping::grasp_database_file()), whole);
  }
  unsetenv("MARKETGEN_CACHE");
}

// Two that keep theirs at the same time lose nothing of one another's.
TEST(GraspDatabase, RatesOfTwoAtOnceBothStay) {
  const ScratchFolder scratch;
  setenv("MARKETGEN_CACHE", scratch.path().c_str(), 1);
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < 8; ++i)
      threads.emplace_back([i] {
        const grasping::GraspRate rate{"sku-" + std::to_string(i),
                                       "can",
                                       "hand",
                                       grasping::GraspSetting::free,
                                       {},
                                       {},
                                       {grasping::GraspTry{}}};
        EXPECT_TRUE(grasping::keep_grasp_rates({rate}, "rows", 7).ok());
      });
  }
  EXPECT_EQ(grasping::kept_grasp_rates("rows").size(), 8U);
  unsetenv("MARKETGEN_CACHE");
}

}  // namespace
}  // namespace marketgen
