// The shipped study: there for every product, of today's rows, and what a study of today finds.
#include "grasping/grasp_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "base/progress.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

constexpr const char* remedy = "make data/grasps.csv anew: tools/refresh_grasps";

std::filesystem::path committed_data() {
  return std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data";
}

robots::GraspTool tool_called(const char* id) {
  auto tool = robots::load_grasp_tool(committed_data(), id);
  if (!tool.ok()) fatal(to_string(tool.error()).c_str());
  return std::move(tool).value();
}

grasping::GraspTable shipped() {
  auto table = grasping::GraspTable::read(committed_data());
  if (!table.ok()) fatal(to_string(table.error()).c_str());
  return std::move(table).value();
}

Result<grasping::GraspTable> read_back(const std::string& text) {
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "grasp-table";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "grasps.csv") << text;
  return grasping::GraspTable::read(folder);
}

// As episodes ask (episodes/aisle/grasp_book.h).
grasping::StudyOptions as_episodes_ask() {
  grasping::StudyOptions options;
  options.settings = {grasping::GraspSetting::stocked};
  options.enough_held = 2;
  return options;
}

std::vector<grasping::GraspEnd> ends_of(const grasping::GraspRate& rate) {
  std::vector<grasping::GraspEnd> ends;
  for (const grasping::GraspTry& tried : rate.tries)
    ends.push_back(tried.end);
  return ends;
}

class ShippedGrasps : public testing::TestWithParam<const char*> {};

TEST_P(ShippedGrasps, AreThereForEveryProductAsItIsToday) {
  const grasping::GraspTable table = shipped();
  const robots::GraspTool tool = tool_called(GetParam());
  for (const catalog::Product& product : committed_catalog().products)
    EXPECT_TRUE(table.find(product, tool, committed_catalog().frictions).has_value())
        << product.sku << ": " << remedy;
}

TEST_P(ShippedGrasps, AreWhatAStudyOfTodayFinds) {
  const grasping::GraspTable table = shipped();
  const robots::GraspTool tool = tool_called(GetParam());
  constexpr std::size_t every = 97, asked = 4;
  std::vector<const catalog::Product*> chosen;
  const std::vector<catalog::Product>& products = committed_catalog().products;
  for (std::size_t i = every; i < products.size() && chosen.size() < asked; i += every) {
    const auto rate = table.find(products[i], tool, committed_catalog().frictions);
    if (rate && !rate->tries.empty()) chosen.push_back(&products[i]);
  }
  ASSERT_EQ(chosen.size(), asked);
  const auto today = grasping::study_grasps(
      chosen, {tool}, committed_catalog().frictions, as_episodes_ask(), silent_progress());
  ASSERT_TRUE(today.ok()) << to_string(today.error());
  for (std::size_t i = 0; i < asked; ++i)
    EXPECT_EQ(ends_of(*table.find(*chosen[i], tool, committed_catalog().frictions)),
              ends_of((*today)[i]))
        << chosen[i]->sku << ": " << remedy;
}

INSTANTIATE_TEST_SUITE_P(Tools,
                         ShippedGrasps,
                         testing::Values("parallel-gripper", "suction-cup"),
                         [](const auto& named) {
                           std::string name = named.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

TEST(GraspTable, RowsThatWereMadeOfOthersAreNotUsed) {
  const grasping::GraspTable table = shipped();
  const robots::GraspTool tool = tool_called("parallel-gripper");
  catalog::Product product = committed_catalog().products.front();
  const auto& frictions = committed_catalog().frictions;
  ASSERT_TRUE(table.find(product, tool, frictions).has_value());
  robots::GraspTool stronger = tool;
  stronger.force_n += 1;
  EXPECT_FALSE(table.find(product, stronger, frictions).has_value());
  product.mass_kg *= 1.01;
  EXPECT_FALSE(table.find(product, tool, frictions).has_value());
}

TEST(GraspTable, WhatIsWrittenIsReadBack) {
  const catalog::Product& product = committed_catalog().products.front();
  const robots::GraspTool tool = tool_called("suction-cup");
  grasping::GraspRate rate{product.sku, product.archetype, tool.id, {}, {}, "so \"it\", is", {}};
  rate.setting = grasping::GraspSetting::stocked;
  rate.tries = {{motion::GraspStrategy::side, grasping::GraspEnd::held, 45.25, 12, 0.5, 0.25, 0},
                {motion::GraspStrategy::neck, grasping::GraspEnd::toppled, 30, 1, 2, 3, 4.5}};
  const auto& frictions = committed_catalog().frictions;
  const auto text = grasping::grasp_table_text({rate}, {&product}, {tool}, frictions);
  ASSERT_TRUE(text.ok()) << to_string(text.error());
  const auto table = read_back(*text);
  ASSERT_TRUE(table.ok()) << to_string(table.error());
  const auto read = table->find(product, tool, frictions);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->reason, rate.reason);
  EXPECT_EQ(read->archetype, product.archetype);
  ASSERT_EQ(read->tries.size(), 2U);
  EXPECT_EQ(read->tries[0].width_mm, 45.25);
  EXPECT_EQ(read->tries[1].strategy, motion::GraspStrategy::neck);
  EXPECT_EQ(read->tries[1].end, grasping::GraspEnd::toppled);
}

TEST(GraspTable, WhatIsNoRateIsAnErrorWithItsLine) {
  const auto code_of = [](const std::string& rows) {
    const auto table = read_back(rows);
    return table.ok() ? std::string() : table.error().code + " " + table.error().where;
  };
  const std::string header = "sku,tool,made_of,excluded,reason,tries\n";
  EXPECT_EQ(code_of(header + "a,b,c,none,\"\",side held 1 2 3 4 5\n"), "");
  for (const char* bad : {"a,b,c,nowhere,\"\",\n",
                          "a,b,c,none,\"\",side held 1 2 3 4\n",
                          "a,b,c,none,\"\",side held 1 2 3 4 x\n",
                          "a,b,c,none,\"\",sideways held 1 2 3 4 5\n"})
    EXPECT_TRUE(code_of(header + bad).starts_with("catalog.bad_row")) << bad;
  EXPECT_NE(code_of(header + "a,b,c,none,\"\",side lost 1 2 3 4 5\n").find(":2/tries"),
            std::string::npos);
  EXPECT_TRUE(code_of("sku,tool\na,b\n").starts_with("catalog.bad_row"));
}

}  // namespace
}  // namespace marketgen
