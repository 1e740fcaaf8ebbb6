// Every kind of wish, met and not met, on a shop whose facts are known.
#include "audit/requirements.h"

#include <gtest/gtest.h>

#include <map>

#include "audited_shop.h"
#include "plan/style_look.h"
#include "support/hand_laid_shop.h"

namespace marketgen {
namespace {

using Kind = plan::RequirementKind;
constexpr plan::Comparison equal = plan::Comparison::equal, at_least = plan::Comparison::at_least,
                           at_most = plan::Comparison::at_most;

plan::Requirement wish(Kind kind,
                       std::string subject,
                       std::string object = "",
                       double value = 0,
                       plan::Comparison comparison = equal) {
  plan::Requirement r;
  r.kind = kind;
  r.subject = std::move(subject);
  r.object = std::move(object);
  r.value = value;
  r.comparison = comparison;
  return r;
}

plan::Requirement size_wish(double width_mm, double depth_mm) {
  plan::Requirement r = wish(Kind::size, "", "", width_mm);
  r.second_value = depth_mm;
  return r;
}

plan::Requirement relation_wish(std::string a, plan::RelationKind relation, std::string b) {
  plan::Requirement r = wish(Kind::relation, std::move(a), std::move(b));
  r.relation = relation;
  return r;
}

plan::Requirement opening_wish(std::string kind,
                               std::string wall,
                               std::string end,
                               double value = 0,
                               plan::Comparison comparison = equal) {
  plan::Requirement r = wish(Kind::opening, std::move(kind), std::move(wall), value, comparison);
  r.second_object = std::move(end);
  return r;
}

plan::Requirement counted_in(std::string place, plan::Requirement r) {
  r.second_object = std::move(place);
  return r;
}

plan::Requirement of_sides(int sides, plan::Requirement r) {
  r.second_value = sides;
  return r;
}

struct WishCase {
  plan::Requirement wish;
  bool met;
};

std::vector<WishCase> cases() {
  return {
      {size_wish(20000, 10000), true},
      {size_wish(20000, 12000), false},
      {wish(Kind::area, "", "", 200), true},
      {wish(Kind::area, "", "", 250), false},
      {wish(Kind::area, "dairy", "", 12), true},  // 8 x 1.5 m
      {wish(Kind::area, "dairy", "", 13), true},  // within 15 %
      {wish(Kind::area, "dairy", "", 20), false},
      {wish(Kind::area, "dairy", "", 20, at_most), true},
      {wish(Kind::zone_present, "dairy"), true},
      {wish(Kind::zone_present, "checkout"), true},  // lanes sell nothing
      {wish(Kind::zone_present, "bakery"), false},   // floor without a fixture
      {wish(Kind::zone_present, "deli"), false},
      {wish(Kind::zone_absent, "deli"), true},
      {wish(Kind::zone_absent, "frozen"), false},
      {wish(Kind::zone_count, "canned", "", 1), true},
      {wish(Kind::zone_count, "canned", "", 2), false},
      {wish(Kind::fixture_count, "checkout_lane", "checkout", 3), true},
      {wish(Kind::fixture_count, "checkout", "", 3), true},
      {wish(Kind::fixture_count, "checkout_lane", "", 4), false},
      {wish(Kind::fixture_count, "checkout_lane", "", 4, at_most), true},
      {wish(Kind::fixture_count, "gondola", "", 3), true},  // modules, not runs
      {wish(Kind::fixture_count, "gondola", "", 2), false},
      {counted_in("canned", wish(Kind::fixture_count, "gondola", "canned", 3)), true},
      {counted_in("dairy", wish(Kind::fixture_count, "gondola", "canned", 3)), false},
      {counted_in("exit", wish(Kind::fixture_count, "checkout_lane", "checkout", 3)), true},
      {counted_in("entrance", wish(Kind::fixture_count, "checkout_lane", "checkout", 3)), false},
      {wish(Kind::run_count, "gondola", "", 2), true},
      {wish(Kind::run_count, "gondola", "", 3), false},
      {of_sides(1, wish(Kind::run_count, "gondola", "", 2)), true},
      {of_sides(2, wish(Kind::run_count, "gondola", "", 2)), false},
      {wish(Kind::aisle_count, "", "", 1), true},
      {wish(Kind::aisle_count, "", "", 5), false},
      {wish(Kind::levels, "", "", 5), true},
      {wish(Kind::levels, "", "", 6), false},
      {wish(Kind::levels, "dairy", "", 4), true},
      {wish(Kind::levels, "dairy", "", 4, at_least), true},
      {wish(Kind::levels, "dairy", "", 5, at_least), false},
      {wish(Kind::levels, "deli", "", 4), false},  // there is none
      {wish(Kind::shelf_pitch, "", "", 350), true},
      {wish(Kind::shelf_pitch, "", "", 300), false},
      {wish(Kind::shelf_pitch, "dairy", "", 400, at_most), true},
      {wish(Kind::shelf_pitch, "deli", "", 350), false},  // there is none
      {relation_wish("dairy", plan::RelationKind::along, "north"), true},
      {relation_wish("dairy", plan::RelationKind::near, "checkout"), false},
      {relation_wish("produce", plan::RelationKind::near, "entrance"),
       false},  // nothing stands in it
      {wish(Kind::area, "produce", "", 12), false},
      {wish(Kind::style, "", "scandinavian"), true},
      {wish(Kind::style, "", "industrial"), false},
      {wish(Kind::profile, "", "supermarket-eu"), true},
      {wish(Kind::profile, "", "discounter"), false},
      {wish(Kind::material, "floor", "terrazzo-white"), false},
      {wish(Kind::color, "fixture", "#f2f2f0"), true},
      {wish(Kind::color, "fixture", "#ff0000"), false},
      {wish(Kind::product_present, "cola"), true},
      {wish(Kind::product_present, "breakfast cereal"), true},
      {wish(Kind::product_present, "chocolate"), false},
      {wish(Kind::product_absent, "chocolate"), true},
      {wish(Kind::product_absent, "cola"), false},
      {opening_wish("entrance", "", ""), true},
      {opening_wish("entrance", "south", ""), true},
      {opening_wish("entrance", "north", ""), false},
      {opening_wish("entrance", "south", "west"), true},
      {opening_wish("entrance", "south", "east"), false},
      {opening_wish("exit", "", "east"), true},
      {opening_wish("exit", "", "center"), false},
      {opening_wish("entrance", "", "", 2), false},
      {opening_wish("entrance", "", "", 1, at_least), true},
      {opening_wish("window", "", "", 0, at_most), true},
      {opening_wish("exit", "", "", 0, at_most), false},
      {wish(Kind::endcaps, "", "", 1, at_least), true},
      {wish(Kind::endcaps, "", "", 0, at_most), false},
      {wish(Kind::endcaps, "dairy", "", 1, at_least), false},
      {wish(Kind::endcaps, "dairy", "", 0, at_most), true},
      {wish(Kind::height, "fixture", "", 1800), true},
      {wish(Kind::height, "fixture", "", 1400), false},
      {wish(Kind::height, "multideck", "", 2000, at_most), true},
      {wish(Kind::height, "peg_wall", "", 1800), false},  // there is none
      {wish(Kind::height, "ceiling", "", 3000), true},
      {wish(Kind::height, "ceiling", "", 4000, at_least), false},
      {wish(Kind::aisle_width, "", "", 1800), true},
      {wish(Kind::aisle_width, "", "", 1500), true},  // wider is fine
      {wish(Kind::aisle_width, "", "", 2500), false},
      {wish(Kind::aisle_width, "", "", 300), false},         // another kind of aisle
      {wish(Kind::stock, "fill", "", 0.6, at_least), true},  // 0.8 on nine of ten shelves
      {wish(Kind::stock, "fill", "", 0.95, at_least), false},
      {wish(Kind::stock, "fill", "", 0.3, at_most), false},
      {wish(Kind::stock, "out_of_stock", "", 0.1, at_least), true},
      {wish(Kind::stock, "out_of_stock", "", 0.3, at_least), false},
      {wish(Kind::stock, "misplaced", "", 0.05, at_least), false},
      {wish(Kind::stock, "misplaced", "", 0.05, at_most), true},
      {wish(Kind::stock, "jitter", "", 0.05, at_most), true},
      {wish(Kind::stock, "jitter", "", 0.8, at_least), false},
      {wish(Kind::stock, "out_of_stock", "dairy", 0.25), true},  // one of its four blocks
      {wish(Kind::stock, "out_of_stock", "canned", 0.25), false},
      {wish(Kind::stock, "fill", "dairy", 0.6), true},
      {wish(Kind::stock, "fill", "dairy", 0.8), false},
      {wish(Kind::stock, "fill", "deli", 0.6), false},  // there is none
      {wish(Kind::height, "multideck", "dairy", 2000, at_most), true},
      {wish(Kind::height, "multideck", "canned", 2000, at_most), false},  // there is none
      {wish(Kind::light, "light_kelvin", "", 3000), true},
      {wish(Kind::light, "light_kelvin", "", 6500), false},
      {wish(Kind::light, "light_lux", "", 800), true},
      {wish(Kind::light, "light_lux", "", 200), false},
      {wish(Kind::time, "", "Sat 18:00"), true},
      {wish(Kind::time, "", "Mon 18:00"), false},
  };
}

// The look of "scandinavian", under a light that the table knows.
scene::Scene dressed() {
  AuditedShop shop;
  const catalog::StyleRow& style = *committed_catalog().style("scandinavian");
  plan::Look& look = shop.scene.layout.look;
  look = plan::look_of(style);
  look.light_kelvin = 3000;
  look.light_lux = 800;
  shop.scene.layout.time = "Sat 18:00";
  return std::move(shop.scene);
}

TEST(Requirements, EveryKindMetAndNotMet) {
  const scene::Scene scene = dressed();
  std::vector<WishCase> all = cases();
  all.push_back({wish(Kind::material, "floor", scene.layout.look.floor), true});
  std::map<Kind, std::array<int, 2>> seen;
  for (const WishCase& c : all) {
    const auto results = audit::check_requirements(scene, committed_catalog(), {c.wish});
    ASSERT_EQ(results.size(), 1U);
    EXPECT_EQ(results[0].met, c.met)
        << name_of(c.wish.kind) << " " << c.wish.subject << " " << c.wish.object << " "
        << name_of(c.wish.comparison) << " " << c.wish.value << ": " << results[0].why;
    EXPECT_FALSE(results[0].why.empty());
    ++seen[c.wish.kind][c.met ? 1 : 0];
  }
  for (std::size_t kind = 0; kind < plan::names_of(Kind{}).size(); ++kind) {
    EXPECT_GT(seen[static_cast<Kind>(kind)][0], 0)
        << plan::names_of(Kind{})[kind] << " is never refused";
    EXPECT_GT(seen[static_cast<Kind>(kind)][1], 0)
        << plan::names_of(Kind{})[kind] << " is never met";
  }
}

TEST(Requirements, RelationsToWhatIsNotThereAreNotJudged) {
  for (const plan::RelationKind kind :
       {plan::RelationKind::far, plan::RelationKind::not_adjacent}) {
    const auto results = audit::check_requirements(
        AuditedShop().scene, committed_catalog(), {relation_wish("dairy", kind, "moon")});
    EXPECT_FALSE(results[0].met);
    EXPECT_NE(results[0].why.find("cannot be judged: the store has no moon"), std::string::npos)
        << results[0].why;
  }
}

TEST(Requirements, TextAndSpanComeBackInOrder) {
  plan::Requirement first = wish(Kind::zone_present, "dairy"),
                    second = wish(Kind::zone_absent, "dairy");
  first.text = "dairy", first.span = {3, 8};
  second.text = "no dairy", second.span = {20, 28};
  const auto results =
      audit::check_requirements(AuditedShop().scene, committed_catalog(), {first, second});
  ASSERT_EQ(results.size(), 2U);
  EXPECT_EQ(results[0].text, "dairy");
  EXPECT_EQ(results[0].span, (IntRange{3, 8}));
  EXPECT_TRUE(results[0].met);
  EXPECT_EQ(results[1].text, "no dairy");
  EXPECT_FALSE(results[1].met);
}

TEST(Requirements, OneLowGondolaBreaksAtLeast) {
  scene::Scene scene = dressed();
  scene.layout.fixtures[0].height_mm = 1700;
  scene.layout.fixtures[1].height_mm = 2300;  // further away, but on the right side
  const auto results = audit::check_requirements(
      scene, committed_catalog(), {wish(Kind::height, "fixture", "", 1800, at_least)});
  EXPECT_FALSE(results[0].met) << results[0].why;
}

// What is asked of every zone but one is not asked of that one.
TEST(Requirements, ExceptedZonesDoNotCount) {
  AuditedShop shop;
  plan::Requirement fill = wish(Kind::stock, "fill", "", 0.5, at_most);
  EXPECT_FALSE(audit::check_requirements(shop.scene, committed_catalog(), {fill})[0].met);
  fill.except = {"canned"};
  EXPECT_TRUE(audit::check_requirements(shop.scene, committed_catalog(), {fill})[0].met);
  plan::Requirement levels = wish(Kind::levels, "", "", 5);
  levels.except = {"canned"};  // no gondola is left
  EXPECT_FALSE(audit::check_requirements(shop.scene, committed_catalog(), {levels})[0].met);
}

TEST(Requirements, DisorderShowsAsMisplacedItems) {
  scene::Scene scene = dressed();
  scene.products[0].flags |= scene::product_misplaced;
  const auto results =
      audit::check_requirements(scene,
                                committed_catalog(),
                                {wish(Kind::stock, "jitter", "", 0.8, at_least),
                                 wish(Kind::stock, "misplaced", "", 0.05, at_least),
                                 wish(Kind::stock, "jitter", "", 0.01, at_most)});
  EXPECT_TRUE(results[0].met);
  EXPECT_TRUE(results[1].met);
  EXPECT_FALSE(results[2].met);
}

// ---- What an empty zone is worth ----

bool is_met(const scene::Scene& scene, const plan::Requirement& r) {
  return audit::check_requirements(scene, committed_catalog(), {r})[0].met;
}

layout::Fixture standing_in(const std::string& zone,
                            const std::string& run,
                            const std::string& kind) {
  layout::Fixture fixture;
  fixture.id = run + "/module-1";
  fixture.run = run;
  fixture.zone = zone;
  fixture.kind = kind;
  return fixture;
}

TEST(Requirements, ShelvingWithoutGoodsMakesNoZone) {
  AuditedShop shop;
  shop.scene.layout.zones.push_back({"promo", "promo", "promo", {}, 4});
  shop.scene.layout.fixtures.push_back(standing_in("promo", "promo/run-1", "pallet"));
  shop.scene.fixtures.emplace_back();
  EXPECT_FALSE(is_met(shop.scene, wish(Kind::zone_present, "promo")));
}

TEST(Requirements, BasketsAtTheDoorMakeNoZone) {
  AuditedShop shop;
  shop.scene.layout.zones.push_back({"service", "customer_service", "service", {}, 4});
  shop.scene.layout.fixtures.push_back(
      standing_in("service", "service/entrance/basket_stack", "basket_stack"));
  shop.scene.fixtures.emplace_back();
  EXPECT_FALSE(is_met(shop.scene, wish(Kind::zone_present, "customer_service")));
  shop.scene.layout.fixtures.push_back(standing_in("service", "service/run-1", "kiosk"));
  shop.scene.fixtures.emplace_back();
  EXPECT_TRUE(is_met(shop.scene, wish(Kind::zone_present, "customer_service")));
}

TEST(Requirements, GoodsOnOfferStandOnAShelf) {
  AuditedShop shop;
  shop.scene.products.clear();
  EXPECT_FALSE(is_met(shop.scene, wish(Kind::product_present, "cola")));
  EXPECT_FALSE(is_met(shop.scene, wish(Kind::product_absent, "cola")));
}

TEST(Requirements, ACounterIsATill) {
  AuditedShop shop;
  for (layout::Fixture& fixture : shop.scene.layout.fixtures)
    if (fixture.kind == "checkout_lane") fixture.kind = "till-counter";
  EXPECT_TRUE(is_met(shop.scene, wish(Kind::fixture_count, "checkout_lane", "checkout", 3)));
}

}  // namespace
}  // namespace marketgen
