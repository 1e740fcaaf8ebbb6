// What the planner understands of Chinese: words, numbers, and prompts with every requirement and
// every unparsed stretch written by hand.
#include <random>

#include "intake/chinese_numbers.h"
#include "intake/chinese_words.h"
#include "intake/han.h"
#include "intake/lexical_input.h"
#include "intake/understanding.h"
#include "intake_fixture.h"

namespace marketgen {
namespace {

// ---- Characters and words ----

TEST(Han, ChineseCharactersAreToldFromOthers) {
  EXPECT_TRUE(intake::is_han(U'货'));
  EXPECT_TRUE(intake::is_han(U'〇'));
  EXPECT_FALSE(intake::is_han(U'a'));
  EXPECT_FALSE(intake::is_han(U'、'));
  EXPECT_FALSE(intake::is_han(U'の'));
}

TEST(Han, TraditionalCharactersAreFolded) {
  EXPECT_EQ(intake::simplified("貨"), "货");
  EXPECT_EQ(intake::simplified("櫃"), "柜");
  EXPECT_EQ(intake::simplified("著"), "着");
  EXPECT_EQ(intake::simplified("货"), "货");
  EXPECT_EQ(intake::simplified("中"), "中");
}

// The stretches of a sentence that are one word each, parted by spaces.
std::string words_in(std::string_view sentence) {
  const std::vector<intake::Token> tokens = intake::tokenize(sentence);
  std::string words;
  for (const intake::Segment& segment : intake::segments_of(tokens, shipped_lexicon())) {
    if (!words.empty()) words += ' ';
    for (std::size_t at = segment.first; at < segment.last; ++at)
      words += tokens[at].text;
  }
  return words;
}

TEST(ChineseWords, AreTheLongestThatTheLexiconHas) {
  EXPECT_EQ(words_in("自助收银三台"), "自助收银 三 台");
  EXPECT_EQ(words_in("乳品沿后墙"), "乳品 沿 后墙");
  EXPECT_EQ(words_in("双面gondola6排"), "双面gondola 6 排");
  EXPECT_EQ(words_in("貨架一米六高"), "貨架 一米六 高");
}

std::vector<std::string> zones_and_products_in(std::string_view sentence) {
  const std::vector<intake::Token> tokens = intake::tokenize(sentence);
  const auto segments = intake::segments_of(tokens, shipped_lexicon());
  std::vector<std::string> found;
  for (const auto& entry : intake::lexical_input(tokens, segments, shipped_lexicon()).entries)
    if (entry.category == "zone" || entry.category == "product")
      found.push_back(entry.meaning.text("value"));
  return found;
}

TEST(ChineseWords, ALongerWordHidesThoseWithinIt) {
  using Values = std::vector<std::string>;
  EXPECT_EQ(zones_and_products_in("茶叶蛋"), Values{"tea egg"});
  EXPECT_EQ(zones_and_products_in("清酒"), Values{"sake"});
  EXPECT_EQ(zones_and_products_in("酒"), Values{"alcohol"});
  EXPECT_EQ(zones_and_products_in("酒架"), Values{});  // fixtures
  EXPECT_EQ(zones_and_products_in("茶叶和蛋"), (Values{"tea", "eggs"}));
  EXPECT_EQ(zones_and_products_in("牛角"), Values{});  // ordinary words hide, too
}

TEST(ChineseWords, NothingIsHiddenWithoutChinese) {
  const auto tokens = intake::tokenize("a bakery section");
  const intake::ChineseWords words(tokens, shipped_lexicon());
  EXPECT_FALSE(words.hides(1, 2));
  EXPECT_TRUE(words.numbers().empty());
}

// ---- Numbers ----

struct NumberCase {
  const char* text;
  const char* category;
  double value;
};

TEST(ChineseNumbers, AreReadAsPeopleWriteThem) {
  const NumberCase cases[] = {
      {"五", "number", 5},
      {"十二", "number", 12},
      {"二十", "number", 20},
      {"三十六", "number", 36},
      {"一百五十", "number", 150},
      {"一百二", "number", 120},
      {"两百零五", "number", 205},
      {"三千五百", "number", 3500},
      {"六千", "number", 6000},
      {"一万二", "number", 12000},
      {"3千", "number", 3000},
      {"二〇", "number", 20},
      {"三点五", "number", 3.5},
      {"俩", "number", 2},
      {"仨", "number", 3},
      {"七成", "share", 0.7},
      {"八成五", "share", 0.85},
      {"三成半", "share", 0.35},
      {"三分之一", "share", 1.0 / 3},
      {"百分之八十", "share", 0.8},
      {"百分之5", "share", 0.05},
      {"一半", "share", 0.5},
      {"1米35", "length", 1350},
      {"1米5", "length", 1500},
      {"三米半", "length", 3500},
      {"一米六五", "length", 1650},
      {"两公尺四", "length", 2400},
  };
  for (const NumberCase& row : cases) {
    const auto tokens = intake::tokenize(row.text);
    const auto numbers = intake::chinese_numbers(tokens, std::vector<bool>(tokens.size(), false));
    ASSERT_EQ(numbers.size(), 1U) << row.text;
    EXPECT_EQ(numbers[0].category, row.category) << row.text;
    EXPECT_NEAR(numbers[0].value, row.value, 1e-9) << row.text;
    EXPECT_EQ(numbers[0].last, tokens.size()) << row.text;
  }
}

TEST(ChineseNumbers, TwoDigitsInARowAreARange) {
  const auto tokens = intake::tokenize("两三");
  const auto numbers = intake::chinese_numbers(tokens, {false, false});
  ASSERT_EQ(numbers.size(), 1U);
  EXPECT_EQ(numbers[0].value, 2);
  EXPECT_EQ(numbers[0].upper, 3);
}

TEST(ChineseNumbers, MetresEndWhereSomethingIsCounted) {
  const auto tokens = intake::tokenize("二米五层");  // two metres, five levels
  const auto numbers = intake::chinese_numbers(tokens, std::vector<bool>(4, false));
  ASSERT_EQ(numbers.size(), 2U);
  EXPECT_EQ(numbers[0].value, 2);
  EXPECT_EQ(numbers[1].value, 5);
}

// ---- Prompts ----

struct ChineseCase {
  const char* prompt;
  std::vector<std::string> wishes;    // any order
  std::vector<std::string> unparsed;  // in the prompt's order
};

void PrintTo(const ChineseCase& row, std::ostream* out) {
  *out << row.prompt;
}

const std::vector<ChineseCase> chinese_cases = {
    // ---- Sizes and areas ----
    {"24米乘15米的超市", {"size 24000x15000", "profile supermarket-eu"}, {}},
    {"24x15m的超市", {"size 24000x15000", "profile supermarket-eu"}, {}},
    {"面宽三十六米，进深28米", {"size 36000x28000"}, {}},
    {"宽18公尺、深12公尺", {"size 18000x12000"}, {}},
    {"天花板淨高3公尺20公分", {"height ceiling 3200"}, {}},
    {"200平米的店。饮料占60平", {"area 200", "area beverages 60", "zone_present beverages"}, {}},
    {"8条通道，每条净宽1.5米", {"aisle_count 8", "aisle_width 1500"}, {}},
    {"冷冻、熟食、酒分别在左墙、后墙、右墙",
     {"zone_present frozen",
      "zone_present deli",
      "zone_present alcohol",
      "relation along frozen west",
      "relation along deli north",
      "relation along alcohol east"},
     {}},
    {"禁止：酒", {"zone_absent alcohol"}, {}},
    {"唔賣酒", {"zone_absent alcohol"}, {}},
    {"自助收银换成三条人工", {"zone_absent self_checkout", "fixture_count checkout_lane 3"}, {}},
    {"窗在西墙。咖啡区沿同一面墙",
     {"opening window west", "zone_present cafe", "relation along cafe west"},
     {}},
    {"少量放错", {"stock misplaced >=0.018"}, {}},
    {"闊25呎、深32呎", {"size 7620x9753.6"}, {}},
    {"一百二十平米的便利店", {"area 120", "profile convenience-cn"}, {}},
    {"３００㎡的门店", {"area 300"}, {}},
    {"便利店不少于80平方米", {"area >=80", "profile convenience-cn"}, {}},
    {"200到300平米", {"area >=200", "area <=300"}, {}},
    {"20平米的面包区", {"zone_present bakery", "area bakery 20"}, {}},
    {"超市300平米，咖啡区20平米",
     {"profile supermarket-eu", "area 300", "zone_present cafe", "area cafe 20"},
     {}},
    // ---- Counts ----
    {"收银台三台", {"fixture_count checkout_lane 3"}, {}},
    {"三个收银台", {"fixture_count checkout_lane 3"}, {}},
    {"人工收银四到六条",
     {"fixture_count checkout_lane >=4", "fixture_count checkout_lane <=6"},
     {}},
    {"至少两台自助收银机", {"fixture_count self_checkout >=2"}, {}},
    {"自助收银不超过六台", {"fixture_count self_checkout <=6"}, {}},
    {"人工四条、自助六台", {"fixture_count checkout_lane 4", "fixture_count self_checkout 6"}, {}},
    {"果蔬台十八张", {"fixture_count produce_table 18"}, {}},
    {"六条通道", {"aisle_count 6"}, {}},
    {"通道不少于二十四条", {"aisle_count >=24"}, {}},
    {"两排卧式冰柜，每排六台",
     {"run_count chest_freezer frozen 2", "fixture_count chest_freezer 12"},
     {}},
    // ---- What is not wanted, and nothing else ----
    {"不卖酒", {"zone_absent alcohol"}, {}},
    {"酒不卖", {"zone_absent alcohol"}, {}},
    {"熟食和服务台都不要", {"zone_absent deli", "zone_absent customer_service"}, {}},
    {"不要自助收银", {"zone_absent self_checkout"}, {}},
    {"花车一概不要", {"fixture_count bin <=0"}, {}},
    {"不要端架", {"endcaps <=0"}, {}},
    {"香烟不卖", {"product_absent cigarettes"}, {}},
    {"冷冻区不要岛柜", {"zone_present frozen", "fixture_count island_freezer <=0"}, {}},
    {"酒不用货架", {"zone_present alcohol", "fixture_count gondola <=0"}, {}},
    {"没有窗户", {"opening window <=0"}, {}},
    // ---- What was named last ----
    {"冷藏柜沿着左侧墙，一共八台",
     {"fixture_count multideck >=1", "relation along dairy west", "fixture_count multideck 8"},
     {}},
    {"库房设在里墙，面积30平方米",
     {"zone_present backroom", "relation along backroom north", "area backroom 30"},
     {}},
    // ---- Places ----
    {"乳品沿北墙", {"zone_present dairy", "relation along dairy north"}, {}},
    {"乳製品沿著最後面那道牆", {"zone_present dairy", "relation along dairy north"}, {}},
    {"水果放门口", {"zone_present produce", "relation near produce entrance"}, {}},
    {"面包靠近入口", {"zone_present bakery", "relation near bakery entrance"}, {}},
    {"冷冻离入口越远越好", {"zone_present frozen", "relation far frozen entrance"}, {}},
    {"进门左手边蔬菜", {"zone_present produce", "relation left_of produce entrance"}, {}},
    {"服务台设在入口旁边",
     {"zone_present customer_service", "relation near customer_service entrance"},
     {}},
    {"酒在面包和收银台之间",
     {"zone_present alcohol",
      "zone_present bakery",
      "zone_present checkout",
      "relation between alcohol bakery checkout"},
     {}},
    {"咖啡在面包对面",
     {"zone_present cafe", "zone_present bakery", "relation facing cafe bakery"},
     {}},
    {"烘焙与咖啡相邻",
     {"zone_present bakery", "zone_present cafe", "relation near bakery cafe"},
     {}},
    {"罐头不要挨着烘焙", {"zone_present canned", "relation not_adjacent canned bakery"}, {}},
    {"酒和零食放一块儿，前者沿左墙，后者靠近出口",
     {"zone_present alcohol",
      "zone_present snacks",
      "relation near alcohol snacks",
      "relation along alcohol west",
      "relation near snacks exit"},
     {}},
    {"面包沿东墙，乳品放在它旁边",
     {"zone_present bakery",
      "relation along bakery east",
      "zone_present dairy",
      "relation near dairy bakery"},
     {}},
    // ---- Doors ----
    {"入口在西墙", {"opening entrance west"}, {}},
    {"入口设于南墙正中", {"opening entrance south center"}, {}},
    {"出口开在南墙的东端", {"opening exit south east"}, {}},
    {"窗：南墙4扇", {"opening window south 4"}, {}},
    {"紧急出口两个，北墙一个，东墙一个",
     {"opening emergency north 1", "opening emergency east 1"},
     {}},
    {"入口和出口同在南墙", {"opening entrance south", "opening exit south"}, {}},
    // ---- Shelves ----
    {"货架五层", {"levels 5"}, {}},
    {"粮油、罐头一律六层货架",
     {"zone_present dry_goods", "zone_present canned", "levels dry_goods 6", "levels canned 6"},
     {}},
    {"货架高1米8", {"height fixture 1800"}, {}},
    {"货架不超过1.5米", {"height fixture <=1500"}, {}},
    {"天花三米半高", {"height ceiling 3500"}, {}},
    {"通道净宽不小于1.5米", {"aisle_width >=1500"}, {}},
    {"走道至少一百二十公分", {"aisle_width >=1200"}, {}},
    {"酒用酒架八组", {"zone_present alcohol", "fixture_count wine_rack 8"}, {}},
    {"双面货架十排，其中六排粮油，四排零食",
     {"run_count gondola dry_goods 10",
      "run_count gondola dry_goods dry_goods 6",
      "run_count gondola snacks snacks 4",
      "zone_present dry_goods",
      "zone_present snacks"},
     {}},
    {"粮油、罐头各两排双面货架",
     {"run_count gondola dry_goods dry_goods 2",
      "run_count gondola canned canned 2",
      "zone_present dry_goods",
      "zone_present canned"},
     {}},
    {"卧式冰柜两排，一排五台",
     {"run_count chest_freezer frozen 2", "fixture_count chest_freezer 10"},
     {}},
    {"货架四层……还是五层吧", {"levels 5"}, {}},
    {"玻璃门冷藏柜八台改十台", {"fixture_count glass_door_cooler 10"}, {}},
    // ---- Floors by comparison ----
    {"烘焙25平米，乳品区是烘焙的两倍大",
     {"area bakery 25", "area dairy 50", "zone_present bakery", "zone_present dairy"},
     {}},
    {"零食区四十平米，饮料区比零食区大一半",
     {"area snacks 40", "area beverages 60", "zone_present snacks", "zone_present beverages"},
     {}},
    {"饮料区比零食区大一半",
     {"zone_present snacks", "zone_present beverages"},
     {"饮料区比零食区大一半"}},
    // ---- Look ----
    {"北欧风格", {"style scandinavian"}, {}},
    {"便利店，照美国那种来", {"profile convenience-us"}, {"照"}},
    {"地面水磨石", {"material floor terrazzo-white"}, {}},
    {"货架灰色，点缀色绿色", {"color fixture #8c8f92", "color accent #2e7d32"}, {}},
    {"灯光3000K", {"light light_kelvin 3000"}, {}},
    {"照度五百勒克斯", {"light light_lux 500"}, {}},
    {"暖光", {"light light_kelvin 3000"}, {}},
    // ---- Stock and products ----
    {"货架九成满", {"stock fill 0.9"}, {}},
    {"货填到八成五", {"stock fill 0.85"}, {}},
    {"价签缺失5%", {"stock tags_missing 0.05"}, {}},
    {"随机缺货5%", {"stock out_of_stock 0.05"}, {"随机"}},
    {"一定要有牛奶", {"product_present milk"}, {}},
    // ---- Strength, mixed, unknown ----
    {"最好有咖啡区", {"?zone_present cafe"}, {}},
    {"整体走industrial风", {"style industrial"}, {}},
    {"Checkout靠近exit", {"zone_present checkout", "relation near checkout exit"}, {}},
    {"面包区和滑梯", {"zone_present bakery"}, {"滑梯"}},
    {"超市。二楼做个游泳池", {"profile supermarket-eu"}, {"二楼", "游泳池"}},
};

class ChinesePrompts : public testing::TestWithParam<ChineseCase> {};

TEST_P(ChinesePrompts, AreUnderstood) {
  ChineseCase expected = GetParam();
  const intake::Understanding found =
      intake::understand(expected.prompt, shipped_language(), committed_catalog());
  std::ranges::sort(expected.wishes);
  EXPECT_EQ(sorted_lines(found.requirements), expected.wishes) << expected.prompt;
  std::vector<std::string> unparsed;
  for (const intake::UnparsedWord& word : found.unparsed)
    unparsed.push_back(word.text);
  EXPECT_EQ(unparsed, expected.unparsed) << expected.prompt;
}

INSTANTIATE_TEST_SUITE_P(Table, ChinesePrompts, testing::ValuesIn(chinese_cases));

TEST(ChinesePrompts, OnlyForbidsEveryOtherZoneButTheTills) {
  const auto found = intake::understand("只卖零食和饮料", shipped_language(), committed_catalog());
  std::vector<std::string> absent;
  for (const plan::Requirement& wish : found.requirements)
    if (wish.kind == plan::RequirementKind::zone_absent) absent.push_back(wish.subject);
  EXPECT_NE(found.find(plan::RequirementKind::zone_present, "snacks"), nullptr);
  EXPECT_TRUE(std::ranges::count(absent, "dairy") == 1 &&
              std::ranges::count(absent, "alcohol") == 1);
  for (const char* wanted : {"snacks", "beverages", "checkout"})
    EXPECT_EQ(std::ranges::count(absent, wanted), 0) << wanted;
}

TEST(ChinesePrompts, NamesStandInQuotationMarks) {
  for (const char* prompt : {"店名叫“春熙邻里”", "名字叫「春熙邻里」", "店招统一为《春熙邻里》"}) {
    const auto found = intake::understand(prompt, shipped_language(), committed_catalog());
    ASSERT_TRUE(found.name.has_value()) << prompt;
    EXPECT_EQ(found.name->text, "春熙邻里") << prompt;
  }
}

TEST(ChinesePrompts, TraditionalCharactersSayTheSame) {
  const auto lines = [](const char* prompt) {
    return sorted_lines(
        intake::understand(prompt, shipped_language(), committed_catalog()).requirements);
  };
  EXPECT_EQ(lines("麵包沿後牆，結帳櫃台兩座，貨架五層"),
            lines("面包沿后墙，结账柜台两座，货架五层"));
}

// Characters of prompts in any order: nothing crashes, and what is said lies within the prompt.
TEST(ChinesePrompts, AnyRowOfCharactersIsRead) {
  const std::vector<std::string> pieces = {
      "面包",   "乳品", "酒", "货架", "北墙", "入口",   "旁边",   "沿",     "在",   "和",
      "不要",   "只卖", "三", "一百", "成",   "米",     "半",     "平方米", "个",   "排",
      "层",     "每",   "，", "。",   "、",   "：",     "“",      "”",      "它们", "前者",
      "之间",   "另一", "24", "x",    "m",    "bakery", "茶叶蛋", "鑫",     "其余", "用",
      "风幕柜", "最好", "5%", "\n",   "分之", "通道",   "高",     "满"};
  std::mt19937 random(7);
  for (int round = 0; round < 300; ++round) {
    std::string prompt;
    const int length = 1 + static_cast<int>(random() % 40U);
    for (int i = 0; i < length; ++i)
      prompt += pieces[random() % pieces.size()];
    const auto found = intake::understand(prompt, shipped_language(), committed_catalog());
    const auto within = [&](IntRange span) {
      return 0 <= span[0] && span[0] < span[1] && span[1] <= static_cast<int>(prompt.size());
    };
    for (const plan::Requirement& wish : found.requirements)
      EXPECT_TRUE(within(wish.span)) << prompt << ": " << line_of(wish);
    for (const intake::UnparsedWord& word : found.unparsed)
      EXPECT_TRUE(within(word.span)) << prompt << ": " << word.text;
  }
}

}  // namespace
}  // namespace marketgen
