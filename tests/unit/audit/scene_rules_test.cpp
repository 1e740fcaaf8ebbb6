// Every rule of scene_rules.inc has a scene that breaks it and one that keeps it.
#include "audit/scene_rules.h"

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <set>

#include "audit/audit.h"
#include "audited_shop.h"
#include "support/hand_laid_shop.h"

namespace marketgen {
namespace {

std::vector<std::string> broken_rules(const scene::Scene& scene) {
  const auto audit = audit::audit_store(scene, committed_catalog(), {});
  if (!audit.ok()) fatal(to_string(audit.error()).c_str());
  std::vector<std::string> codes;
  for (const layout::Violation& v : audit->rules)
    codes.push_back(v.code);
  return codes;
}

bool breaks(const scene::Scene& scene, std::string_view rule) {
  const auto codes = broken_rules(scene);
  return std::find(codes.begin(), codes.end(), rule) != codes.end();
}

// Small enough a selling area for what stands there.
scene::Scene sound() {
  AuditedShop shop;
  shop.scene.layout.zones.push_back(
      {"store-room", "backroom", "", polygon_of({0, 0, 1, 1}), 189.9});

  return std::move(shop.scene);
}

const std::map<std::string_view, std::function<void(scene::Scene&)>>& faults() {
  static const std::map<std::string_view, std::function<void(scene::Scene&)>> all = {
      {"ITEM_COLLISION",
       [](scene::Scene& s) {
         scene::SceneProduct twin = s.products[0];
         twin.position_m[0] += 0.01F;
         s.products.push_back(twin);
       }},
      {"ITEM_OUTSIDE_SHELF", [](scene::Scene& s) { s.products[0].position_m[1] -= 0.3F; }},
      {"SHELF_EMPTY",
       [](scene::Scene& s) { s.facings.resize(s.facings.size() - 2); }},  // 2 of 20 shelves
      {"LOAD_HEAVY_HIGH",
       [](scene::Scene& s) {
         s.catalog[1].mass_kg = 2.5;
         for (scene::SceneProduct& p : s.products) {
           if (p.sku == 1) p.position_m[2] += 1.5F;
         }
       }},
      {"DENSITY_LOW", [](scene::Scene& s) { s.layout.zones.pop_back(); }},
      {"SHELF_UNREACHABLE",
       [](scene::Scene& s) {
         layout::Fixture wall;
         wall.id = wall.run = "wall";
         wall.x_mm = 11500, wall.y_mm = 5000, wall.width_mm = 200, wall.depth_mm = 10000;
         s.layout.fixtures.push_back(wall);
         s.fixtures.push_back({});
       }},
      {"STORAGE_WRONG", [](scene::Scene& s) { s.catalog[0].storage = catalog::Storage::frozen; }},
      {"PRICE_MISSING", [](scene::Scene& s) { s.price_labels.pop_back(); }},
      {"EXIT_TRAVEL_LONG", [](scene::Scene& s) { s.layout.shell.width_mm = 200000; }},
      {"DOOR_NARROW", [](scene::Scene& s) { s.layout.shell.openings[1].width_mm = 800; }},
      {"LIGHT_DIM", [](scene::Scene& s) { s.layout.look.light_lux = 250; }},
      {"CEILING_TIGHT", [](scene::Scene& s) { s.layout.shell.ceiling_mm = 2200; }},
  };
  return all;
}

TEST(SceneRules, ASoundShopKeepsThemAll) {
  EXPECT_EQ(broken_rules(sound()), std::vector<std::string>{});
}

TEST(SceneRules, EveryRuleIsBrokenByItsFaultAndKeptWithoutIt) {
  for (const audit::SceneRule& rule : audit::scene_rules()) {
    const auto fault = faults().find(rule.code);
    ASSERT_NE(fault, faults().end()) << rule.code << " has no fault in this test";
    scene::Scene scene = sound();
    EXPECT_FALSE(breaks(scene, rule.code)) << rule.code;
    fault->second(scene);
    EXPECT_TRUE(breaks(scene, rule.code)) << rule.code;
  }
  EXPECT_EQ(faults().size(), audit::scene_rules().size());
}

TEST(SceneRules, ViolationsSayWhereAndHowMuch) {
  scene::Scene scene = sound();
  faults().at("ITEM_OUTSIDE_SHELF")(scene);
  const auto audit = audit::audit_store(scene, committed_catalog(), {});
  ASSERT_TRUE(audit.ok());
  ASSERT_EQ(audit->rules.size(), 1U);
  EXPECT_EQ(audit->rules[0].where, scene::product_id(scene, 0));
  EXPECT_EQ(audit->rules[0].value, 1);
  EXPECT_EQ(audit->rules[0].severity, layout::Severity::hard);
  EXPECT_FALSE(audit->rules[0].message.empty());
  EXPECT_EQ(audit->metrics.OOB, 1U);
}

TEST(SceneRules, EveryRuleHasASource) {
  for (const audit::SceneRule& rule : audit::scene_rules())
    EXPECT_FALSE(rule.source.empty()) << rule.code;
}

// "patch: how; patch: how", with patches that there are, or "none: why".
TEST(SceneRules, EveryRuleSaysWithWhichPatchesItIsMended) {
  std::set<std::string> known = {"none"};
#define PLAN_PATCH(name, Type, what) known.insert(#name);
#include "plan/patches.inc"
#undef PLAN_PATCH
  for (const audit::SceneRule& rule : audit::scene_rules()) {
    const std::string remedy(rule.remedy);
    EXPECT_TRUE(known.contains(remedy.substr(0, remedy.find(':')))) << rule.code << ": " << remedy;
    EXPECT_EQ(audit::remedy_of(rule.code), remedy);
    for (std::size_t at = remedy.find(": "); at != std::string::npos;
         at = remedy.find(": ", at + 1)) {
      const std::size_t begin = remedy.rfind("; ", at);
      const std::string patch = begin == std::string::npos
                                    ? remedy.substr(0, at)
                                    : remedy.substr(begin + 2, at - begin - 2);
      EXPECT_TRUE(known.contains(patch)) << rule.code << ": " << patch;
    }
  }
  EXPECT_EQ(audit::remedy_of("AISLE_TOO_NARROW"), "");
}

TEST(Audit, LayoutsViolationsComeAlong) {
  scene::Scene scene = sound();
  scene.layout.violations.push_back({"AISLE_TOO_NARROW",
                                     layout::Severity::hard,
                                     "aisle-1",
                                     800,
                                     1000,
                                     "too narrow",
                                     std::nullopt});
  EXPECT_EQ(broken_rules(scene), std::vector<std::string>{"AISLE_TOO_NARROW"});
}

TEST(Audit, ShareOfWishesMet) {
  plan::Requirement met, missed;
  met.kind = missed.kind = plan::RequirementKind::zone_present;
  met.subject = "dairy";
  missed.subject = "deli";
  const auto audit =
      audit::audit_store(sound(), committed_catalog(), {met, missed, missed, missed});
  ASSERT_TRUE(audit.ok());
  EXPECT_DOUBLE_EQ(audit->metrics.prompt, 0.25);
  EXPECT_EQ(audit->requirements.size(), 4U);
}

}  // namespace
}  // namespace marketgen
