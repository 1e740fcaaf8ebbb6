// What of a prompt contradicts itself, and what only looks like it.
#include "intake/conflicts.h"

#include "intake/understanding.h"
#include "intake_fixture.h"

namespace marketgen {
namespace {

intake::Understanding understanding_of(std::string_view prompt) {
  return intake::understand(prompt, shipped_language(), committed_catalog());
}

std::string list_of_conflicts(const std::vector<intake::Conflict>& conflicts) {
  std::string text;
  for (const intake::Conflict& conflict : conflicts)
    text += conflict.what + ": " + conflict.why + "\n";
  return text;
}

struct Contradiction {
  const char* prompt;
  const char* kept;     // stands in the clause that holds
  const char* dropped;  // stands in the other one
};

void PrintTo(const Contradiction& row, std::ostream* out) {
  *out << row.prompt;
}

// One family a pair of rows, English and Chinese.
const std::vector<Contradiction> contradictions = {
    {"A shop 18 m x 12 m with dairy. The shop is 24 m x 9 m.", "24 m x 9 m", "18 m x 12 m"},
    {"24米乘15米的超市。卖场30米乘10米。", "30米乘10米", "24米乘15米"},
    {"A supermarket of 500 m2. Wine. The sales floor has 900 m2.", "900 m2", "500 m2"},
    {"一家300平米的超市，总面积500平米。", "500平米", "300平米"},
    {"A shop of 150 m2. A bakery of 200 m2 in it.", "200 m2", "150 m2"},
    {"A supermarket. The bakery has 40 m2. The bakery has no more than 25 m2.", "25 m2", "40 m2"},
    {"烘焙区40平米。烘焙区不超过25平米。", "25平米", "40平米"},
    {"Five checkouts. Bread and milk. No tills.", "No tills", "Five checkouts"},
    {"收银台四台。卖水果。不设收银台。", "不设收银台", "收银台四台"},
    {"No pallets. Six pallets of water.", "Six pallets", "No pallets"},
    {"不要托盘。卖水果。托盘六个。", "托盘六个", "不要托盘"},
    {"No freezers. Three chest freezers.", "Three chest freezers", "No freezers"},
    {"一台冷柜都不要。卧式冰柜三台。", "卧式冰柜三台", "冷柜都不要"},
    {"Six aisles. No more than four aisles.", "four aisles", "Six aisles"},
    {"六条通道。通道不超过四条。", "不超过四条", "六条通道"},
    {"All aisles under 1.2 m. All aisles over 2 m.", "over 2 m", "under 1.2 m"},
    {"通道至少2米宽。通道不超过1.6米宽。", "1.6米", "2米宽"},
    {"Shelves with 5 levels. Shelves with 3 levels.", "3 levels", "5 levels"},
    {"货架五层。货架三层。", "三层", "五层"},
    {"Shelves at most 4 levels. Six levels in snacks.", "Six levels", "at most 4"},
    {"Shelf pitch 300 mm. Shelf pitch 45 cm.", "45 cm", "300 mm"},
    {"层距30厘米。层距45厘米。", "45厘米", "30厘米"},
    {"No shelving over 1.4 m. Gondolas 1.8 m high.", "1.8 m", "1.4 m"},
    {"No shelves taller than 1.4 m. Wine racks 2 m high.", "2 m high", "1.4 m"},
    {"货架不超过1.4米。货架高1.8米。", "1.8米", "1.4米"},
    {"The ceiling is at 2.5 m. Shelves 2.8 m high.", "2.8 m", "2.5 m"},
    {"Dairy along the north wall. Dairy at the south wall.", "south wall", "north wall"},
    {"乳品沿北墙。乳品沿南墙。", "南墙", "北墙"},
    {"Fruit next to the entrance. Fruit along the back wall.", "back wall", "entrance"},
    {"水果放门口。水果沿后墙。", "后墙", "门口"},
    {"Bread next to the meat. The bakery far from the meat.", "far from", "next to"},
    {"面包挨着肉。面包远离肉。", "远离肉", "挨着肉"},
    {"Dairy left of the bakery. Dairy right of the bakery.", "right of", "left of"},
    {"乳品在面包的左边。乳品在面包的右边。", "右边", "左边"},
    {"The entrance in the south wall. The entrance in the west wall.", "west wall", "south wall"},
    {"入口在南墙。入口在西墙。", "西墙", "南墙"},
    {"Only one entrance. An entrance in the north wall and another entrance in the east wall.",
     "east wall",
     "Only one entrance"},
    {"No windows. Three windows in the north wall.", "Three windows", "No windows"},
    {"No dairy. Dairy has 20 m2.", "20 m2", "No dairy"},
    {"不设乳品区。乳品区20平米。", "20平米", "不设乳品区"},
    {"No alcohol. Beer by the till.", "Beer", "No alcohol"},
    {"不要酒。啤酒放门口。", "啤酒", "不要酒"},
    {"No cola. Milk. With cola.", "With cola", "No cola"},
    {"不要可乐。牛奶。一定要有可乐。", "一定要有可乐", "不要可乐"},
    {"Only fruit and vegetables. A meat counter.", "meat counter", "Only fruit"},
    {"只卖水果和蔬菜。生鲜肉柜一个，还有肉。", "肉", "只卖水果"},
    {"Carpet on the floor. The floor is oak.", "oak", "Carpet"},
    {"地面铺地毯。地面是橡木。", "橡木", "地毯"},
    {"Red shelves. Blue shelves.", "Blue", "Red"},
    {"货架红色。货架蓝色。", "蓝色", "红色"},
    {"Brutalist. Farmhouse style.", "Farmhouse", "Brutalist"},
    {"工业风。日式风格。", "日式", "工业风"},
    {"2700 K. Bread. 6500 K.", "6500 K", "2700 K"},
    {"暖光。面包。6500K。", "6500K", "暖光"},
    {"A tidy store. A messy store.", "messy", "tidy"},
    {"货架整齐。货架凌乱。", "凌乱", "整齐"},
    {"The shelves are full. The shelves are nearly empty.", "nearly empty", "full"},
    {"货架摆满。货架几乎是空的。", "空的", "摆满"},
    {"The shop is called Sunny Corner. The name of the shop is Green Basket.",
     "Green Basket",
     "Sunny Corner"},
    {"店名叫“春来”。店名叫“万家”。", "万家", "春来"},
    {"A discounter. Milk. An organic market.", "organic", "discounter"},
    {"硬折扣店。卖牛奶。有机超市。", "有机超市", "硬折扣店"},
    {"A tiny shop with bread. A huge shop.", "huge", "tiny"},
    {"Lots of wine. Hardly any wine.", "Hardly any", "Lots of"},
    {"Two rows of frozen food. Four rows of frozen food.", "Four rows", "Two rows"},
    {"Endcaps on every run. No endcaps.", "No endcaps", "Endcaps on"},
    {"要端架。卖粮油。端架不要。", "端架不要", "要端架"},
    {"A shop on Saturday evening. Bread. It is Monday at 8 am.", "Monday", "Saturday"},
    {"周六傍晚的超市。卖水果。星期一早上八点。", "星期一", "周六"},
};

class Contradictions : public testing::TestWithParam<Contradiction> {};

TEST_P(Contradictions, AreReportedWithBothClauses) {
  const std::string_view prompt = GetParam().prompt;
  const intake::Understanding found = understanding_of(prompt);
  const bool reported = std::ranges::any_of(found.conflicts, [&](const intake::Conflict& conflict) {
    if (!intake::is_contradiction(conflict) || conflict.where.size() != 2) return false;
    const auto clause = [&](std::size_t i) {
      const auto [begin, end] = conflict.where[i];
      return prompt.substr(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin));
    };
    return clause(0).find(GetParam().kept) != std::string_view::npos &&
           clause(1).find(GetParam().dropped) != std::string_view::npos;
  });
  EXPECT_TRUE(reported) << list_of_conflicts(found.conflicts);
}

INSTANTIATE_TEST_SUITE_P(Families, Contradictions, testing::ValuesIn(contradictions));

class NoContradictions : public testing::TestWithParam<const char*> {};

TEST_P(NoContradictions, AreReported) {
  const intake::Understanding found = understanding_of(GetParam());
  EXPECT_TRUE(found.conflicts.empty()) << list_of_conflicts(found.conflicts);
  EXPECT_FALSE(found.requirements.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Families,
    NoContradictions,
    testing::Values(
        // Corrections.
        "Dairy along the north wall. Meat. Sorry, I got that wrong. Dairy along the south wall.",
        "Six tills. Actually, we want eight tills.",
        "The old plan had ten aisles. Eight aisles.",
        "Self-checkouts instead of tills.",
        "六台收银台。说错了，八台收银台。",
        "原来是十条通道。八条通道。",
        "乳品沿北墙。后来改成乳品沿南墙。",
        // Both can hold.
        "Two bakeries: one bakery by the entrance, one bakery along the back wall.",
        "At least three tills. At most five tills.",
        "Dairy along the north wall and the west wall.",
        "An entrance in the south wall. Another entrance in the east wall.",
        "Windows in the north wall. Windows in the south wall.",
        "Cheese near the entrance, milk far from the entrance.",
        "Shelves 1.6 m high, only the household shelves are 2 m high.",
        "Shelves with five levels. Snacks with four levels.",
        "The ceiling is 4 m high. Shelves 1.6 m high.",
        "Warm light, 2700 K.",
        "A supermarket with milk. It is a discounter.",
        "No fish. A meat counter.",
        "Everything is full. Only the snacks half empty.",
        "Dry goods, milk. Dry goods only 40 %.",
        "Chest freezers only ever caused trouble, so no chest freezers.",
        "A café named Rosa in a shop called Green Basket.",
        "Ideally a marble floor, otherwise a floor of grey tile.",
        "收银台最少三台，最多五台。",
        "南墙开一个入口，东墙再开一个入口。",
        "货架高1.6米，只有日用品的货架高2米。",
        "暖光，色温2700K。",
        // Exceptions.
        "No alcohol except wine.",
        "No pallets except among the offers.",
        "不卖酒，葡萄酒除外。",
        "除了冰淇淋，不卖冷冻食品。"));

TEST(Conflicts, WhatIsExceptedStaysAndTheRestOfTheZoneGoes) {
  const std::vector<std::string> wishes =
      sorted_lines(understanding_of("No alcohol except wine.").requirements);
  EXPECT_EQ(wishes,
            (std::vector<std::string>{
                "product_absent beer", "product_absent spirits", "product_present wine"}));
}

TEST(Conflicts, WhatMustBeWinsOverAPreferenceAndIsNoContradictionOfTheWriter) {
  const intake::Understanding found = understanding_of("Five aisles. Ideally eight aisles.");
  ASSERT_EQ(found.conflicts.size(), 1U);
  EXPECT_EQ(found.conflicts[0].kept, "Five aisles");
  EXPECT_FALSE(intake::is_contradiction(found.conflicts[0]));
}

TEST(Conflicts, AZoneThatGoesIsReportedOnceForItsClause) {  // checkouts, and where they stand
  EXPECT_EQ(understanding_of("Five checkouts by the exit. No tills.").conflicts.size(), 1U);
}

TEST(Conflicts, ANumberTakesThePlaceOfAVaguerWord) {
  EXPECT_EQ(sorted_lines(understanding_of("Warm light, 2700 K.").requirements),
            std::vector<std::string>{"light light_kelvin 2700"});
}

}  // namespace
}  // namespace marketgen
