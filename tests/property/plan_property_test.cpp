// Plans by chance: what validates is made within limits, what is made validates, and check says
// what generate does.
//
// A few hundred plans in every run; MARKETGEN_PROPERTY_PLANS=10000 for the long one.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <set>

#include "io/file.h"
#include "io/json.h"
#include "store/store.h"
#include "support/number_of_cases.h"
#include "support/plan_sampler.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

// Refusals of a valid plan: no layout of it exists, or it is too large to be made.
const std::set<std::string> refusals{"layout.impossible", "scene.too_large"};

// What only the builder of a fixture knows is refused where it was asked for.
bool cannot_be_built(const Error& error) {
  return error.code == "plan.bad_value" && error.where.find("/fixture/") != std::string::npos &&
         error.message.find(" out for what is usual") != std::string::npos;
}
constexpr std::chrono::seconds longest_time(20);  // a shop of this size takes a tenth of a second

std::size_t number_of_plans(std::size_t usual) {
  return number_of_cases("MARKETGEN_PROPERTY_PLANS", usual);
}

Stream stream_of(std::size_t number) {
  return Seed(20).child("plan_property", number).stream();
}

// generate --plan of a plan that is written into the folder.
store::CreateOptions options_for(const fs::path& folder,
                                 const plan::Plan& plan,
                                 std::uint64_t seed) {
  EXPECT_TRUE(io::write_file(folder / "plan.json", io::write_json(plan)).ok());
  store::CreateOptions options;
  options.folder = folder / "shop";
  options.plan_file = folder / "plan.json";
  options.seed = seed;
  options.previews = false;
  return options;
}

TEST(PlanProperty, WhatValidatesIsMadeWithinLimits) {
  PlanSampler sampler;
  const ScratchFolder scratch;
  std::size_t made = 0;
  const std::size_t plans = number_of_plans(200);
  for (std::size_t i = 0; i < plans; ++i) {
    Stream draw = stream_of(i);
    const plan::Plan plan = sampler.random_plan(draw);
    ASSERT_TRUE(plan::validate_plan(plan, "random", committed_catalog()).ok());
    const auto start = std::chrono::steady_clock::now();
    const auto report = store::try_store(options_for(scratch.path(), plan, i), committed_catalog());
    EXPECT_LT(std::chrono::steady_clock::now() - start, longest_time) << i;
    made += report.ok() ? 1 : 0;
    if (report.ok()) continue;
    EXPECT_TRUE(refusals.contains(report.error().code) || cannot_be_built(report.error()))
        << i << ": " << to_string(report.error()) << "\n"
        << io::write_json(plan);
  }
  EXPECT_GT(4 * made, 3 * plans);
}

std::string rules_of(const store::StoreReport& report) {
  std::string text;
  for (const layout::Violation& rule : report.rules)
    text += io::write_json_line(rule) + "\n";
  return text;
}

TEST(PlanProperty, CheckSaysWhatGenerateDoesAndWhatItWritesValidates) {
  PlanSampler sampler;
  const std::size_t plans = number_of_plans(200) / 10;
  for (std::size_t i = 0; i < plans; ++i) {
    SCOPED_TRACE(i);
    Stream draw = stream_of(i);
    const plan::Plan plan = sampler.random_plan(draw);
    const ScratchFolder scratch;
    const store::CreateOptions options = options_for(scratch.path(), plan, i);
    const auto said = store::try_store(options, committed_catalog());
    const auto created = store::create_store(options, committed_catalog());
    ASSERT_EQ(created.ok(), said.ok());
    if (!said.ok()) {
      EXPECT_EQ(to_string(created.error()), to_string(said.error()));
      continue;
    }
    const fs::path shop = scratch.path() / "shop";
    const auto verified = store::verify_store(shop, committed_catalog());
    EXPECT_TRUE(verified.ok()) << to_string(verified.error());
    const auto report = store::read_report(shop);
    ASSERT_TRUE(report.ok()) << to_string(report.error());
    EXPECT_EQ(rules_of(*report), rules_of(*said));
    EXPECT_EQ(report->repairs, said->repairs);
    const auto store = store::open_store(shop, committed_catalog());
    ASSERT_TRUE(store.ok()) << to_string(store.error());
    EXPECT_TRUE(
        store::try_store(options_for(scratch.path(), store->plan, i), committed_catalog()).ok());
  }
}

// One validation for what is read and what is held: a plan is valid where its text is.
TEST(PlanProperty, ATextIsReadIfAndOnlyIfItsPlanIsValid) {
  const PlanSampler sampler;
  std::size_t valid = 0, invalid = 0;
  for (std::size_t i = 0; i < 10 * number_of_plans(200); ++i) {
    Stream draw = stream_of(i);
    plan::Plan plan = sampler.wild_plan(draw);
    if (draw.chance(0.2)) plan.zones[1].fixture.aisle_mm = draw.integer(0, 9000);
    if (draw.chance(0.1))
      plan.name = std::string(static_cast<std::size_t>(draw.integer(0, 200)), 'x');
    if (draw.chance(0.1)) plan.zones[1].stock.fill = draw.uniform(-0.5, 1.5);
    if (draw.chance(0.05)) plan.nodes[1].id = "../front";
    if (draw.chance(0.05)) plan.look.accent = "green";
    const auto held = plan::validate_plan(plan, "plan", committed_catalog());
    const auto read = plan::read_plan(io::write_json(plan), "plan", committed_catalog());
    ASSERT_EQ(held.ok(), read.ok())
        << i << ": " << to_string(held.ok() ? read.error() : held.error()) << "\n"
        << io::write_json(plan);
    if (!held.ok()) {
      EXPECT_EQ(held.error().code, read.error().code) << i;
    }
    ++(held.ok() ? valid : invalid);
  }
  EXPECT_GT(valid, 100U);
  EXPECT_GT(invalid, 100U);
}

}  // namespace
}  // namespace marketgen
