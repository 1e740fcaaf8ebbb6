// Tables about a scene: rows, filters, CSV and JSON.
#include "scene/query.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "support/hand_made_scene.h"

namespace marketgen {
namespace {

scene::Scene query_sample() {
  HandMadeScene made;
  made.stock();
  made.scene.catalog[0].name = "Cereal, \"crunchy\"\nwith nuts";
  made.scene.layout.zones.push_back(
      {"dry", "dry_goods", "Dry goods", {{0, 0}, {1000, 0}, {1000, 2000}, {0, 2000}}, 2});
  return std::move(made.scene);
}

scene::Table table_of(std::string_view name, std::string_view where = "") {
  auto table = scene::query_scene(query_sample(), name, where);
  if (!table.ok()) fatal(to_string(table.error()).c_str());
  return std::move(table).value();
}

std::size_t rows_where(std::string_view where) {
  return table_of("products", where).rows.size();
}

TEST(Query, ProductRowsSayWhatStandsWhere) {
  const scene::Table table = table_of("products");
  EXPECT_EQ(table.columns,
            (std::vector<std::string>{"id",
                                      "sku",
                                      "ean",
                                      "name",
                                      "category",
                                      "fixture",
                                      "level",
                                      "zone",
                                      "x_m",
                                      "y_m",
                                      "z_m",
                                      "yaw_deg",
                                      "price",
                                      "misplaced"}));
  ASSERT_EQ(table.rows.size(), 8U);
  EXPECT_EQ(table.rows[0],
            (std::vector<std::string>{"dry/run-1/module-1/level-0/facing-0/item-0",
                                      "can-cola",
                                      "2000000000015",
                                      "Fonda Cola",
                                      "beverages",
                                      "dry/run-1/module-1",
                                      "0",
                                      "dry",
                                      "2.6",
                                      "3.6",
                                      "0.15",
                                      "0",
                                      "0.99",
                                      "false"}));
}

TEST(Query, OtherTables) {
  const scene::Table fixtures = table_of("fixtures");
  ASSERT_EQ(fixtures.rows.size(), 1U);
  EXPECT_EQ(fixtures.rows[0].front(), "dry/run-1/module-1");
  EXPECT_EQ(fixtures.rows[0].back(), "8");
  const scene::Table zones = table_of("zones");
  ASSERT_EQ(zones.rows.size(), 1U);
  EXPECT_EQ(zones.rows[0],
            (std::vector<std::string>{"dry", "dry_goods", "Dry goods", "2", "1", "8"}));
  const scene::Table prices = table_of("prices", "sku=can-cola");
  ASSERT_EQ(prices.rows.size(), 1U);
  EXPECT_EQ(prices.rows[0],
            (std::vector<std::string>{"can-cola",
                                      "2000000000015",
                                      "Fonda Cola",
                                      "330 ml",
                                      "0.99",
                                      "3",
                                      "l",
                                      "false",
                                      "1",
                                      "5",
                                      "EUR"}));
  EXPECT_EQ(table_of("prices", "promotion=true").rows.size(), 1U);
  EXPECT_EQ(table_of("planogram").rows.size(), 8U);
  EXPECT_EQ(table_of("materials").rows.size(), 0U);
}

TEST(Query, FiltersWithKnownAnswers) {  // five cans on level 0, three boxes on level 1
  EXPECT_EQ(rows_where("level=0"), 5U);
  EXPECT_EQ(rows_where("level!=0"), 3U);
  EXPECT_EQ(rows_where("level<1"), 5U);
  EXPECT_EQ(rows_where("level<=1"), 8U);
  EXPECT_EQ(rows_where("level>0"), 3U);
  EXPECT_EQ(rows_where("level>=1"), 3U);
  EXPECT_EQ(rows_where("sku=can-cola"), 5U);
  EXPECT_EQ(rows_where("name~COLA"), 5U);
  EXPECT_EQ(rows_where("name~crunchy"), 3U);
  EXPECT_EQ(rows_where("level=0,x_m<2.7"), 2U);  // 2.6 and 2.672
  EXPECT_EQ(rows_where("price=0.990"), 8U);      // numbers, not texts
  EXPECT_EQ(rows_where("zone="), 0U);
  EXPECT_EQ(rows_where("misplaced=true"), 0U);
}

TEST(Query, OperatorsInsideAValueAreText) {
  EXPECT_EQ(rows_where("name~a=b"), 0U);
  EXPECT_EQ(rows_where("sku=a<=b"), 0U);
  EXPECT_EQ(rows_where("sku!=a~b"), 8U);
}

TEST(Query, AValueThatTheColumnCannotHaveIsAnErrorWithItsPlace) {
  const scene::Scene scene = query_sample();
  for (const std::string where : {"price<abc",
                                  "level=low",
                                  "x_m>=",
                                  "price=nan",
                                  "price!=inf",
                                  "y_m<1e999",
                                  "level=1 ",
                                  "misplaced=yes",
                                  "misplaced<1",
                                  "sku=can-cola,price>cheap"}) {
    const auto found = scene::query_scene(scene, "products", where);
    ASSERT_FALSE(found.ok()) << where;
    EXPECT_EQ(found.error().code, "usage.bad_flag") << where;
    EXPECT_NE(found.error().message.find(" holds "), std::string::npos) << found.error().message;
  }
  const auto found = scene::query_scene(scene, "products", "sku=can-cola,price>cheap");
  EXPECT_EQ(found.error().where, "--where price>cheap");
  EXPECT_EQ(found.error().message,
            "\"cheap\" stands at character 7, but column \"price\" holds numbers");
  EXPECT_EQ(rows_where("price~9"), 8U);  // what it contains is asked of the text
  EXPECT_EQ(rows_where("sku<c"), 3U);    // and texts have an order of their own
}

TEST(Query, MistakesNameTheNearest) {
  const scene::Scene scene = query_sample();
  const auto error_of = [&](std::string_view table, std::string_view where) {
    const auto found = scene::query_scene(scene, table, where);
    return found.ok() ? std::string("ok") : found.error().code + " " + found.error().message;
  };
  EXPECT_EQ(error_of("product", ""),
            "usage.bad_flag there is no table \"product\"; did you mean \"products\"?");
  EXPECT_NE(error_of("products", "levle=1").find("usage.bad_flag there is no column \"levle\""),
            std::string::npos);
  EXPECT_NE(error_of("products", "levle=1").find("did you mean \"level\"?"), std::string::npos);
  EXPECT_NE(error_of("products", "level").find("usage.bad_flag expected column=value"),
            std::string::npos);
  EXPECT_NE(error_of("products", "level=1,").find("usage.bad_flag"), std::string::npos);
  EXPECT_NE(error_of("products", "=1").find("usage.bad_flag there is no column \"\""),
            std::string::npos);
}

// A reader of RFC 4180, independent of the writer.
std::vector<std::vector<std::string>> parse_csv(const std::string& text) {
  std::vector<std::vector<std::string>> rows(1, std::vector<std::string>(1));
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    std::string& cell = rows.back().back();
    if (quoted) {
      if (text[i] != '"')
        cell += text[i];
      else if (i + 1 < text.size() && text[i + 1] == '"')
        cell += text[++i];
      else
        quoted = false;
    } else if (text[i] == '"') {
      quoted = true;
    } else if (text[i] == ',') {
      rows.back().emplace_back();
    } else if (text.compare(i, 2, "\r\n") == 0) {
      ++i;
      rows.emplace_back(1);
    } else {
      cell += text[i];
    }
  }
  rows.pop_back();  // after the last line break
  return rows;
}

TEST(Query, CsvReadsBackByRfc4180) {
  const scene::Table table = table_of("products");
  const auto rows = parse_csv(scene::to_csv(table));
  ASSERT_EQ(rows.size(), table.rows.size() + 1);
  EXPECT_EQ(rows[0], table.columns);
  for (std::size_t i = 0; i < table.rows.size(); ++i)
    EXPECT_EQ(rows[i + 1], table.rows[i]);
  EXPECT_NE(scene::to_csv(table).find("\"Fonda Cereal, \"\"crunchy\"\"\nwith nuts\""),
            std::string::npos);
}

// A word of a closed list is a text like any other; a list is JSON, quoted once.
TEST(Query, EnumerationsAndListsAreQuotedOnce) {
  scene::Scene scene = query_sample();
  catalog::MaterialRow tiles;
  tiles.id = "tile-test";
  tiles.pattern = catalog::MaterialPattern::tiles;
  tiles.uses = {"floor", "wall"};
  scene.materials.push_back(tiles);
  const auto table = scene::query_scene(scene, "materials", "pattern=tiles,uses~wall");
  ASSERT_TRUE(table.ok()) << to_string(table.error());
  ASSERT_EQ(table->rows.size(), 1U);
  const auto rows = parse_csv(scene::to_csv(*table));
  const auto json = nlohmann::json::parse(scene::to_json(*table));
  const auto column = [&](std::string_view name) {
    return static_cast<std::size_t>(std::ranges::find(rows[0], name) - rows[0].begin());
  };
  EXPECT_EQ(rows[1][column("pattern")], "tiles");
  EXPECT_EQ(rows[1][column("uses")], R"(["floor", "wall"])");
  EXPECT_EQ(json[0]["pattern"], "tiles");
  EXPECT_EQ(json[0]["uses"], (nlohmann::json{"floor", "wall"}));
  EXPECT_NE(scene::to_csv(*table).find(R"(,tiles,)"), std::string::npos) << scene::to_csv(*table);
  EXPECT_FALSE(scene::query_scene(scene, "materials", "uses<wall").ok());
}

// A product of somebody's catalogue runs nothing in a spreadsheet and clears no terminal; numbers
// are numbers, also negative ones.
TEST(Query, CsvIsSafeToOpen) {
  const scene::Table table{{"name", "x_m"},
                           {{"=HYPERLINK(\"http://x\")", "-1.5"},
                            {"@SUM(A1)", "+2"},
                            {"-1+2", "3"},
                            {"+1", "4"},
                            {"1 = 1", "5"},
                            {"\x1b[2Ja\nb", "6"}},
                           {scene::ColumnKind::text, scene::ColumnKind::number}};
  EXPECT_EQ(scene::to_csv(table),
            "name,x_m\r\n\"'=HYPERLINK(\"\"http://x\"\")\",-1.5\r\n'@SUM(A1),+2\r\n'-1+2,3\r\n"
            "'+1,4\r\n1 = 1,5\r\n\"\\x1b[2Ja\nb\",6\r\n");
}

TEST(Query, JsonReadsBack) {
  const scene::Table table = table_of("products");
  const auto json = nlohmann::json::parse(scene::to_json(table));
  ASSERT_EQ(json.size(), 8U);
  EXPECT_EQ(json[5]["name"], "Fonda Cereal, \"crunchy\"\nwith nuts");
  EXPECT_EQ(json[0]["level"], 0);
  EXPECT_EQ(json[0]["misplaced"], false);
  EXPECT_EQ(json[0]["ean"], "2000000000015");  // a text: leading zeros matter
  EXPECT_DOUBLE_EQ(json[0]["x_m"], 2.6);
  EXPECT_EQ(nlohmann::json::parse(scene::to_json(table_of("products", "level=9"))),
            nlohmann::json::array());
}

}  // namespace
}  // namespace marketgen
