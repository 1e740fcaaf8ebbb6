// The committed fixture rows: as many as the library promises, each with its own name, within its
// own ranges, and none of the variants a word of plans.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "catalog/catalog.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

const std::vector<catalog::FixtureKind>& rows() {
  return committed_catalog().fixture_kinds;
}

TEST(FixtureRows, AreAtLeast150OverAtLeast45Generators) {
  std::set<std::string> generators;
  for (const catalog::FixtureKind& kind : rows())
    generators.insert(kind.generator);
  EXPECT_GE(rows().size(), 150U);
  EXPECT_GE(generators.size(), 45U);
}

TEST(FixtureRows, EveryOneHasANameOfItsOwnAndWordsToFindItBy) {
  std::set<std::string> names;
  for (const catalog::FixtureKind& kind : rows()) {
    EXPECT_TRUE(names.insert(kind.name).second) << kind.kind << ": " << kind.name;
    EXPECT_FALSE(kind.keywords.empty() && kind.tags.empty()) << kind.kind;
  }
}

// Words of plans are those of the kinds that layouts know. A variant or a machine that no layout
// places must not change what a prompt means.
TEST(FixtureRows, OnlyTheKindsOfLayoutsAreWordsOfPlans) {
  const auto with_words = std::ranges::count_if(
      rows(), [](const catalog::FixtureKind& kind) { return !kind.keywords.empty(); });
  EXPECT_EQ(with_words, 25);
}

TEST(FixtureRows, ComeInEuropeanAndAmericanModules) {
  const auto made_in = [](int width_mm) {
    return std::ranges::count_if(rows(), [&](const catalog::FixtureKind& kind) {
      return std::ranges::find(kind.module_widths_mm, width_mm) != kind.module_widths_mm.end();
    });
  };
  for (const int width_mm : {665, 1000, 1250, 1330, 914, 1219})
    EXPECT_GE(made_in(width_mm), 3) << width_mm;
}

TEST(FixtureRows, CoolersAndLanesKeepToTheirUsualSizes) {
  for (const catalog::FixtureKind& kind : rows()) {
    if (kind.generator == "multideck") {
      EXPECT_GE(kind.depth_range_mm[0], 900) << kind.kind;
      EXPECT_LE(kind.depth_range_mm[1], 1100) << kind.kind;
    }
    if (kind.generator == "checkout_lane") {
      EXPECT_GE(kind.depth_range_mm[0], 2400) << kind.kind;
      EXPECT_LE(kind.depth_range_mm[1], 4000) << kind.kind;
    }
    if (kind.generator != "glass_door_cooler") continue;
    for (const int width_mm : kind.module_widths_mm) {  // some number of doors of 0.60 to 0.78 m
      bool fits = false;
      for (int doors = 1; doors <= 6; ++doors)
        fits = fits || (width_mm >= 600 * doors && width_mm <= 780 * doors);
      EXPECT_TRUE(fits) << kind.kind << " " << width_mm;
    }
  }
}

TEST(FixtureRows, FreeFloorBeforeDoorsIsAtLeastTheirSwing) {
  for (const catalog::FixtureKind& kind : rows()) {
    EXPECT_LE(kind.door_swing_mm, std::max(kind.front_clearance_mm, 0.0)) << kind.kind;
    EXPECT_GE(kind.door_swing_mm, 0) << kind.kind;
  }
}

}  // namespace
}  // namespace marketgen
