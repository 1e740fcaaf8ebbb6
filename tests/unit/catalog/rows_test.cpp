// The committed rows: they load, pass their own rules, and are as many as the store needs.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "catalog/catalog.h"
#include "catalog/gtin.h"
#include "io/file.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

// Whether src/marketgen/assets/shapes/archetypes.inc lists it; read as text because the catalogue
// may not include assets.
bool is_archetype(const std::string& name) {
  static const std::string list = [] {
    auto text = io::read_file(MARKETGEN_SOURCE_DIR "/src/marketgen/assets/shapes/archetypes.inc");
    if (!text.ok()) fatal(to_string(text.error()).c_str());
    return std::move(text).value();
  }();
  return list.find("ARCHETYPE(" + name + ",") != std::string::npos;
}

TEST(Rows, PassTheirOwnRules) {
  const auto checked = catalog::check_catalog(committed_catalog());
  EXPECT_TRUE(checked.ok()) << to_string(checked.error());
}

// A source that a reader can find, or an estimate that says so and gives its range.
TEST(Rows, EveryFrictionHasASource) {
  catalog::Catalog catalog = committed_catalog();
  std::map<std::string, const catalog::FrictionSource*> sources;
  for (const catalog::FrictionSource& source : catalog.friction_sources) {
    EXPECT_TRUE(sources.emplace(source.key, &source).second) << source.key;
    EXPECT_GE(source.text.size(), 60U) << source.key;
  }
  std::set<std::string> used;
  for (const catalog::FrictionRow& row : catalog.frictions) {
    const std::string pair = row.a + " on " + row.b;
    ASSERT_TRUE(sources.contains(row.source)) << pair << ": no source " << row.source;
    used.insert(row.source);
    if (sources[row.source]->is_estimate()) {
      EXPECT_LT(row.possible[0], row.sliding) << pair;
      EXPECT_GT(row.possible[1], row.sliding) << pair;
    } else {
      EXPECT_FALSE(row.detail.empty()) << pair << ": which entry of its source";
    }
  }
  EXPECT_EQ(used.size(), sources.size()) << "a source that no row names";
  catalog::FrictionRow& first = catalog.frictions.front();
  first.source = "hearsay";
  EXPECT_EQ(catalog::check_catalog(catalog).error().code, "catalog.bad_row");
  first.source = "estimate-rubber";
  first.possible = {};
  EXPECT_EQ(catalog::check_catalog(catalog).error().code, "catalog.bad_row");
}

TEST(Rows, ProductsAreSortedBySku) {
  const auto& products = committed_catalog().products;
  for (std::size_t i = 1; i < products.size(); ++i)
    EXPECT_LT(products[i - 1].sku, products[i].sku);
}

TEST(Rows, AreAWholeSupermarket) {
  std::map<std::string, int> products;
  std::set<std::string> nouns, brands, archetypes;
  for (const catalog::Product& p : committed_catalog().products) {
    ++products[p.category];
    nouns.insert(p.name);
    if (!p.brand.empty()) brands.insert(p.brand);
    archetypes.insert(p.archetype);
    EXPECT_TRUE(is_archetype(p.archetype)) << p.sku << ": " << p.archetype;
  }
  EXPECT_GE(committed_catalog().products.size(), 1500U);
  EXPECT_EQ(committed_catalog().categories.size(), 10U);
  for (const catalog::CategoryRow& category : committed_catalog().categories)
    EXPECT_GE(products[category.id], 120) << category.id;
  EXPECT_GE(nouns.size(), 300U);
  EXPECT_GE(brands.size(), 100U);
  EXPECT_GE(archetypes.size(), 60U);
}

TEST(Rows, LookAlikesAreMarked) {
  std::map<std::string, std::vector<const catalog::Product*>> families;
  for (const catalog::Product& p : committed_catalog().products) {
    EXPECT_FALSE(p.family.empty()) << p.sku;
    families[p.family].push_back(&p);
  }
  int several = 0;
  for (const auto& [family, members] : families) {
    several += members.size() > 1 ? 1 : 0;
    for (const catalog::Product* member : members)
      EXPECT_EQ(member->brand, members.front()->brand) << family;
  }
  EXPECT_GE(several, 200);
}

TEST(Rows, AreComplete) {
  for (const catalog::Product& p : committed_catalog().products) {
    EXPECT_FALSE(p.name_zh.empty()) << p.sku;
    EXPECT_FALSE(p.description.empty()) << p.sku;
    EXPECT_GE(p.keywords.size(), 2U) << p.sku;
    EXPECT_FALSE(p.net.empty()) << p.sku;
  }
}

TEST(Rows, FifteenFixtureKindsWithEveryTemperature) {
  std::set<catalog::Storage> temperatures;
  for (const catalog::FixtureKind& kind : committed_catalog().fixture_kinds)
    temperatures.insert(kind.temperature);
  EXPECT_GE(committed_catalog().fixture_kinds.size(), 15U);
  EXPECT_EQ(temperatures.size(), 3U);
}

TEST(Rows, FixtureKindsLieWithinTheirOwnRanges) {
  for (const catalog::FixtureKind& kind : committed_catalog().fixture_kinds) {
    EXPECT_LE(kind.depth_range_mm[0], kind.depth_mm) << kind.kind;
    EXPECT_GE(kind.depth_range_mm[1], kind.depth_mm) << kind.kind;
    EXPECT_LE(kind.height_range_mm[0], kind.height_mm) << kind.kind;
    EXPECT_GE(kind.height_range_mm[1], kind.height_mm) << kind.kind;
    EXPECT_LE(kind.level_range[0], kind.levels) << kind.kind;
    EXPECT_GE(kind.level_range[1], kind.levels) << kind.kind;
  }
}

TEST(Rows, LooseGoodsHavePluPackedGoodsEan) {
  for (const catalog::Product& p : committed_catalog().products) {
    EXPECT_NE(p.ean.empty(), p.plu.empty()) << p.sku;
    if (p.ean.empty()) continue;
    EXPECT_TRUE(catalog::is_ean13(p.ean) && catalog::is_restricted_circulation(p.ean))
        << p.sku << " " << p.ean;
  }
}

TEST(Rows, EveryProductHasAUnitPriceAShopperWouldBelieve) {  // a slipped digit in price or net
                                                             // quantity leaves this range
  for (const catalog::Product& p : committed_catalog().products) {
    const double unit_price = p.price / p.unit_amount;
    const bool by_piece = p.unit_of_measure == "piece";
    // Saffron, glue and eyeshadow are bought by the gram: a slip shows in the price of the pack.
    const bool by_gram = !by_piece && p.unit_amount <= 0.05;
    EXPECT_GT(unit_price, by_piece ? 0.002 : 0.1) << p.sku;
    EXPECT_LT(by_gram ? p.price : unit_price, by_gram ? 30 : 400) << p.sku;
  }
}

TEST(Rows, FindersFindWhatIsThereAndNothingElse) {
  const catalog::Catalog& catalog = committed_catalog();
  for (const catalog::Product& p : catalog.products)
    EXPECT_EQ(catalog.product(p.sku), &p);
  EXPECT_EQ(catalog.product("no-such-sku"), nullptr);
  EXPECT_EQ(catalog.product(""), nullptr);
  EXPECT_NE(catalog.fixture_kind("gondola"), nullptr);
  EXPECT_EQ(catalog.fixture_kind("gondolas"), nullptr);
  EXPECT_NE(catalog.zone_type("dairy"), nullptr);
  EXPECT_NE(catalog.profile("supermarket-eu"), nullptr);
  EXPECT_EQ(catalog.style("baroque"), nullptr);
}

TEST(Rows, HashChangesWithARow) {
  const auto again = catalog::load_catalog(std::filesystem::path(MARKETGEN_SOURCE_DIR) / "data");
  ASSERT_TRUE(again.ok());
  EXPECT_EQ(again->content_hash, committed_catalog().content_hash);
  EXPECT_EQ(committed_catalog().content_hash.size(), 32U);
}

TEST(Rows, UnknownNameSuggestsTheNearest) {
  const Error near = catalog::unknown_name(
      "catalog.unknown_kind", "plan", "fixture kind", "gondla", {"gondola", "bin"});
  EXPECT_EQ(near.message, "there is no fixture kind \"gondla\"; did you mean \"gondola\"?");
  const Error far = catalog::unknown_name(
      "catalog.unknown_kind", "plan", "fixture kind", "zzzzzzzz", {"gondola", "bin"});
  EXPECT_EQ(far.message, "there is no fixture kind \"zzzzzzzz\"; known are: gondola, bin");
}

}  // namespace
}  // namespace marketgen
