// A small grammar of counts and lists.
#include "language/chart.h"

#include <gtest/gtest.h>

#include <sstream>

namespace marketgen::language {
namespace {

constexpr char rules[] = R"(
# what is counted
length : number unit = mm: 1.value * 2.number        // 24 m
things : thing = members: 1                           // bread
things : things 'and' thing = members: 1.members + 3  // bread and milk
things : things ',' thing = members: 1.members + 3 !2 // bread, milk
wish   : number thing[kind=fixture] = kind: count, value: 1.value, what: 2.value
wish   : things 'near' things 'please'? = kind: near, a: 1.members,
         b: 3.members
)";

// Words by their spelling: numbers, units, fixtures and goods.
Input input_of(const std::string& text) {
  Input input;
  std::istringstream words(text);
  int at = 0;
  for (std::string word; words >> word; ++at) {
    const int begin = static_cast<int>(
        text.find(word, static_cast<std::size_t>(at == 0 ? 0 : input.tokens.back().span[1])));
    input.tokens.push_back({word, {begin, begin + static_cast<int>(word.size())}});
    if (word == "the") input.tokens.back().skip_cost = 0;
    LexicalEntry entry{at, at + 1, "thing", {}};
    entry.meaning.slots = {{"value", word},
                           {"kind", std::string(word == "table" ? "fixture" : "zone")}};
    if (word[0] >= '0' && word[0] <= '9') {
      entry.category = "number";
      entry.meaning.slots = {{"value", std::stod(word)}};
    } else if (word == "m") {
      entry.category = "unit";
      entry.meaning.slots = {{"number", 1000.0}};
    }
    input.entries.push_back(std::move(entry));
  }
  return input;
}

Grammar grammar() {
  auto parsed = Grammar::parse(rules, "test");
  EXPECT_TRUE(parsed.ok()) << to_string(parsed.error());
  return std::move(*parsed);
}

std::vector<ConstituentPtr> wishes(const Grammar& grammar, const Input& input) {
  return best_cover(Chart(grammar, input), *grammar.category("wish"), input);
}

TEST(Chart, MultipliesNumbers) {
  const Grammar g = grammar();
  const Input input = input_of("24 m");
  const auto lengths = Chart(g, input).of(*g.category("length"));
  ASSERT_EQ(lengths.size(), 1U);
  EXPECT_EQ(lengths[0]->meaning->number("mm"), 24000);
  EXPECT_EQ(lengths[0]->meaning->span, (IntRange{0, 4}));
}

TEST(Chart, ListsKeepTheirOrderAndPassOverFillers) {
  const Grammar g = grammar();
  const Input input = input_of("bread , milk and the eggs near the door please");
  const auto found = wishes(g, input);
  ASSERT_EQ(found.size(), 1U);
  const Parts& members = found[0]->meaning->parts("a");
  ASSERT_EQ(members.size(), 3U);
  EXPECT_EQ(members[0]->text("value"), "bread");
  EXPECT_EQ(members[2]->text("value"), "eggs");
  EXPECT_EQ(found[0]->meaning->words.size(), 8U);  // all but "the", twice
}

TEST(Chart, ConstraintsChooseAndWhatIsNotReadIsLeft) {
  const Grammar g = grammar();
  const Input input = input_of("3 table gloop 4 bread milk near eggs");
  const auto found = wishes(g, input);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0]->meaning->text("what"), "table");
  EXPECT_EQ(found[0]->meaning->number("value"), 3);
  EXPECT_EQ(found[1]->begin, 5);  // "4 bread" is no wish
}

TEST(Chart, ManyReadingsEndSoon) {
  const Grammar g = grammar();
  std::string text = "a0";
  for (int i = 1; i < 200; ++i)
    text += (i % 7 == 0 ? " near a" : " and a") + std::to_string(i);
  const Input input = input_of(text);
  const Chart chart(g, input);
  EXPECT_FALSE(best_cover(chart, *g.category("wish"), input).empty());
}

struct BadRule {
  const char* line;
  const char* says;
};
void PrintTo(const BadRule& bad, std::ostream* out) {
  *out << bad.line;
}
class BadRules : public testing::TestWithParam<BadRule> {};
TEST_P(BadRules, NameTheirLine) {
  const auto parsed =
      Grammar::parse("# first\n" + std::string(GetParam().line) + "\n", "a.grammar");
  ASSERT_FALSE(parsed.ok());
  EXPECT_EQ(parsed.error().code, "grammar.bad_rule");
  EXPECT_EQ(parsed.error().where, "a.grammar:2");
  EXPECT_NE(parsed.error().message.find(GetParam().says), std::string::npos)
      << parsed.error().message;
}
INSTANTIATE_TEST_SUITE_P(Table,
                         BadRules,
                         testing::Values(BadRule{"wish number", "':'"},
                                         BadRule{"wish :", "an item that must be there"},
                                         BadRule{"wish : 'near", "second '"},
                                         BadRule{"wish : thing[kind=", "what the slot says"},
                                         BadRule{"wish : thing[kind=a", "']'"},
                                         BadRule{"wish : thing = value", "':'"},
                                         BadRule{"wish : thing = @x", "number of an item"},
                                         BadRule{"wish : thing ) ", "missing"},
                                         BadRule{"wish : thing !", "a number"}));

}  // namespace
}  // namespace marketgen::language
