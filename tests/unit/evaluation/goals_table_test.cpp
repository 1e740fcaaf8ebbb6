// What tasks may ask for in a store: sums agree, and what is drawn is among it.
#include "evaluation/goals_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "environments/environment_entry.h"
#include "episodes/checkout/sample_checkout.h"
#include "io/file.h"
#include "support/committed_catalog.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

using evaluation::GoalGroup;

std::shared_ptr<const store::Store> corner_shop() {
  static const std::shared_ptr<const store::Store> shop = [] {
    static const ScratchFolder scratch;
    store::CreateOptions options;
    options.folder = scratch.path() / "shop";
    options.brief.prompt = "a corner shop with drinks, tins and snacks";
    options.brief.size_mm = {10000, 8000};
    options.seed = 3;
    options.previews = false;
    if (const auto made = store::create_store(options, committed_catalog()); !made.ok())
      fatal(to_string(made.error()).c_str());
    return std::make_shared<const store::Store>(
        store::open_store(options.folder, committed_catalog()).value());
  }();
  return shop;
}

const evaluation::GoalsTable& goals_of_shop() {
  static const evaluation::GoalsTable table =
      evaluation::goals_table(store::opened_stores({corner_shop()}, committed_catalog()),
                              io::data_folder().value())
          .value();
  return table;
}

int total(const std::vector<GoalGroup>& groups, int GoalGroup::*of) {
  return std::accumulate(groups.begin(), groups.end(), 0, [&](int sum, const GoalGroup& group) {
    return sum + group.*of;
  });
}

void expect_each_product_once(const evaluation::GoalsTable& table) {
  EXPECT_EQ(table.all.on_offer,
            static_cast<int>(episodes::store_stock(corner_shop()->scene).size()));
  for (const auto* groups : {&table.categories, &table.shapes}) {
    EXPECT_EQ(total(*groups, &GoalGroup::on_offer), table.all.on_offer);
    EXPECT_EQ(total(*groups, &GoalGroup::any), table.all.any);
  }
  EXPECT_GE(total(table.fixtures, &GoalGroup::on_offer), table.all.on_offer);
  ASSERT_GE(table.variants.size(), 3U);
  for (std::size_t i = 0; i < table.variants.size(); ++i) {
    int left_out = 0;
    for (const episodes::EpisodeExclusion& reason : table.variants[i].left_out)
      left_out += reason.products;
    EXPECT_EQ(table.all.goals[i] + left_out, table.all.on_offer);
    EXPECT_GE(table.all.any, table.all.goals[i]);
  }
  EXPECT_GT(table.all.any, 0);
}

void expect_what_baskets_hold(const evaluation::GoalsTable& table) {
  const auto at =
      std::ranges::find(table.variants, episodes::Track::checkout, &evaluation::GoalVariant::track);
  EXPECT_EQ(at->tools, "gripper");
  EXPECT_EQ(table.all.goals[static_cast<std::size_t>(at - table.variants.begin())],
            std::ranges::count_if(episodes::store_stock(corner_shop()->scene),
                                  episodes::is_checkout_item));
}

void expect_reasons_in_words(const evaluation::GoalsTable& table) {
  const evaluation::TextTable text = evaluation::text_of(table);
  EXPECT_EQ(text.columns.size(), 4 + table.variants.size());
  EXPECT_TRUE(std::ranges::any_of(text.notes, [](const std::string& note) {
    return note.starts_with("Not for checkout gripper: ") &&
           note.find("too_wide ") != std::string::npos;
  }));
}

// The table takes half a minute: one test looks at all of it.
TEST(GoalsTable, CountsEachProductOnceAsBasketsHoldItAndSaysWhyNot) {
  const evaluation::GoalsTable table = goals_of_shop();
  expect_each_product_once(table);
  expect_what_baskets_hold(table);
  expect_reasons_in_words(table);
}

// Another way to the same answer: the sampler's draws.
TEST(GoalsTable, WhatIsDrawnMayBeAskedFor) {
  const episodes::EpisodeHeader header;
  environments::Arena arena(io::data_folder().value(), header, committed_catalog());
  arena.offer(corner_shop());
  const auto& entry = environments::environment_entry_of(episodes::Track::aisle);
  const auto sampler = entry.sampler(arena, "gripper").value();
  const episodes::EpisodeStore row = environments::store_row(*corner_shop());
  const auto of_store = sampler->of_store({row.name, row.scene_hash, row.plan_hash}).value();
  const auto spec = of_store->sample(Seed(5), 0);
  ASSERT_TRUE(spec.ok()) << to_string(spec.error());
  const std::vector<catalog::Product> stock = episodes::store_stock(corner_shop()->scene);
  for (const episodes::EpisodeGoal& goal : spec->goals) {
    const auto chance =
        of_store->goal_chance(*std::ranges::find(stock, goal.sku, &catalog::Product::sku));
    ASSERT_TRUE(chance.ok());
    EXPECT_EQ(chance->why_not, "") << goal.sku;
    EXPECT_FALSE(chance->fixtures.value().empty()) << goal.sku;
  }
}

}  // namespace
}  // namespace marketgen
