// How far a store stands as a planogram says, against what was disturbed in it.
#include "audit/compliance.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <set>

#include "scene/planogram_rows.h"
#include "scene/price_tags.h"
#include "scene/shelf_fill.h"
#include "support/hand_laid_shop.h"

namespace marketgen {
namespace {

scene::Scene tidy_or(const HandLaidShop& shop) {
  auto built = scene::build_scene(shop.layout, shop.plan, committed_catalog(), Seed(3));
  if (!built.ok()) fatal(to_string(built.error()).c_str());
  return std::move(built).value();
}

HandLaidShop tidy_shop(double out_of_stock = 0) {
  HandLaidShop shop = shop_of(selling_types());
  for (plan::Zone& zone : shop.plan.zones)
    zone.stock.out_of_stock = out_of_stock;
  return shop;
}

std::string file_of(const scene::Scene& scene) {
  std::string text = "fixture,side,shelf,position,sku,x_mm,facings_wide\n";
  for (const scene::PlanogramRow& row : scene::planogram_rows(scene))
    text += fmt::format("{},{},{},{},{},{},{}\n",
                        row.fixture,
                        row.side == 0 ? "front" : "back",
                        row.level + 1,
                        row.position + 1,
                        row.sku,
                        row.bay_x_mm,
                        row.facings);
  return text;
}

audit::Compliance compliance(const scene::Scene& scene,
                             const std::string& file,
                             const HandLaidShop& shop) {
  const auto read = scene::read_planogram(file, "p.csv", scene, shop.plan, committed_catalog());
  if (!read.ok()) fatal(to_string(read.error()).c_str());
  EXPECT_TRUE(read->refused.empty());
  return audit::compliance_of(scene, *read, committed_catalog());
}

TEST(Compliance, OfATidyStoreWithItsOwnPlanogramIsOne) {
  const HandLaidShop shop = tidy_shop();
  const scene::Scene scene = tidy_or(shop);
  const audit::Compliance c = compliance(scene, file_of(scene), shop);
  std::uint64_t facings = 0;
  for (const scene::Facing& facing : scene.facings)
    facings += facing.facings;
  EXPECT_EQ(c.facings.planned, facings);
  EXPECT_EQ(c.score, 1);
  EXPECT_EQ(c.tag_score, 1);
  EXPECT_EQ(c.tags.planned, scene.price_labels.size());
  EXPECT_EQ(c.extra, 0U);
  EXPECT_TRUE(c.unmet.empty());
}

TEST(Compliance, LosesTheFacingsThatAreSoldOut) {
  const HandLaidShop shop = tidy_shop(0.2);
  const scene::Scene scene = tidy_or(shop);
  std::uint64_t gone = 0;
  for (const scene::Facing& facing : scene.facings)
    gone += facing.product_count == 0 ? facing.facings : 0;
  ASSERT_GT(gone, 20U);
  const audit::Compliance c = compliance(scene, file_of(scene), shop);
  EXPECT_EQ(c.facings.missing, gone);
  EXPECT_EQ(c.facings.met + gone, c.facings.planned);
  EXPECT_EQ(c.facings.wrong_product + c.facings.misplaced, 0U);
}

// Strangers in front: one a facing, whoever stands behind or below.
TEST(Compliance, LosesOneFacingForEachStrangerInFront) {
  HandLaidShop shop = tidy_shop();
  const scene::Scene tidy = tidy_or(shop);
  for (plan::Zone& zone : shop.plan.zones)
    zone.stock.misplaced = 0.1;
  const scene::Scene untidy = tidy_or(shop);
  std::set<std::string> planned;
  for (const scene::Facing& facing : tidy.facings)
    planned.insert(tidy.catalog[facing.sku].sku);
  std::uint64_t misplaced = 0, wrong = 0;
  for (const scene::SceneProduct& item : untidy.products) {
    if ((item.flags & scene::product_misplaced) == 0) continue;
    ++(planned.contains(untidy.catalog[item.sku].sku) ? misplaced : wrong);
  }
  ASSERT_GT(misplaced + wrong, 10U);
  const audit::Compliance c = compliance(untidy, file_of(tidy), shop);
  EXPECT_EQ(c.facings.misplaced, misplaced);
  EXPECT_EQ(c.facings.wrong_product, wrong);
  EXPECT_EQ(c.unmet.size(), misplaced + wrong);
  EXPECT_EQ(c.facings.missing, 0U);
  EXPECT_DOUBLE_EQ(
      c.score, 1 - static_cast<double>(misplaced + wrong) / static_cast<double>(c.facings.planned));
}

TEST(Compliance, CountsPriceTagsByTheirFault) {
  HandLaidShop shop = tidy_shop();
  const scene::Scene tidy = tidy_or(shop);
  for (plan::Zone& zone : shop.plan.zones)
    zone.stock.price_tags = plan::PriceTagSpec{0.1, 0.1, 0, 0.2};
  const scene::Scene faulty = tidy_or(shop);
  std::vector<int> hanging(faulty.facings.size(), 0), wrong(faulty.facings.size(), 0);
  for (const scene::PriceLabel& tag : faulty.price_labels) {
    ++hanging[tag.facing];
    wrong[tag.facing] += scene::fault_of(faulty, tag) == scene::TagFault::none ? 0 : 1;
  }
  std::uint64_t missing = 0, wrong_price = 0, doubled = 0;
  for (const scene::PriceLabel& tag : tidy.price_labels) {
    missing += hanging[tag.facing] == 0 ? 1 : 0;
    wrong_price += hanging[tag.facing] == 1 && wrong[tag.facing] == 1 ? 1 : 0;
    doubled += hanging[tag.facing] == 2 ? 1 : 0;
  }
  ASSERT_GT(std::min({missing, wrong_price, doubled}), 0U);
  const audit::Compliance c = compliance(faulty, file_of(tidy), shop);
  EXPECT_EQ(c.tags.missing, missing);
  EXPECT_EQ(c.tags.wrong_price, wrong_price);
  EXPECT_EQ(c.tags.doubled, doubled);
  EXPECT_EQ(c.tags.right, tidy.price_labels.size() - missing - wrong_price - doubled);
  EXPECT_EQ(c.score, 1);
}

TEST(Compliance, CountsPacksWhereNothingIsPlanned) {
  const HandLaidShop shop = tidy_shop();
  const scene::Scene scene = tidy_or(shop);
  const scene::Facing& facing = scene.facings.at(0);
  const scene::SceneShelf& shelf = scene.shelves[facing.shelf];
  std::uint64_t packs = 0;
  for (const scene::Facing& f : scene.facings)
    packs += f.shelf == facing.shelf ? f.product_count : 0;
  const std::string empty = fmt::format("fixture,side,shelf,sku,facings_wide\n{},{},{},,\n",
                                        scene.layout.fixtures[shelf.fixture].id,
                                        shelf.side == 0 ? "front" : "back",
                                        shelf.level + 1);
  const audit::Compliance c = compliance(scene, empty, shop);
  EXPECT_EQ(c.extra, packs);
  EXPECT_EQ(c.score, 1);
  ASSERT_EQ(c.shelves.size(), 1U);
  EXPECT_EQ(c.shelves[0].extra, packs);
}

TEST(Compliance, SumsShelvesAndCategories) {
  const HandLaidShop shop = tidy_shop(0.3);
  const scene::Scene scene = tidy_or(shop);
  const audit::Compliance c = compliance(scene, file_of(scene), shop);
  std::uint64_t by_shelf = 0, by_category = 0;
  for (const audit::ShelfCompliance& row : c.shelves)
    by_shelf += row.facings.met;
  for (const audit::CategoryCompliance& row : c.categories)
    by_category += row.facings.met;
  EXPECT_EQ(by_shelf, c.facings.met);
  EXPECT_EQ(by_category, c.facings.met);
  EXPECT_GT(c.categories.size(), 5U);
}

}  // namespace
}  // namespace marketgen
