// What requests say.
#include "shopping/request.h"

#include "io/json.h"
#include "shopping_case.h"

namespace marketgen {
namespace {

using Words = std::vector<std::string>;

TEST(Requests, SayMealsPersonsAndABudget) {
  const auto request = read("breakfast for two under 10 €");
  ASSERT_EQ(request.meals.size(), 1U);
  EXPECT_EQ(request.meals[0].meal, "breakfast");
  EXPECT_EQ(request.meals[0].persons, 2);
  ASSERT_TRUE(request.budget.has_value());
  EXPECT_EQ(request.budget->amount, 10);
  EXPECT_EQ(request.budget->money, "€");
  EXPECT_TRUE(request.items.empty());
}

TEST(Requests, SayPersonsInManyWays) {
  const std::vector<std::pair<std::string, int>> said{
      {"dinner for 4", 4},
      {"dinner for four people", 4},
      {"dinner for a family of five", 5},
      {"dinner for my family", 4},
      {"dinner for two adults and three kids", 5},
      {"dinner for me", 1},
      {"for six guests: dinner", 6},
      {"we are having a barbecue for 12 friends", 12},
      {"dinner", 1}};
  for (const auto& [words, persons] : said) {
    const auto request = read(words);
    ASSERT_EQ(request.meals.size(), 1U) << words;
    EXPECT_EQ(request.meals[0].persons, persons) << words;
  }
}

TEST(Requests, SaySumsInManyWays) {
  const std::vector<std::pair<std::string, double>> said{{"lunch under 10 €", 10},
                                                         {"lunch, at most 15 euros", 15},
                                                         {"lunch for €9.50", 9.5},
                                                         {"lunch for less than 7,50 euros", 7.5},
                                                         {"lunch up to $12", 12},
                                                         {"lunch with a budget of 20 €", 20},
                                                         {"lunch, my budget is 20", 20},
                                                         {"lunch below 8", 8},
                                                         {"lunch, no more than 30 EUR", 30}};
  for (const auto& [words, sum] : said) {
    const auto request = read(words);
    ASSERT_TRUE(request.budget.has_value()) << words;
    EXPECT_EQ(request.budget->amount, sum) << words;
    EXPECT_EQ(request.meals.size(), 1U) << words;
    EXPECT_TRUE(request.items.empty()) << words << ": " << request.items.front();
  }
}

TEST(Requests, SayListsAndWhatIsAtHome) {
  const auto request = read("two cartons of milk, bread and 500 g of pasta");
  EXPECT_EQ(request.items, (Words{"two cartons of milk", "bread", "500 g of pasta"}));
  const auto missing = read("whatever is missing from this list: eggs, flour, sugar; I have flour");
  EXPECT_EQ(missing.items, (Words{"eggs", "flour", "sugar"}));
  EXPECT_EQ(missing.at_home, Words{"flour"});
  EXPECT_EQ(read("I have butter but need bread").at_home, Words{"butter"});
  EXPECT_EQ(read("I have butter but need bread").items, Words{"bread"});
}

TEST(Requests, SayDietsAndExclusions) {
  EXPECT_EQ(read("vegetarian dinner for two").diets, Words{"vegetarian"});
  EXPECT_EQ(read("dinner for two, gluten-free").diets, Words{"gluten free"});
  EXPECT_EQ(read("a snack, no nuts").diets, Words{"no nuts"});
  const auto both = read("dinner without mushrooms or olives, water");
  EXPECT_EQ(both.without, (Words{"mushroom", "olive"}));
  EXPECT_EQ(both.items, Words{"water"});
  // Of an item it is the item's own.
  EXPECT_EQ(read("gluten free bread").items, Words{"gluten free bread"});
  EXPECT_TRUE(read("gluten free bread").diets.empty());
}

TEST(Requests, AMealWithWhatGoesWithIt) {
  const auto request = read("breakfast with eggs and orange juice for two");
  ASSERT_EQ(request.meals.size(), 1U);
  EXPECT_EQ(request.items, (Words{"eggs", "orange juice"}));
  EXPECT_EQ(request.meals[0].persons, 2);
  // A meal's name in a product's is none.
  EXPECT_EQ(read("breakfast cereal").items, Words{"breakfast cereal"});
  EXPECT_EQ(read("tea, milk").items, (Words{"tea", "milk"}));
  EXPECT_EQ(read("tea for two").meals.at(0).meal, "tea-time");
}

TEST(Requests, ThatCannotBeReadNameThePlaceAndARemedy) {
  const auto error = [](const std::string& words) {
    const auto request = shopping::read_request(words, knowledge());
    return request.ok() ? Error{} : request.error();
  };
  const Error unknown = error("breakfast and a unicorn");
  EXPECT_EQ(unknown.code, "shopping.not_understood");
  EXPECT_EQ(unknown.where, "\"unicorn\" (bytes 16 to 23)");
  EXPECT_NE(unknown.message.find("meals: breakfast"), std::string::npos) << unknown.message;
  EXPECT_NE(error("brekfast").message.find("did you mean \"breakfast\"?"), std::string::npos);
  for (const char* words : {"", "please", "for two", "under 10 €", "I have milk"})
    EXPECT_EQ(error(words).code, "shopping.not_understood") << words;
  EXPECT_NE(error("lunch under 5 € or 10 €").message.find("second sum"), std::string::npos);
  EXPECT_NE(error("milk for two").message.find("persons belong to a meal"), std::string::npos);
  EXPECT_NE(error("dinner for 1.5 people").message.find("whole number"), std::string::npos);
  EXPECT_NE(error("dinner for 4000 people").message.find("up to 200"), std::string::npos);
  EXPECT_EQ(error(std::string(3000, 'a')).code, "shopping.not_understood");
  EXPECT_EQ(error("milk \xff").code, "input.not_utf8");
}

TEST(MealTable, EveryRowIsUsable) {
  const shopping::MealTable& table = knowledge().table();
  for (const shopping::Food& food : table.foods) {
    for (std::size_t i = 0; i < food.options.size(); ++i) {
      const bool any = std::ranges::any_of(committed_catalog().products, [&](const auto& product) {
        return shopping::option_of(food, product) == static_cast<int>(i);
      });
      EXPECT_TRUE(any) << food.id << ", option " << i << ": no row of the catalogue is of it";
    }
  }
  for (const shopping::Meal& meal : table.meals)
    for (const std::string& name : meal.say)
      EXPECT_EQ(read(name).meals.at(0).meal, meal.id) << name;
  for (const shopping::Diet& diet : table.diets)
    for (const std::string& name : diet.say)
      EXPECT_EQ(read("dinner, " + name).diets, Words{diet.id}) << name;
}

}  // namespace
}  // namespace marketgen
