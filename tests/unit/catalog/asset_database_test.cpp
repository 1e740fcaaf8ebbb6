// The asset database: what its filters keep, and that its cache never changes an answer.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>

#include "catalog/asset_database.h"
#include "io/file.h"
#include "support/committed_catalog.h"
#include "support/run_program.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

catalog::Product product(std::string sku,
                         std::string category,
                         std::string subcategory,
                         catalog::Storage storage) {
  catalog::Product p;
  p.sku = std::move(sku);
  p.name = "Thing";
  p.category = std::move(category);
  p.subcategory = std::move(subcategory);
  p.storage = storage;
  p.archetype = "box";
  return p;
}

catalog::FixtureKind fixture(std::string kind,
                             catalog::FixtureRole role,
                             catalog::Storage temperature) {
  catalog::FixtureKind k;
  k.kind = std::move(kind);
  k.name = "Facility";
  k.role = role;
  k.temperature = temperature;
  return k;
}

catalog::MaterialRow material(std::string id, std::string name) {
  catalog::MaterialRow m;
  m.id = std::move(id);
  m.name = std::move(name);
  return m;
}

catalog::Catalog small_catalog() {
  catalog::Catalog catalog;
  catalog.products = {product("bread", "bakery", "bread", catalog::Storage::ambient),
                      product("cheese", "dairy", "cheese", catalog::Storage::chilled),
                      product("juice", "beverages", "juice", catalog::Storage::ambient),
                      product("peas", "frozen", "vegetables", catalog::Storage::frozen),
                      product("uht", "dairy", "milk", catalog::Storage::ambient)};
  catalog.products[0].size_mm = {200, 100, 100};
  catalog.products[1].size_mm = {90, 60, 40};
  catalog.products[1].mass_kg = 0.3;
  catalog.products[2].name = "Organic Thing";
  catalog.fixture_kinds = {
      fixture("gondola", catalog::FixtureRole::shelving, catalog::Storage::ambient),
      fixture("cooler", catalog::FixtureRole::shelving, catalog::Storage::chilled),
      fixture("till", catalog::FixtureRole::checkout, catalog::Storage::ambient)};
  catalog.fixture_kinds[0].material = "wood";
  catalog.materials = {material("wood", "Wood"), material("bio-green", "Bio plaster")};
  catalog.categories = {{"bakery", "Bakery"}, {"dairy", "Dairy"}};
  catalog::ZoneTypeRow chilled;
  chilled.type = "chilled";
  chilled.fixture = "cooler";
  chilled.temperature = catalog::Storage::chilled;
  chilled.categories = {"dairy", "beverages"};
  catalog::ZoneTypeRow tills;
  tills.type = "tills";
  tills.fixture = "till";
  catalog::ZoneTypeRow offers;
  offers.type = "offers";
  offers.fixture = "gondola";
  catalog.zone_types = {chilled, tills, offers};
  catalog::StyleRow organic;
  organic.id = "organic";
  organic.floor = organic.wall = organic.ceiling = organic.fixture = "wood";
  organic.keywords = {"organic", "bio"};
  catalog.styles = {organic};
  return catalog;
}

std::set<std::string> ids(const catalog::AssetQuery& query) {
  const catalog::Catalog catalog = small_catalog();
  const auto database = catalog::AssetDatabase::build(catalog);
  EXPECT_TRUE(database.ok()) << to_string(database.error());
  const auto found = database->find(query);
  EXPECT_TRUE(found.ok()) << to_string(found.error());
  std::set<std::string> names;
  for (const catalog::AssetHit& hit : *found) {
    names.insert(hit.kind == catalog::AssetKind::goods      ? catalog.products[hit.row].sku
                 : hit.kind == catalog::AssetKind::facility ? catalog.fixture_kinds[hit.row].kind
                                                            : catalog.materials[hit.row].id);
  }
  return names;
}

using Ids = std::set<std::string>;

TEST(AssetDatabase, EmptyQueryIsEverythingInOrder) {
  const auto database = catalog::AssetDatabase::build(small_catalog());
  const auto found = database->find({});
  ASSERT_EQ(found->size(), 10U);
  EXPECT_EQ(found->front().kind, catalog::AssetKind::goods);
  EXPECT_EQ(found->at(5).row, 1U);  // "cooler" before "gondola", whatever the file's order
  EXPECT_EQ(found->back().kind, catalog::AssetKind::material);
}

TEST(AssetDatabase, ZoneKnowsItsGoodsAndFacilities) {
  // Its categories, chilled and (drinks in a cooler) ambient; every chilled shelving.
  EXPECT_EQ(ids({.zone = "chilled"}), (Ids{"cheese", "juice", "uht", "cooler"}));
  EXPECT_EQ(ids({.zone = "tills"}), Ids{"till"});                                 // sells nothing
  EXPECT_EQ(ids({.zone = "offers"}), (Ids{"bread", "juice", "uht", "gondola"}));  // sells all
}

TEST(AssetDatabase, Filters) {
  EXPECT_EQ(ids({.category = "dairy"}), (Ids{"cheese", "uht"}));
  EXPECT_EQ(ids({.category = "dairy", .subcategory = "milk"}), Ids{"uht"});
  EXPECT_EQ(ids({.storage = "frozen"}), Ids{"peas"});
  EXPECT_EQ(ids({.kinds = {catalog::AssetKind::goods}, .max_width_mm = 60}),
            (Ids{"juice", "peas", "uht"}));  // 60 mm each
  EXPECT_EQ(ids({.max_width_mm = 100, .max_height_mm = 40}), Ids{"cheese"});
  EXPECT_EQ(ids({.category = "dairy", .max_mass_kg = 0.2}), Ids{"uht"});
  EXPECT_EQ(ids({.kinds = {catalog::AssetKind::material}}), (Ids{"wood", "bio-green"}));
  EXPECT_EQ(ids({.material = "wood"}), Ids{"gondola"});
  EXPECT_EQ(ids({.text = "facility", .storage = "chilled"}), Ids{"cooler"});
}

TEST(AssetDatabase, StyleIsItsMaterialsAndItsWords) {
  EXPECT_EQ(ids({.style = "organic"}), (Ids{"wood", "gondola", "bio-green", "juice"}));
}

TEST(AssetDatabase, UnknownNamesAreRefusedWithTheNearest) {
  const auto database = catalog::AssetDatabase::build(small_catalog());
  for (const catalog::AssetQuery& query : {catalog::AssetQuery{.zone = "chiled"},
                                           catalog::AssetQuery{.category = "dary"},
                                           catalog::AssetQuery{.style = "organik"},
                                           catalog::AssetQuery{.storage = "frosen"}}) {
    const auto found = database->find(query);
    ASSERT_FALSE(found.ok());
    EXPECT_EQ(found.error().code, "catalog.unknown_kind");
    EXPECT_NE(found.error().message.find("did you mean"), std::string::npos)
        << found.error().message;
  }
}

// $MARKETGEN_CACHE for one test.
class AssetCache : public testing::Test {
 protected:
  void SetUp() override { setenv("MARKETGEN_CACHE", scratch_.path().c_str(), 1); }
  void TearDown() override { unsetenv("MARKETGEN_CACHE"); }

  std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::recursive_directory_iterator(scratch_.path()))
      if (entry.is_regular_file()) found.push_back(entry.path());
    return found;
  }
  ScratchFolder scratch_;
};

std::vector<double> scores(const catalog::AssetDatabase& database, const std::string& text) {
  std::vector<double> list;
  for (const catalog::AssetHit& hit : database.find({.text = text}).value()) {
    list.push_back(hit.row);
    list.push_back(hit.score);
  }
  return list;
}

TEST_F(AssetCache, KeptDatabaseAnswersAsTheFreshOne) {
  const auto fresh = catalog::AssetDatabase::build(committed_catalog());
  const auto first = catalog::AssetDatabase::open(committed_catalog());
  ASSERT_EQ(files().size(), 1U);
  const auto second = catalog::AssetDatabase::open(committed_catalog());
  ASSERT_TRUE(second.ok());
  for (const char* text : {"milk", "something to clean windows", "water without gas"}) {
    EXPECT_EQ(scores(*fresh, text), scores(*first, text));
    EXPECT_EQ(scores(*fresh, text), scores(*second, text));
  }
}

TEST_F(AssetCache, DamagedFileIsMadeAgain) {
  ASSERT_TRUE(catalog::AssetDatabase::open(committed_catalog()).ok());
  ASSERT_EQ(files().size(), 1U);
  const std::string good = contents_of(files()[0]);
  for (const std::string& bad :
       {std::string(), std::string("nonsense"), good.substr(0, good.size() / 2)}) {
    std::ofstream(files()[0], std::ios::binary) << bad;
    const auto database = catalog::AssetDatabase::open(committed_catalog());
    ASSERT_TRUE(database.ok());
    EXPECT_FALSE(database->find({.text = "milk"})->empty());
    EXPECT_EQ(contents_of(files()[0]), good);
  }
}

TEST_F(AssetCache, UnwritableCacheCostsOnlyTime) {
  setenv("MARKETGEN_CACHE", "/proc/no-such-folder", 1);
  EXPECT_TRUE(catalog::AssetDatabase::open(committed_catalog()).ok());
}

}  // namespace
}  // namespace marketgen
