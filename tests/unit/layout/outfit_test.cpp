// plan::Outfit::full: makes, units in line, and that a plan without it stays as it is.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "io/json.h"
#include "layout/in_line.h"
#include "layout/kept_layout.h"
#include "layout/makes.h"
#include "sample_shop.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

// 24 x 18 m of the committed kinds: tills in front, dry goods and dairy behind them.
plan::Plan full_shop(std::string profile = "supermarket-eu") {
  plan::Plan plan = sample::small_shop();
  plan.profile = std::move(profile);
  plan.outfit = plan::Outfit::full;
  plan.look.fixture = "metal-white";
  plan.shell.width_mm = 24000;
  plan.shell.depth_mm = 18000;
  plan.nodes = {sample::cut("root", plan::Axis::y, 0.35, 2400, "front", "back"),
                sample::leaf("front", "tills"),
                sample::cut("back", plan::Axis::x, 0.6, 2400, "west", "east"),
                sample::leaf("west", "goods"),
                sample::leaf("east", "dairy")};
  plan.zones.push_back(sample::zone("dairy", "dairy", "multideck"));
  return plan;
}

layout::Layout laid_out(const plan::Plan& plan, std::uint64_t seed) {
  auto made = layout::make_layout(plan, committed_catalog(), Seed(seed));
  EXPECT_TRUE(made.ok()) << to_string(made.error());
  return std::move(made).value();
}

std::set<std::string> kinds_in(const layout::Layout& layout, std::string_view of) {
  std::set<std::string> kinds;
  for (const layout::Fixture& fixture : layout.fixtures) {
    const bool beside = fixture.run.find("/with/") != std::string::npos;
    if (!beside && layout::counts_as(layout, fixture, of)) kinds.insert(fixture.kind);
  }
  return kinds;
}

TEST(Makes, RowsNameWhatTheCatalogueHas) {
  const catalog::Catalog& catalog = committed_catalog();
  std::set<std::string_view> plain;
  for (const layout::MakeRow& row : layout::make_rows())
    if (row.of == row.kind) plain.insert(row.of);
  for (const layout::MakeRow& row : layout::make_rows()) {
    const catalog::FixtureKind *of = catalog.fixture_kind(row.of),
                               *make = catalog.fixture_kind(row.kind);
    ASSERT_TRUE(of != nullptr && make != nullptr) << row.of << ": " << row.kind;
    EXPECT_TRUE(plain.contains(row.of)) << row.of << " itself is no make";
    EXPECT_EQ(of->temperature, make->temperature) << row.kind;
    EXPECT_EQ(of->role, make->role) << row.kind;
    EXPECT_EQ(make->mount, catalog::FixtureMount::floor) << row.kind;
    for (const std::string_view profile : row.profiles)
      EXPECT_NE(catalog.profile(profile), nullptr) << row.kind << ": " << profile;
    for (const std::string_view zone : row.zones)
      EXPECT_NE(catalog.zone_type(zone), nullptr) << row.kind << ": " << zone;
    EXPECT_FALSE(row.source.empty()) << row.kind;
  }
}

TEST(Makes, AStoreHasOneOfEachAndSeedsHaveOthers) {
  std::map<std::string, std::set<std::string>> seen;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const layout::Layout layout = laid_out(full_shop(), seed);
    for (const std::string of : {"checkout_lane", "endcap", "multideck", "trolley_bay"}) {
      const std::set<std::string> kinds = kinds_in(layout, of);
      EXPECT_LE(kinds.size(), 1U) << of << ", seed " << seed;
      seen[of].insert(kinds.begin(), kinds.end());
    }
  }
  EXPECT_EQ(seen["checkout_lane"], (std::set<std::string>{"checkout-graphite", "checkout_lane"}));
  EXPECT_EQ(seen["multideck"], (std::set<std::string>{"multideck", "multideck-2500"}));
}

TEST(Makes, APlainPlanHasTheRowsItNames) {
  plan::Plan plan = full_shop();
  plan.outfit.reset();
  const layout::Layout unsaid = laid_out(plan, 3);
  plan.outfit = plan::Outfit::plain;
  EXPECT_EQ(io::write_json_line(laid_out(plan, 3)), io::write_json_line(unsaid));
  for (const layout::MakeRow& row : layout::make_rows()) {
    if (row.kind == row.of) continue;
    EXPECT_EQ(kinds_in(unsaid, row.kind), std::set<std::string>{}) << row.kind;
  }
}

TEST(Makes, WhatIsNamedStaysAlike) {
  const catalog::Catalog& catalog = committed_catalog();
  plan::Plan plan = full_shop("forecourt");
  const catalog::FixtureKind& open = *catalog.fixture_kind("multideck");
  const catalog::FixtureKind& doored = *catalog.fixture_kind("cooler-two-door");
  EXPECT_TRUE(layout::may_have(plan, 2, open, doored));
  plan.provenance = {{"/zones/2/fixture", plan::Source::text, std::nullopt, 1}};
  EXPECT_FALSE(layout::may_have(plan, 2, open, doored)) << "open cabinets were asked for";
  EXPECT_TRUE(layout::may_have(plan, 2, open, *catalog.fixture_kind("multideck-slim")));
}

TEST(Makes, MeasuresThatWereSaidHold) {
  const catalog::Catalog& catalog = committed_catalog();
  plan::Plan plan = full_shop();
  plan.zones[1].fixture.height_mm = 2200;
  const catalog::FixtureKind &gondola = *catalog.fixture_kind("gondola"),
                             &low = *catalog.fixture_kind("gondola-1000-low");
  EXPECT_TRUE(layout::may_have(plan, 1, gondola, low)) << "a planner's own choice gives way";
  plan.provenance = {{"/zones/1/fixture/height_mm", plan::Source::text, std::nullopt, 1}};
  EXPECT_FALSE(layout::may_have(plan, 1, gondola, low));
}

TEST(Makes, CountsAreKept) {
  plan::Plan plan = full_shop();
  plan.zones[1].fixture.count = 12;
  plan.zones[2].fixture.count = 3;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const layout::Layout layout = laid_out(plan, seed);
    const auto standing = std::ranges::count_if(layout.fixtures, [&](const auto& fixture) {
      return fixture.zone == "goods" && layout::counts_as(layout, fixture, "gondola");
    });
    EXPECT_EQ(standing, 12) << seed;
    for (const layout::Violation& fault : layout.violations)
      EXPECT_NE(fault.code, "COUNT_SHORT") << seed << ": " << fault.message;
  }
}

TEST(InLine, RowsNameWhatTheCatalogueHas) {
  const catalog::Catalog& catalog = committed_catalog();
  for (const layout::InLineRow& row : layout::in_line_rows()) {
    const catalog::FixtureKind* kind = catalog.fixture_kind(row.kind);
    ASSERT_NE(kind, nullptr) << row.kind;
    EXPECT_TRUE(std::ranges::any_of(catalog.fixture_kinds,
                                    [&](const auto& other) {
                                      return other.generator == row.among &&
                                             other.temperature == kind->temperature;
                                    }))
        << row.kind << ": " << row.among;
    for (const std::string_view zone : row.zones)
      EXPECT_NE(catalog.zone_type(zone), nullptr) << row.kind << ": " << zone;
    for (const std::string_view profile : row.profiles)
      EXPECT_NE(catalog.profile(profile), nullptr) << row.kind << ": " << profile;
    EXPECT_GE(row.modules, 1) << row.kind;
    EXPECT_FALSE(row.source.empty()) << row.kind;
  }
}

TEST(InLine, UnitsTakeThePlaceOfModulesWithinARun) {
  int units = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    const layout::Layout layout = laid_out(full_shop(), seed);
    for (const layout::Fixture& fixture : layout.fixtures) {
      if (fixture.kind != "wall-unit-spice") continue;
      ++units;
      const auto in_run = std::ranges::count(layout.fixtures, fixture.run, &layout::Fixture::run);
      EXPECT_GE(in_run, 3);
      EXPECT_TRUE(fixture.id.starts_with(fixture.run + "/module-"));
    }
    for (const layout::Violation& fault : layout.violations)
      EXPECT_EQ(fault.severity, layout::Severity::soft) << seed << ": " << fault.message;
  }
  EXPECT_GT(units, 0);
}

TEST(InLine, JointsOfKindsAreClosed) {
  std::vector<layout::Fixture> run;
  for (int i = 0; i < 3; ++i) {
    run.push_back(sample::fixture("z/run-1/module-" + std::to_string(i + 1),
                                  i == 1 ? "wine_rack" : "wall_unit",
                                  "z",
                                  500 + 1000 * i,
                                  0,
                                  0,
                                  1000,
                                  500));
    run.back().run = "z/run-1";
    run.back().run_start = run.back().run_end = false;
  }
  layout::close_joints_of_kinds(run);
  EXPECT_TRUE(run[0].run_end && run[1].run_start && run[1].run_end && run[2].run_start);
  EXPECT_FALSE(run[0].run_start || run[2].run_end);
}

TEST(Outfit, AnEditOfOneZoneLeavesTheOthersAsTheyAre) {
  const plan::Plan before = full_shop();
  const layout::Layout stood = laid_out(before, 5);
  plan::Plan after = before;
  after.zones[2].fixture.levels = 4;
  const auto furnish = layout::zones_to_furnish(before, after, committed_catalog());
  EXPECT_EQ(furnish, std::set<std::string>{"dairy"});
  const auto kept =
      layout::make_layout_keeping(after, committed_catalog(), Seed(5), stood, furnish);
  ASSERT_TRUE(kept.ok());
  const layout::Layout anew = laid_out(after, 5);
  for (const layout::Fixture& fixture : stood.fixtures) {
    if (fixture.zone == "dairy") continue;
    for (const layout::Layout* now : {&*kept, &anew}) {
      const layout::Fixture* same = layout::find_fixture(*now, fixture.id);
      ASSERT_NE(same, nullptr) << fixture.id;
      EXPECT_EQ(io::write_json_line(*same), io::write_json_line(fixture));
    }
  }
}

TEST(Outfit, ALayoutKeepsWhatItsSignsNeed) {
  plan::Plan plan = full_shop("supermarket-us");
  plan.country = "us";
  const layout::Layout full = laid_out(plan, 1);
  EXPECT_EQ(full.outfit, plan::Outfit::full);
  EXPECT_EQ(full.country, "us");
  plan.outfit.reset();
  const layout::Layout plain = laid_out(plan, 1);
  EXPECT_FALSE(plain.outfit || plain.country);
}

}  // namespace
}  // namespace marketgen
