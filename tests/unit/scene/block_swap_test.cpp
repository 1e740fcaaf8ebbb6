// Blocks of products that change places in a stocked scene.
#include "scene/block_swap.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "scene/planogram_rows.h"
#include "scene/scene_file.h"
#include "scene_of.h"

namespace marketgen {
namespace {

std::string place(const scene::PlanogramRow& row) {
  return fmt::format(R"("fixture": "{}", "side": "{}", "shelf": {}, "position": {}, "sku": "{}")",
                     row.fixture,
                     row.side == 0 ? "front" : "back",
                     row.level + 1,
                     row.position + 1,
                     row.sku);
}

plan::PatchSet swap_of(const std::string& a, const std::string& b) {
  auto set =
      plan::read_patches(R"({"schema": "market-patch/1", "patches": [{"swap_blocks": {"a": {)" + a +
                             R"(}, "b": {)" + b + "}}}]}",
                         "p.json");
  if (!set.ok()) fatal(to_string(set.error()).c_str());
  return std::move(set).value();
}

// A shop of cans and its scene, before and after swaps.
struct Shop {
  HandLaidShop laid = shop_of({"canned"});
  scene::Scene scene = scene_of(laid);
  std::vector<scene::PlanogramRow> rows = scene::planogram_rows(scene);

  Result<void> swap(const plan::PatchSet& set) {
    MARKETGEN_TRY(
        const plan::Plan said,
        scene::with_swapped_shelves(laid.plan, set, "p.json", scene, committed_catalog()));
    MARKETGEN_TRY(plan::Patched then,
                  plan::patched(said, set.patches.at(0), committed_catalog(), "p.json:/patches/0"));
    MARKETGEN_CHECK(scene::check_swapped(then.plan, set, "p.json", scene, committed_catalog()));
    laid.plan = std::move(then.plan);
    scene = scene_of(laid);
    rows = scene::planogram_rows(scene);
    return {};
  }
};

// What stands where, shelf by shelf.
std::map<std::string, std::string> blocks_of(const std::vector<scene::PlanogramRow>& rows) {
  std::map<std::string, std::string> blocks;
  for (const scene::PlanogramRow& row : rows)
    blocks[fmt::format("{} {} {} {}", row.fixture, row.side, row.level, row.position)] =
        fmt::format("{} {}", row.sku, row.facings);
  return blocks;
}

std::string key(const scene::PlanogramRow& row) {
  return fmt::format("{} {} {} {}", row.fixture, row.side, row.level, row.position);
}

TEST(BlockSwap, TwoOfAShelfTradePlacesAndTheRestStays) {
  Shop shop;
  const auto before = blocks_of(shop.rows);
  const std::string hash = scene::scene_hash(shop.scene);
  const scene::PlanogramRow a = shop.rows.at(0), b = shop.rows.at(1);
  ASSERT_EQ(a.level, b.level);
  ASSERT_NE(a.sku, b.sku);
  const auto done = shop.swap(swap_of(place(a), place(b)));
  ASSERT_TRUE(done.ok()) << to_string(done.error());
  auto wanted = before;
  std::swap(wanted[key(a)], wanted[key(b)]);
  EXPECT_EQ(blocks_of(shop.rows), wanted);
  ASSERT_EQ(shop.laid.plan.planogram->size(), 1U);
  for (const plan::ShelfBlock& block : shop.laid.plan.planogram->front().blocks)
    EXPECT_FALSE(block.x_mm || block.facings_high || block.facings_deep)
        << "no more is pinned than the stocker would do otherwise";
  const auto back = shop.swap(swap_of(place(shop.rows.at(0)), place(shop.rows.at(1))));
  ASSERT_TRUE(back.ok()) << to_string(back.error());
  EXPECT_EQ(scene::scene_hash(shop.scene), hash);
}

// Every pair of blocks of two shelves: either they trade places, or it is said what does not fit.
TEST(BlockSwap, OfTwoShelvesIsDoneOrRefusedWithWhatHelps) {
  const Shop first;
  int done = 0, refused = 0, narrowed = 0;
  for (const scene::PlanogramRow& a : first.rows) {
    for (const scene::PlanogramRow& b : first.rows) {
      if (a.side != 0 || b.side != 0 || a.level >= b.level) continue;
      Shop shop = first;
      const auto swapped = shop.swap(swap_of(place(a), place(b)));
      if (swapped.ok()) {
        auto wanted = blocks_of(first.rows);
        std::swap(wanted[key(a)], wanted[key(b)]);
        EXPECT_EQ(blocks_of(shop.rows), wanted);
        ++done;
        continue;
      }
      ++refused;
      ASSERT_EQ(swapped.error().code, "planogram.does_not_fit") << to_string(swapped.error());
      const std::string& says = swapped.error().message;
      const std::size_t hint = says.find("\"facings\": ");
      if (hint == std::string::npos) continue;
      const std::string fewer =
          ", \"facings\": " + std::to_string(std::stoi(says.substr(hint + 11)));
      const bool is_a = swapped.error().where.find("/swap_blocks/a/") != std::string::npos;
      const auto again =
          shop.swap(swap_of(place(a) + (is_a ? fewer : ""), place(b) + (is_a ? "" : fewer)));
      EXPECT_TRUE(again.ok() || again.error().where != swapped.error().where)
          << says << "\n"
          << to_string(again.error());
      ++narrowed;
    }
  }
  EXPECT_GT(done, 0);
  EXPECT_GT(refused, 0);
  EXPECT_GT(narrowed, 0);
}

TEST(BlockSwap, NamesShelvesThatAreNotThere) {
  Shop shop;
  const std::string a = place(shop.rows.at(0));
  const auto far =
      shop.swap(swap_of(a, R"("fixture": "canned/run-1/module-1", "shelf": 77, "position": 1)"));
  ASSERT_FALSE(far.ok());
  EXPECT_EQ(far.error().where, "p.json:/patches/0/swap_blocks/b/shelf");
  const auto gone =
      shop.swap(swap_of(R"("fixture": "canned/run-1/modul-1", "shelf": 1, "position": 1)", a));
  ASSERT_FALSE(gone.ok());
  EXPECT_NE(gone.error().message.find("did you mean"), std::string::npos);
}

}  // namespace
}  // namespace marketgen
