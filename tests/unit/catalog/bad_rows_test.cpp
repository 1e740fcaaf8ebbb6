// Faulty rows of a user's own catalogue file: each names its code and its place.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "catalog/catalog.h"

namespace marketgen {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view good_row =
    R"([{"sku": "own-cola", "ean": "2999999999991", "name": "Cola", "brand": "Own",
  "category": "beverages", "subcategory": "soft drinks", "archetype": "can", "size_mm": [66, 66, 115], "mass_kg": 0.35,
  "label": {"primary": "#aa0000"}}])";

// The good row with one piece of text replaced.
std::string with(std::string_view from, std::string_view to) {
  std::string text(good_row);
  const std::size_t at = text.find(from);
  if (at == std::string::npos) fatal("the row has no such text");
  return text.replace(at, from.size(), to);
}

class OwnRows : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    file_ = fs::path(testing::TempDir()) /
            (std::string("marketgen_own_rows_") + test->name() + ".json");
  }
  void TearDown() override { fs::remove(file_); }

  Result<catalog::Catalog> load(const std::string& text) {
    std::ofstream(file_, std::ios::binary) << text;
    return catalog::load_catalog(fs::path(MARKETGEN_SOURCE_DIR) / "data", {file_});
  }

  void expect_error(const std::string& text,
                    const std::string& code,
                    const std::string& place,
                    const std::string& says) {
    const auto loaded = load(text);
    ASSERT_FALSE(loaded.ok()) << text;
    EXPECT_EQ(loaded.error().code, code) << to_string(loaded.error());
    EXPECT_NE(loaded.error().where.find(place), std::string::npos) << to_string(loaded.error());
    EXPECT_NE(loaded.error().message.find(says), std::string::npos) << to_string(loaded.error());
  }

  fs::path file_;
};

TEST_F(OwnRows, GoodRowStandsBesideOurs) {
  const auto loaded = load(std::string(good_row));
  ASSERT_TRUE(loaded.ok()) << to_string(loaded.error());
  ASSERT_NE(loaded->product("own-cola"), nullptr);
  EXPECT_EQ(loaded->product("own-cola")->name, "Cola");
  const auto ours = catalog::load_catalog(fs::path(MARKETGEN_SOURCE_DIR) / "data");
  ASSERT_TRUE(ours.ok());
  EXPECT_EQ(loaded->products.size(), ours->products.size() + 1);
  EXPECT_NE(loaded->content_hash, ours->content_hash);
}

TEST_F(OwnRows, SlippedDigitOfTheMass) {  // 3.5 kg in a 330 ml can: 7 t/m3
  expect_error(with("0.35", "3.5"), "catalog.bad_row", "products/own-cola", "check mass and size");
}
TEST_F(OwnRows, SlippedDigitOfTheSize) {  // 1.15 m of can weigh 350 g
  expect_error(
      with("66, 66, 115", "666, 66, 1150"), "catalog.bad_row", "products/own-cola", "kg/m3");
}
TEST_F(OwnRows, WrongCheckDigit) {
  expect_error(with("2999999999991", "2999999999998"),
               "catalog.bad_row",
               "products/own-cola",
               "check digit");
}
TEST_F(OwnRows, PrefixOfSomebody) {
  expect_error(with("2999999999991", "4006381333931"),
               "catalog.bad_row",
               "products/own-cola",
               "may belong to somebody");
}
TEST_F(OwnRows, NeitherEanNorPlu) {
  expect_error(
      with("2999999999991", ""), "catalog.bad_row", "products/own-cola", "needs an EAN-13");
}
TEST_F(OwnRows, ContentsAreColoursAndPiecesStandBehindOpaqueOnes) {
  const auto contents = [&](const std::string& text) {
    return with(R"("label": {)", R"("contents": )" + text + R"(, "label": {)");
  };
  EXPECT_TRUE(load(contents(R"({"color": "#1e0d08", "opacity": "clear", "fill": 0.9})")).ok());
  expect_error(
      contents(R"({"color": "brown"})"), "catalog.bad_row", "products/own-cola", "\"brown\"");
  expect_error(contents(R"({"color": "#1e0d08", "particle_mm": 4})"),
               "catalog.bad_row",
               "products/own-cola",
               "colour");
  expect_error(
      contents(
          R"({"color": "#1e0d08", "opacity": "clear", "particle_mm": 4, "particle_color": "#ffffff"})"),
      "catalog.bad_row",
      "products/own-cola",
      "opaque contents only");
}
TEST_F(OwnRows, DuplicateSku) {
  std::string twice(good_row);
  twice.pop_back();
  twice += "," + std::string(good_row.substr(1));
  expect_error(twice, "catalog.duplicate_sku", "products/own-cola", "two rows");
}
TEST_F(OwnRows, DuplicateEan) {
  std::string twice(good_row);
  twice.pop_back();
  twice += "," + with("own-cola", "own-other").substr(1);
  expect_error(twice, "catalog.duplicate_sku", "products/own-other", "belongs to own-cola");
}
TEST_F(OwnRows, UnknownCategory) {
  expect_error(with("\"beverages\"", "\"beverage\""),
               "catalog.bad_row",
               "products/own-cola/category",
               "did you mean \"beverages\"?");
}
TEST_F(OwnRows, BadColour) {
  for (const char* color : {"aa0000", "#aa000", "#aa00000", "#gg0000", "red", ""}) {
    expect_error(with("#aa0000", color), "catalog.bad_row", "products/own-cola", "#rrggbb");
  }
}
TEST_F(OwnRows, UnknownFieldSuggestsTheNearest) {
  expect_error(with("\"mass_kg\"", "\"mass_kilo\""),
               "json.unknown_field",
               ":/0/mass_kilo",
               "did you mean \"mass_kg\"?");
}
TEST_F(OwnRows, MissingField) {
  expect_error(
      with(R"("category": "beverages",)", ""), "json.missing_field", ":/0", "\"category\"");
}
TEST_F(OwnRows, SizeOutsideItsLimits) {
  expect_error(with("66, 66, 115", "66, 66, 1501"), "json.out_of_range", ":/0/size_mm/2", "1501");
}
TEST_F(OwnRows, SizeWithTwoNumbers) {
  expect_error(with("66, 66, 115", "66, 115"), "json.wrong_type", ":/0/size_mm", "list of 3");
}
TEST_F(OwnRows, SkuThatIsNoId) {
  expect_error(with("own-cola", "../cola"), "json.bad_identifier", ":/0/sku", "is not an id");
}
TEST_F(OwnRows, FileThatIsNotThere) {
  const auto loaded =
      catalog::load_catalog(fs::path(MARKETGEN_SOURCE_DIR) / "data", {"/no/such/rows.json"});
  ASSERT_FALSE(loaded.ok());
  EXPECT_EQ(loaded.error().code, "input.not_found");
}
TEST_F(OwnRows, DataFolderThatIsNone) {
  const auto loaded = catalog::load_catalog(testing::TempDir());
  ASSERT_FALSE(loaded.ok());
  EXPECT_EQ(loaded.error().code, "catalog.missing_data");
}

// Rules on the other tables, seen through a changed copy of ours.
TEST(BadRows, ReferencesBetweenTablesMustHold) {
  auto loaded = catalog::load_catalog(fs::path(MARKETGEN_SOURCE_DIR) / "data");
  ASSERT_TRUE(loaded.ok());
  const catalog::Catalog good = std::move(loaded).value();
  const auto code_of = [](const catalog::Catalog& catalog) {
    const auto checked = catalog::check_catalog(catalog);
    return checked.ok() ? std::string("ok") : checked.error().code + " " + checked.error().where;
  };
  catalog::Catalog bad = good;
  bad.zone_types[0].fixture = "gondolla";
  EXPECT_EQ(code_of(bad), "catalog.bad_row zone_types/" + good.zone_types[0].type + "/fixture");
  bad = good;
  bad.zone_types[0].categories = {"no-such"};
  EXPECT_EQ(code_of(bad), "catalog.bad_row zone_types/" + good.zone_types[0].type + "/categories");
  bad = good;
  bad.styles[0].floor = "lava";
  EXPECT_EQ(code_of(bad), "catalog.bad_row styles/" + good.styles[0].id);
  bad = good;
  bad.fixture_kinds[0].module_widths_mm.clear();
  EXPECT_EQ(code_of(bad), "catalog.bad_row fixtures/" + good.fixture_kinds[0].kind);
  bad = good;
  bad.profiles[0].zones.push_back("zoo");
  EXPECT_EQ(code_of(bad), "catalog.bad_row profiles/" + good.profiles[0].id + "/zones");
  bad = good;
  bad.materials.push_back(bad.materials[0]);
  EXPECT_EQ(code_of(bad), "catalog.duplicate_sku materials/" + good.materials[0].id);
}

}  // namespace
}  // namespace marketgen
