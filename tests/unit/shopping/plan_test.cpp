// What is bought for a request.
#include <random>

#include "io/json.h"
#include "shopping_case.h"

namespace marketgen {
namespace {

using shopping::UnmetKind;

TEST(ShoppingPlans, ABreakfastWithinItsBudget) {
  const auto request = read("breakfast for two under 10 €");
  const auto assortment = every_row();
  const auto plan = planned(request, assortment);
  EXPECT_EQ(fault(plan, request, assortment), "");
  EXPECT_TRUE(plan.unmet.empty());
  EXPECT_LE(plan.total, 10);
  EXPECT_EQ(plan.menus.at(0), "breakfast for 2: rolls with butter and spread");
  ASSERT_NE(line_for(plan, "breakfast: bread or rolls"), nullptr);
  EXPECT_EQ(line_for(plan, "breakfast: bread or rolls")->count, 4);  // two rolls a person
}

TEST(ShoppingPlans, SayWhatTheBudgetCannotBuyAndWhatWould) {
  const auto request = read("breakfast for two under 2 €");
  const auto assortment = every_row();
  const auto plan = planned(request, assortment);
  EXPECT_EQ(fault(plan, request, assortment), "");
  ASSERT_FALSE(plan.unmet.empty());
  EXPECT_EQ(plan.unmet.front().kind, UnmetKind::over_budget);
  ASSERT_TRUE(plan.least.has_value());
  // The sum it names is enough, and a cent less is not.
  auto enough = request;
  enough.budget->amount = *plan.least;
  EXPECT_TRUE(planned(enough, assortment).unmet.empty());
  enough.budget->amount = *plan.least - 0.01;
  EXPECT_FALSE(planned(enough, assortment).unmet.empty());
}

TEST(ShoppingPlans, CountsAmountsOfLists) {
  const auto request =
      read("two cartons of milk, 500 g of pasta, 12 eggs, 3 kg potatoes, six apples");
  const auto assortment = every_row();
  const auto plan = planned(request, assortment);
  EXPECT_EQ(fault(plan, request, assortment), "");
  EXPECT_EQ(line_for(plan, "two cartons of milk")->count, 2);
  EXPECT_EQ(line_for(plan, "500 g of pasta")->count, 1);
  const auto* eggs = line_for(plan, "12 eggs");
  EXPECT_GE(eggs->count * shopping::pieces_of_pack(*assortment.product(eggs->sku)), 12);
  EXPECT_LE(eggs->count, 2);
  const auto* potatoes = line_for(plan, "3 kg potatoes");
  EXPECT_GE(potatoes->count * shopping::content_of(*assortment.product(potatoes->sku)), 2999);
  EXPECT_EQ(line_for(plan, "six apples")->count, 6);
}

TEST(ShoppingPlans, BuyNothingThatIsAtHome) {
  const auto request = read("eggs, flour, sugar; I have flour");
  const auto assortment = every_row();
  const auto plan = planned(request, assortment);
  EXPECT_EQ(fault(plan, request, assortment), "");
  EXPECT_EQ(plan.lines.size(), 2U);
  EXPECT_EQ(line_for(plan, "flour"), nullptr);
  const auto cake = planned(read("bake a cake; I have butter and sugar"), assortment);
  EXPECT_EQ(line_for(cake, "cake-baking: butter or margarine"), nullptr);
  EXPECT_NE(line_for(cake, "cake-baking: flour"), nullptr);
}

TEST(ShoppingPlans, TakeTheNearestWhereSomethingIsSoldOutOrNotSold) {
  const auto request = read("cola zero sugar 330 ml");
  auto assortment = every_row();
  const auto usual = planned(request, assortment);
  const std::string sku = usual.lines.at(0).sku;
  assortment.sold_out = {sku};
  const auto instead = planned(request, assortment);
  EXPECT_EQ(fault(instead, request, assortment), "");
  EXPECT_NE(instead.lines.at(0).sku, sku);
  // The first of the usual plan's substitutes is of the same group.
  ASSERT_FALSE(usual.lines[0].substitutes.empty());
  const auto& first = *assortment.product(usual.lines[0].substitutes[0].sku);
  EXPECT_EQ(first.subcategory, "soft drinks");
  // A store that does not sell it at all.
  std::erase_if(assortment.products, [](const auto& product) { return product.name == "Cola"; });
  assortment.sold_out.clear();
  const auto other = planned(request, assortment);
  EXPECT_EQ(fault(other, request, assortment), "");
  EXPECT_NE(other.lines.at(0).why.find("the store has no Cola"), std::string::npos)
      << other.lines[0].why;
  // Nothing of its group.
  std::erase_if(assortment.products,
                [](const auto& product) { return product.subcategory == "soft drinks"; });
  const auto none = planned(request, assortment);
  EXPECT_TRUE(none.lines.empty());
  EXPECT_EQ(none.unmet.at(0).kind, UnmetKind::not_sold);
}

TEST(ShoppingPlans, KeepToDietsAndSayWhatRowsDoNotTell) {
  const auto assortment = every_row();
  for (const char* words : {"vegetarian dinner for two",
                            "vegan dinner for three",
                            "gluten free breakfast for two",
                            "barbecue for four, vegetarian",
                            "lactose free breakfast",
                            "dinner without meat, no potatoes"}) {
    const auto request = read(words);
    const auto plan = planned(request, assortment);
    EXPECT_EQ(fault(plan, request, assortment), "") << words;
    EXPECT_FALSE(plan.lines.empty()) << words;
    for (const auto& line : plan.lines) {
      const auto& row = *assortment.product(line.sku);
      EXPECT_NE(row.subcategory, "fresh meat") << words;
      EXPECT_NE(row.subcategory, "fish") << words;
    }
    EXPECT_TRUE(std::ranges::any_of(plan.unmet, [](const auto& part) {
      return part.kind == UnmetKind::not_told;
    })) << words;
  }
  const auto halal = planned(read("halal dinner for two"), assortment);
  ASSERT_NE(unmet_of(halal, "halal"), nullptr);
  EXPECT_EQ(unmet_of(halal, "halal")->kind, UnmetKind::not_told);
}

TEST(ShoppingPlans, AreInTheStoresMoney) {
  auto request = read("breakfast for two under $10");
  const auto wrong = shopping::plan_shopping(request, every_row(), knowledge());
  ASSERT_FALSE(wrong.ok());
  EXPECT_EQ(wrong.error().code, "shopping.other_money");
  EXPECT_NE(wrong.error().message.find("EUR"), std::string::npos);
  auto unknown = every_row();
  unknown.sold_out = {"dairy-fresh-milk"};
  const auto sold_out = shopping::plan_shopping(read("milk"), unknown, knowledge());
  ASSERT_FALSE(sold_out.ok());
  EXPECT_EQ(sold_out.error().code, "catalog.unknown_sku");
}

// ---- The checker finds each fault. ----

TEST(CheckShopping, FindsEveryFault) {
  const auto request = read("vegetarian breakfast for two under 40 €, 500 g of pasta");
  auto assortment = every_row();
  const auto good = planned(request, assortment);
  ASSERT_EQ(fault(good, request, assortment), "");
  const auto broken = [&](const auto& change) {
    auto plan = good;
    change(plan);
    return fault(plan, request, assortment);
  };
  const auto says = [](const std::string& fault, std::string_view words) {
    return fault.find(words) != std::string::npos;
  };
  using Plan = shopping::ShoppingPlan;
  EXPECT_TRUE(says(broken([](Plan& p) { p.lines[0].sku = "no-such"; }), "does not sell it"));
  EXPECT_TRUE(says(broken([](Plan& p) { p.lines[0].sku = "dairy-minced-beef-400g"; }), "beef"));
  EXPECT_TRUE(says(broken([](Plan& p) { p.lines[0].price += 0.1; }), "its price is"));
  EXPECT_TRUE(says(broken([](Plan& p) { p.total += 0.01; }), "the lines cost"));
  EXPECT_TRUE(says(broken([](Plan& p) { p.lines[0].answers.clear(); }), "nothing asks for it"));
  EXPECT_TRUE(says(broken([](Plan& p) { p.lines[0].answers = {"a yacht"}; }), "nobody asks for"));
  EXPECT_TRUE(
      says(broken([](Plan& p) { std::swap(p.lines[0].answers, p.lines[1].answers); }), "it is no"));
  EXPECT_TRUE(says(broken([](Plan& p) {
                     p.total += p.lines[0].price;
                     p.lines[0].count += 1;
                   }),
                   "are wanted"));
  EXPECT_TRUE(says(broken([](Plan& p) { p.lines.push_back(p.lines[0]); }), "two lines buy it"));
  EXPECT_TRUE(says(broken([](Plan& p) { p.menus = {"breakfast for 2: caviar"}; }), "no such menu"));
  EXPECT_TRUE(says(broken([](Plan& p) { p.lines[0].substitutes[0].sku = p.lines[0].sku; }),
                   "its own substitute"));
  const auto dropped = [](Plan& p) {
    p.total -= p.lines[0].count * p.lines[0].price;
    p.lines.erase(p.lines.begin());
  };
  const std::string part = good.lines[0].answers[0];
  EXPECT_TRUE(says(broken(dropped), "neither bought nor named as unmet"));
  EXPECT_TRUE(says(broken([&](Plan& p) {
                     dropped(p);
                     p.unmet.push_back({part, UnmetKind::not_sold, "lazy"});
                   }),
                   "has something for it"));
  EXPECT_TRUE(says(broken([&](Plan& p) {
                     dropped(p);
                     p.unmet.push_back({part, UnmetKind::over_budget, "lazy"});
                   }),
                   "money left"));
  auto cheap = request;
  cheap.budget->amount = 1;
  EXPECT_TRUE(says(fault(good, cheap, assortment), "above the budget"));
  assortment.sold_out = {good.lines[0].sku};
  EXPECT_TRUE(says(fault(good, request, assortment), "sold out"));
}

// ---- Properties. ----

// A request put together at random.
std::string random_words(std::mt19937& draw) {
  const auto any = [&](const std::vector<std::string>& list) { return list[draw() % list.size()]; };
  std::vector<std::string> meals, foods;
  for (const auto& meal : knowledge().table().meals)
    meals.push_back(meal.say.front());
  for (const auto& food : knowledge().table().foods)
    for (const auto& name : food.say)
      foods.push_back(name);
  std::string words;
  const auto add = [&](const std::string& more) { words += (words.empty() ? "" : ", ") + more; };
  if (draw() % 4 != 0) add(any(meals) + " for " + std::to_string(1 + draw() % 9));
  if (draw() % 4 == 0) add(any(meals));
  for (auto items = draw() % 4; items > 0 || words.empty(); items -= items > 0)
    add(any({"two packs of ", "500 g of ", "1 l of ", "", "six "}) + any(foods));
  if (draw() % 3 == 0) add(any({"vegetarian", "vegan", "gluten free", "no nuts", "no alcohol"}));
  if (draw() % 3 != 0) add("at most " + std::to_string(1 + draw() % 40) + " €");
  if (draw() % 3 == 0) words += "; I have " + any(foods);
  return words;
}

TEST(ShoppingProperty, EveryPlanPassesTheCheckerAndIsTheSameTwice) {
  std::mt19937 draw(7);
  int over_budget = 0, not_sold = 0;
  for (int i = 0; i < 60; ++i) {
    const auto request = read(random_words(draw));
    auto assortment = every_row(1 + draw() % 12, draw() % 3);
    for (auto k = draw() % 40; k > 0; --k)
      assortment.sold_out.push_back(assortment.products[draw() % assortment.products.size()].sku);
    std::ranges::sort(assortment.sold_out);
    const auto plan = planned(request, assortment);
    ASSERT_EQ(fault(plan, request, assortment), "") << request.words << io::write_json(plan);
    double total = 0;
    for (const auto& line : plan.lines)
      total += line.count * line.price;
    EXPECT_NEAR(plan.total, total, 1e-6);
    if (request.budget) {
      EXPECT_LE(plan.total, request.budget->amount + 1e-9);
    }
    if (i % 4 == 0) {
      EXPECT_EQ(io::write_json(planned(request, assortment)), io::write_json(plan));
    }
    for (const auto& part : plan.unmet) {
      over_budget += part.kind == UnmetKind::over_budget ? 1 : 0;
      not_sold += part.kind == UnmetKind::not_sold ? 1 : 0;
    }
  }
  EXPECT_GT(over_budget, 8);  // the draws reach both
  EXPECT_GT(not_sold, 8);
}

}  // namespace
}  // namespace marketgen
