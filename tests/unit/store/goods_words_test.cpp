// Every word for goods that the planner knows finds goods: a prompt that names them gets them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "catalog/zone_goods.h"
#include "intake/lexicon.h"
#include "io/file.h"
#include "io/json.h"
#include "scene/assortment.h"
#include "support/committed_catalog.h"

namespace marketgen {
namespace {

// What prompts say they do not want, and no shop of ours sells.
constexpr std::array<std::string_view, 3> never_sold = {"cigarettes", "e-cigarette", "betel nut"};

intake::LexiconFile words_of(const std::string& name) {
  const std::string file = MARKETGEN_SOURCE_DIR "/data/lexicon/" + name;
  const auto text = io::read_file(file);
  if (!text.ok()) fatal(to_string(text.error()).c_str());
  auto read = io::read_json<intake::LexiconFile>(*text, file);
  if (!read.ok()) fatal(to_string(read.error()).c_str());
  return std::move(read).value();
}

// In the zone that the row names one of the goods that it names best is for its fixtures.
bool finds_goods(const intake::LexiconRow& row) {
  const catalog::Catalog& catalog = committed_catalog();
  plan::Zone zone;
  zone.type = row.zone;
  const catalog::ZoneTypeRow* type = catalog.zone_type(row.zone);
  return type != nullptr &&
         std::ranges::any_of(scene::best_named(zone, row.value, catalog), [&](std::uint32_t i) {
           return catalog::keeps(type->temperature, catalog.products[i].storage);
         });
}

TEST(GoodsWords, FindGoodsInTheirZone) {
  int looked_at = 0;
  for (const char* file : {"products.json", "chinese_products.json"}) {
    for (const intake::LexiconRow& row : words_of(file).rows) {
      if (std::ranges::find(never_sold, row.value) != never_sold.end()) continue;
      EXPECT_TRUE(finds_goods(row)) << file << ": " << row.words.front() << " is " << row.value
                                    << " of " << row.zone << ", which has none";
      ++looked_at;
    }
  }
  EXPECT_GT(looked_at, 500);
}

struct Named {
  std::string_view zone, word, name;
};

// The goods themselves, and nothing that is only made with them or beside them on the shelf.
TEST(GoodsWords, MeanTheGoodsThemselves) {
  constexpr std::array<Named, 9> cases = {{{"dry_goods", "Olive Oil", "Olive Oil"},
                                           {"dry_goods", "sugar", "Sugar"},
                                           {"dry_goods", "basmati rice", "Rice"},
                                           {"dairy", "whole milk", "Milk"},
                                           {"dairy", "salted butter", "Butter"},
                                           {"household", "Kitchen Roll", "Kitchen Roll"},
                                           {"alcohol", "vodka", "Vodka"},
                                           {"produce", "Tomato", "Tomato"},
                                           {"snacks", "salted peanuts", "Peanuts"}}};
  for (const Named& goods : cases) {
    plan::Zone zone;
    zone.type = goods.zone;
    const auto rows = scene::best_named(zone, std::string(goods.word), committed_catalog());
    EXPECT_FALSE(rows.empty()) << goods.word;
    for (const std::uint32_t row : rows) {
      const std::string& name = committed_catalog().products[row].name;
      EXPECT_TRUE(name.ends_with(goods.name)) << goods.word << " is " << name;
    }
  }
}

}  // namespace
}  // namespace marketgen
