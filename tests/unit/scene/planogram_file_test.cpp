// Planograms that come back from a file: the round trip, what is refused, and shelves stocked anew.
#include "scene/planogram_file.h"
#include "plan/shelf_key.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "plan/patch.h"
#include "scene/planogram_rows.h"
#include "scene/restock.h"
#include "scene/scene_file.h"
#include "scene/shelf_fill.h"
#include "scene_of.h"

namespace marketgen {
namespace {

const char* side_of(int side) {
  return side == 0 ? "front" : "back";
}

// The scene's planogram as a file; shelves that hold nothing have a row without a product.
std::string file_of(const scene::Scene& scene, bool with_places = true) {
  std::string text = "fixture,side,shelf,position,sku,gtin,x_mm,facings_wide\r\n";
  std::set<std::uint32_t> named;
  for (const scene::PlanogramRow& row : scene::planogram_rows(scene))
    text += fmt::format("{},{},{},{},{},{},{},{}\r\n",
                        row.fixture,
                        side_of(row.side),
                        row.level + 1,
                        row.position + 1,
                        row.sku,
                        row.ean,
                        with_places ? std::to_string(row.bay_x_mm) : "",
                        row.facings);
  for (const scene::Facing& facing : scene.facings)
    named.insert(facing.shelf);
  for (std::uint32_t s = 0; s < scene.shelves.size(); ++s) {
    const scene::SceneShelf& shelf = scene.shelves[s];
    if (named.contains(s)) continue;
    text += fmt::format("{},{},{},,,,,\r\n",
                        scene.layout.fixtures[shelf.fixture].id,
                        side_of(shelf.side),
                        shelf.level + 1);
  }
  return text;
}

scene::PlanogramFile read(const std::string& text,
                          const scene::Scene& scene,
                          const plan::Plan& plan) {
  auto file = scene::read_planogram(text, "p.csv", scene, plan, committed_catalog());
  if (!file.ok()) fatal(to_string(file.error()).c_str());
  return std::move(file).value();
}

// The plan after the planogram; none of its rows may be refused.
plan::Plan plan_with(const std::string& text, const scene::Scene& scene, plan::Plan plan) {
  const scene::PlanogramFile file = read(text, scene, plan);
  for (const Error& error : file.refused)
    ADD_FAILURE() << to_string(error);
  const auto changes = scene::changes_by(file, scene, plan, committed_catalog());
  for (const plan::Patch& patch : changes.patches.patches) {
    auto next = plan::patched(plan, patch, committed_catalog(), "/patches/0");
    if (!next.ok()) fatal(to_string(next.error()).c_str());
    plan = std::move(next->plan);
  }
  return plan;
}

scene::Scene scene_of_plan(const HandLaidShop& shop, const plan::Plan& plan, std::uint64_t seed) {
  return scene_of({plan, shop.layout}, seed);
}

struct SaidBlock {
  std::string fixture, sku;
  int level, side, position, x_mm, facings;
  auto operator<=>(const SaidBlock&) const = default;
};

std::vector<SaidBlock> planogram_of(const scene::Scene& scene) {
  std::vector<SaidBlock> blocks;
  for (const scene::PlanogramRow& row : scene::planogram_rows(scene))
    blocks.push_back(
        {row.fixture, row.sku, row.level, row.side, row.position, row.bay_x_mm, row.facings});
  return blocks;
}

HandLaidShop shop_of_all_zones() {
  return shop_of(selling_types());
}

TEST(PlanogramFile, OfTheStoreItselfChangesNothing) {
  const HandLaidShop shop = shop_of_all_zones();
  const scene::Scene scene = scene_of(shop);
  const scene::PlanogramFile file = read(file_of(scene), scene, shop.plan);
  EXPECT_TRUE(file.refused.empty());
  EXPECT_EQ(file.shelves.size(), scene.shelves.size());
  const auto changes = scene::changes_by(file, scene, shop.plan, committed_catalog());
  EXPECT_EQ(changes.as_they_were, scene.shelves.size());
  EXPECT_TRUE(changes.patches.patches.empty());
}

// A store that was stocked otherwise gets the planogram of another, and with that one's seed its
// every item, too.
TEST(PlanogramFile, BringsAnotherStoresPlanogramWhole) {
  const HandLaidShop shop = shop_of_all_zones();
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    const scene::Scene wanted = scene_of(shop, seed), other = scene_of(shop, seed + 100);
    ASSERT_NE(planogram_of(wanted), planogram_of(other));
    const plan::Plan plan = plan_with(file_of(wanted), other, shop.plan);
    ASSERT_TRUE(plan.planogram);
    EXPECT_EQ(planogram_of(scene_of_plan(shop, plan, seed + 100)), planogram_of(wanted));
    EXPECT_EQ(scene::scene_hash(scene_of_plan(shop, plan, seed)), scene::scene_hash(wanted));
  }
}

TEST(PlanogramFile, SpreadsBlocksOfWhichItSaysNoPlace) {
  const HandLaidShop shop = shop_of_all_zones();
  const scene::Scene wanted = scene_of(shop, 1), other = scene_of(shop, 2);
  const plan::Plan plan = plan_with(file_of(wanted, false), other, shop.plan);
  EXPECT_EQ(scene::scene_hash(scene_of_plan(shop, plan, 1)), scene::scene_hash(wanted));
}

// One shelf of cans, and what a row says of it.
struct OneShelf {
  HandLaidShop shop = shop_of({"canned"});
  scene::Scene scene = scene_of(shop);
  std::string fixture = "canned/run-1/module-1";
  const catalog::Product& can = scene.catalog.at(scene.facings.at(0).sku);

  std::vector<Error> refused(const std::string& header, const std::string& rows) const {
    return read(header + "\n" + rows, scene, shop.plan).refused;
  }
};

const std::string head = "fixture,shelf,sku,facings_wide,x_mm,facings_high,facings_deep";

TEST(PlanogramFile, RefusesRowsWithTheirLineAndWhatHelps) {
  const OneShelf one;
  struct Case {
    std::string rows, where, code, says;
  };
  const std::string can = one.can.sku, at = one.fixture;
  const Case cases[] = {
      {at + ",1,no-such-tin,1,,,", "p.csv:2:/sku", "catalog.unknown_sku", "no-such-tin"},
      {"canned/run-1/modul-1,1," + can + ",1,,,",
       "p.csv:2:/fixture",
       "plan.unknown_reference",
       "did you mean \"canned/run-1/module-1\""},
      {at + ",77," + can + ",1,,,", "p.csv:2:/shelf", "plan.unknown_reference", "it has 1, 2"},
      {at + ",1," + can + ",many,,,", "p.csv:2:/facings_wide", "planogram.bad_row", "many"},
      {at + ",1," + can + ",,,,", "p.csv:2:/facings_wide", "planogram.bad_row", "is empty"},
      {at + ",1," + can + ",90,,,",
       "p.csv:2:/facings_wide",
       "planogram.does_not_fit",
       "beyond the shelf"},
      {at + ",1," + can + ",2,100,,\n" + at + ",1," + can + ",1,110,,",
       "p.csv:3:/x_mm",
       "planogram.does_not_fit",
       "leave x_mm"},
      {at + ",1," + can + ",1,,99,", "p.csv:2:/facings_high", "planogram.does_not_fit", "at most"},
      {at + ",1," + can + ",1,,,99", "p.csv:2:/facings_deep", "planogram.does_not_fit", "at most"},
      {at + ",1,frozen-pizza,1,,,", "p.csv:2:/sku", "catalog.unknown_sku", "frozen-pizza"},
  };
  for (const Case& c : cases) {
    const std::vector<Error> refused = one.refused(head, c.rows);
    ASSERT_FALSE(refused.empty()) << c.rows;
    EXPECT_EQ(refused[0].where, c.where) << refused[0].message;
    EXPECT_EQ(refused[0].code, c.code);
    EXPECT_NE(refused[0].message.find(c.says), std::string::npos) << refused[0].message;
  }
}

TEST(PlanogramFile, RefusesWhatIsKeptColderThanTheFixtureIs) {
  const OneShelf one;
  const auto frozen = std::ranges::find(
      committed_catalog().products, catalog::Storage::frozen, &catalog::Product::storage);
  const auto refused = one.refused(head, one.fixture + ",1," + frozen->sku + ",1,,,");
  ASSERT_EQ(refused.size(), 1U);
  EXPECT_NE(refused[0].message.find("is kept frozen, but the fixture is ambient"),
            std::string::npos);
}

TEST(PlanogramFile, ReadsWhatSpreadsheetsWrite) {
  const OneShelf one;
  const std::string text =
      "\xEF\xBB\xBF"
      "fixture;shelf;\"sku\";facings_wide;x_mm;note\r\n" +
      one.fixture + ";1;\"" + one.can.sku + "\";2;\"200,4\";a;\r\n";
  const std::string fits =
      "\xEF\xBB\xBF"
      "fixture;shelf;\"sku\";facings_wide;x_mm;note\r\n" +
      one.fixture + ";1;\"" + one.can.sku + "\";2;\"200,4\";a\r\n";
  EXPECT_FALSE(
      scene::read_planogram(text, "p.csv", one.scene, one.shop.plan, committed_catalog()).ok());
  const scene::PlanogramFile file = read(fits, one.scene, one.shop.plan);
  ASSERT_TRUE(file.refused.empty());
  ASSERT_EQ(file.shelves.at(0).blocks.size(), 1U);
  EXPECT_EQ(file.shelves[0].blocks[0].x_mm, 200);
  EXPECT_EQ(file.shelves[0].blocks[0].facings, 2);
}

TEST(PlanogramFile, NamesColumnsThatAreMissingOrMisspelt) {
  const OneShelf one;
  const auto fault = [&](const std::string& header) {
    auto file = scene::read_planogram(header + "\n" + one.fixture + ",1,a,1,1\n",
                                      "p.csv",
                                      one.scene,
                                      one.shop.plan,
                                      committed_catalog());
    return file.ok() ? std::string("none") : file.error().message;
  };
  EXPECT_NE(fault("fixture,shelf,sku,facings,x_mm").find("\"facings_wide\""), std::string::npos);
  EXPECT_NE(fault("fixture,shelf,sku,facings_wide,xmm").find("x_mm"), std::string::npos);
}

TEST(PlanogramFile, PutsBlocksWhereItSays) {
  const OneShelf one;
  const std::string rows =
      one.fixture + ",2," + one.can.sku + ",2,300,1,1\n" + one.fixture + ",1,,,,,\n";
  const plan::Plan plan = plan_with(head + "\n" + rows, one.scene, one.shop.plan);
  const scene::Scene now = scene_of_plan(one.shop, plan, 1);
  int on_first = 0;
  std::vector<scene::PlanogramRow> second;
  for (const scene::PlanogramRow& row : scene::planogram_rows(now)) {
    if (row.side != 0) continue;
    on_first += row.level == 0 ? 1 : 0;
    if (row.level == 1) second.push_back(row);
  }
  EXPECT_EQ(on_first, 0);
  ASSERT_EQ(second.size(), 1U);
  EXPECT_EQ(second[0].bay_x_mm, 300);
  EXPECT_EQ(second[0].capacity, 2);
}

// Shelves stocked anew are those of the whole store made anew, byte for byte.
void expect_the_whole_stores(HandLaidShop shop) {
  for (plan::Zone& zone : shop.plan.zones)
    zone.stock.price_tags = plan::PriceTagSpec{0.1, 0.1, 0.1, 0.2};
  const scene::Scene scene = scene_of(shop);
  Stream draw = Seed(9).child("restock").stream();
  for (int run = 0; run < 12; ++run) {
    const scene::Scene other = scene_of(shop, 200 + static_cast<std::uint64_t>(run));
    plan::Plan plan = plan_with(file_of(other), scene, shop.plan);
    std::erase_if(*plan.planogram, [&](const plan::StockedShelf&) { return draw.chance(0.9); });
    const auto changed = scene::shelves_changed(shop.plan, plan, committed_catalog(), scene);
    ASSERT_TRUE(changed);
    EXPECT_EQ(changed->size(), plan.planogram->size());
    const auto anew = scene::restocked(scene, *changed, plan, committed_catalog());
    ASSERT_TRUE(anew.ok()) << to_string(anew.error());
    EXPECT_TRUE(scene::encode_scene(*anew) == scene::encode_scene(scene_of_plan(shop, plan, 1)));
  }
}

TEST(Restock, IsWhatTheWholeStoreWouldBe) {
  expect_the_whole_stores(shop_of_all_zones());
}

TEST(Restock, IsSoAtAnyTimeOfTheWeek) {
  HandLaidShop shop = shop_of_all_zones();
  shop.plan.time = "Sat 17:30";
  expect_the_whole_stores(shop);
}

plan::StockedShelf as_it_stands(const scene::Scene& scene, std::uint32_t shelf) {
  const scene::SceneShelf& row = scene.shelves[shelf];
  plan::StockedShelf said{
      scene.layout.fixtures[row.fixture].id, plan::shelf_side(row.side), row.level + 1, {}};
  for (const scene::Facing& facing : scene.facings)
    if (facing.shelf == shelf)
      said.blocks.push_back({scene.catalog[facing.sku].sku, facing.facings, {}, {}, {}});
  return said;
}

// Where boards are fitted each shelf by itself keeps what it has but for a facing.
TEST(Restock, IsSoOnFittedBoards) {
  HandLaidShop shop = shop_of_all_zones();
  shop.plan.shelves = plan::ShelfPitch::fitted;
  const scene::Scene scene = scene_of(shop);
  int fast = 0, slow = 0;
  for (std::uint32_t i = 0; i < scene.shelves.size(); ++i) {
    plan::StockedShelf shelf = as_it_stands(scene, i);
    if (shelf.blocks.empty() || shelf.blocks.front().facings < 2) continue;
    --shelf.blocks.front().facings;
    plan::Plan plan = shop.plan;
    plan.planogram = {shelf};
    const auto changed = scene::shelves_changed(shop.plan, plan, committed_catalog(), scene);
    ++(changed ? fast : slow);
    if (!changed) continue;
    const auto anew = scene::restocked(scene, *changed, plan, committed_catalog());
    ASSERT_TRUE(anew.ok()) << to_string(anew.error());
    EXPECT_TRUE(scene::encode_scene(*anew) == scene::encode_scene(scene_of_plan(shop, plan, 1)))
        << shelf.fixture << " " << shelf.shelf;
  }
  EXPECT_GT(fast, 5);
  EXPECT_GT(slow, 0) << "heaps are planned with the zone's range";
}

TEST(Restock, IsNotForWhatReachesFurther) {
  HandLaidShop shop = shop_of_all_zones();
  const scene::Scene scene = scene_of(shop);
  const plan::Plan plan = plan_with(file_of(scene_of(shop, 2)), scene, shop.plan);
  const auto is_for = [&](const plan::Plan& before, const plan::Plan& after) {
    return scene::shelves_changed(before, after, committed_catalog(), scene).has_value();
  };
  EXPECT_TRUE(is_for(shop.plan, plan));
  EXPECT_FALSE(is_for(plan, shop.plan)) << "taken back";
  plan::Plan untidy = plan;
  untidy.zones[0].stock.misplaced = 0.1;
  EXPECT_FALSE(is_for(shop.plan, untidy));
  plan::Plan higher = plan;
  higher.shell.ceiling_mm += 100;
  EXPECT_FALSE(is_for(shop.plan, higher));
}

}  // namespace
}  // namespace marketgen
