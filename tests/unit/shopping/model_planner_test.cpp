// A language model as a planner, against a scripted server: what becomes of good answers, and of
// bad ones. What a scripted server says measures nothing about models.
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <functional>

#include "io/json.h"
#include "llm/language_model.h"
#include "shopping/shopping_parts.h"
#include "shopping_case.h"
#include "support/mock_server.h"

namespace marketgen {
namespace {

using nlohmann::json;

const std::string words = "breakfast for two under 14 €";

json answered(const std::string& text) {
  return {{"body",
           {{"choices", {{{"message", {{"content", text}}}, {"finish_reason", "stop"}}}},
            {"usage", {{"prompt_tokens", 700}, {"completion_tokens", 90}}}}}};
}

Result<llm::LanguageModel> model_at(const std::string& url) {
  llm::ModelChoice choice;
  choice.model = "openai:m";
  choice.url = url;
  return llm::open_language_model(choice);
}

// The offline plan as the model would say it.
json answer_of(const shopping::ShoppingPlan& plan) {
  json answer{{"menus", plan.menus}, {"lines", json::array()}};
  for (const auto& line : plan.lines)
    answer["lines"].push_back({{"part", line.answers.at(0)},
                               {"sku", line.sku},
                               {"count", line.count},
                               {"why", "it goes with the rest"}});
  return answer;
}

shopping::ShoppingPlan planned_by_model(const json& steps, int* asked = nullptr) {
  setenv("OPENAI_API_KEY", "test-key-123", 1);
  const MockServer server(steps);
  auto model = model_at(server.url("/v1"));
  EXPECT_TRUE(model.ok());
  const auto plan =
      shopping::ModelShoppingPlanner(knowledge(), *model).plan(read(words), every_row());
  EXPECT_TRUE(plan.ok());
  if (asked != nullptr) *asked = static_cast<int>(server.requests().size());
  EXPECT_EQ(fault(*plan, read(words), every_row()), "");
  return *plan;
}

// What is kept after an answer with that change, twice.
shopping::ShopperRecord kept_after(const std::function<void(json&)>& change) {
  const auto offline = planned(read(words), every_row());
  json answer = answer_of(offline);
  change(answer);
  int asked = 0;
  const auto plan =
      planned_by_model(json::array({answered(answer.dump()), answered(answer.dump())}), &asked);
  EXPECT_EQ(asked, 2);  // it had one chance to mend it
  EXPECT_EQ(io::write_json(plan.lines), io::write_json(offline.lines));
  return plan.shopper.value_or(shopping::ShopperRecord{});
}

TEST(ModelShoppingPlanner, ItsPlanIsTakenWhenItIsSound) {
  const auto offline = planned(read(words), every_row());
  json answer = answer_of(offline);
  // Without the last extra: another plan than the offline one.
  const std::string extra = answer["lines"].back()["part"];
  answer["lines"].erase(answer["lines"].size() - 1);
  const auto plan = planned_by_model(json::array({answered(answer.dump())}));
  ASSERT_TRUE(plan.shopper.has_value());
  EXPECT_EQ(plan.shopper->kept, "model") << plan.shopper->why;
  EXPECT_EQ(plan.shopper->model, "openai:m");
  EXPECT_EQ(plan.shopper->tokens_in, 700);
  EXPECT_EQ(plan.lines.size(), offline.lines.size() - 1);
  EXPECT_LT(plan.total, offline.total);
  EXPECT_NE(std::ranges::find(plan.left_out, extra), plan.left_out.end());
  EXPECT_EQ(plan.lines[0].why, "it goes with the rest");
  EXPECT_FALSE(plan.lines[0].substitutes.empty());
}

TEST(ModelShoppingPlanner, FallsBackFromAnswersThatAreWrong) {
  EXPECT_NE(kept_after([](json& a) {
              a["lines"][0]["sku"] = "dairy-unicorn-milk";
            }).why.find("not listed"),
            std::string::npos);
  EXPECT_NE(kept_after([](json& a) { a["lines"][0]["count"] = 500; }).why.find("buy "),
            std::string::npos);
  EXPECT_NE(kept_after([](json& a) { a["menus"][0] = "caviar"; }).why.find("no such menu"),
            std::string::npos);
  EXPECT_NE(kept_after([](json& a) { a["lines"] = json::array(); }).why.find("money left"),
            std::string::npos);
  EXPECT_EQ(kept_after([](json& a) { a["lines"].push_back(a["lines"][0]); }).kept, "offline");
}

TEST(ModelShoppingPlanner, FallsBackFromPlansAboveTheBudget) {
  const auto request = read(words);
  // Of each part the dearest that is listed.
  const auto assortment = every_row();
  const auto parts = shopping::parts_of(request, assortment, knowledge(), 4);
  ASSERT_TRUE(parts.ok());
  const auto& meal = parts->meals.at(0);
  json answer{{"menus", planned(request, assortment).menus}, {"lines", json::array()}};
  for (const auto& part : meal.menus[0].parts) {
    const auto dearest = std::ranges::max_element(part.answers, {}, &shopping::Answer::coins);
    answer["lines"].push_back({{"part", part.name},
                               {"sku", dearest->product->sku},
                               {"count", dearest->count()},
                               {"why", "the best"}});
  }
  const auto plan =
      planned_by_model(json::array({answered(answer.dump()), answered(answer.dump())}));
  EXPECT_EQ(plan.shopper->kept, "offline");
  EXPECT_NE(plan.shopper->why.find("above the budget"), std::string::npos) << plan.shopper->why;
  EXPECT_LE(plan.total, 14);
}

TEST(ModelShoppingPlanner, FallsBackFromServersThatDoNotAnswer) {
  for (const json& steps : {json::array({answered("I would rather not."), answered("No.")}),
                            json::array({{{"status", 400}, {"body", "broken"}}}),
                            json::array({{{"status", 401}, {"body", "who are you"}}})}) {
    const auto plan = planned_by_model(steps);
    ASSERT_TRUE(plan.shopper.has_value());
    EXPECT_EQ(plan.shopper->kept, "offline") << steps.dump();
    EXPECT_FALSE(plan.lines.empty());
  }
  // Nobody listens there.
  const auto model = model_at("http://127.0.0.1:9/v1");
  const auto plan =
      shopping::ModelShoppingPlanner(knowledge(), *model).plan(read(words), every_row());
  ASSERT_TRUE(plan.ok());
  EXPECT_EQ(plan->shopper->kept, "offline");
}

}  // namespace
}  // namespace marketgen
