// Whoever plans what to buy, behind one interface: offline, or a language model.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "base/fields.h"
#include "base/result.h"
#include "llm/language_model.h"
#include "shopping/shopping_plan.h"

namespace marketgen::shopping {

class ShoppingPlanner {
 public:
  virtual ~ShoppingPlanner() = default;
  // A plan that check_shopping() finds no fault with. Errors: those of plan_shopping().
  virtual Result<ShoppingPlan> plan(const ShoppingRequest& request,
                                    const Assortment& assortment) const = 0;
};

// plan_shopping(). `knowledge` must outlive it.
class OfflineShoppingPlanner : public ShoppingPlanner {
 public:
  explicit OfflineShoppingPlanner(const ShoppingKnowledge& knowledge) : knowledge_(knowledge) {}
  Result<ShoppingPlan> plan(const ShoppingRequest& request,
                            const Assortment& assortment) const override;

 private:
  const ShoppingKnowledge& knowledge_;
};

// A model chooses menus and products from a short list of the store's for every part; counts, sums,
// reasons for what is missing and substitutes are ours. Its answer is judged by check_shopping(),
// goes back once with what is wrong, and is taken when it leaves no more unmet than the offline
// plan. Whatever else comes of it (no server, a refusal, an answer too late or twice wrong), the
// offline plan stands, and plan.shopper says so. `knowledge` must outlive it.
class ModelShoppingPlanner : public ShoppingPlanner {
 public:
  ModelShoppingPlanner(const ShoppingKnowledge& knowledge, llm::LanguageModel model)
      : knowledge_(knowledge), model_(std::move(model)) {}
  Result<ShoppingPlan> plan(const ShoppingRequest& request,
                            const Assortment& assortment) const override;

 private:
  const ShoppingKnowledge& knowledge_;
  llm::LanguageModel model_;
};

// What the model answers.
struct ShoppingAnswer {
  struct Line {
    std::string part, sku;
    int count = 1;
    std::string why;

    static constexpr auto fields =
        field_list(field("part", &Line::part, "name of the part, as listed", required()),
                   field("sku", &Line::sku, "one of those listed for the part", required()),
                   field("count", &Line::count, "packs", range(1, 100'000), required()),
                   field("why", &Line::why, "one sentence", required(), at_most_bytes(400)));
  };

  std::vector<std::string> menus;
  std::vector<Line> lines;

  static constexpr auto fields = field_list(
      field("menus", &ShoppingAnswer::menus, "of each meal one, as listed", required()),
      field("lines", &ShoppingAnswer::lines, "what to buy", required(), at_most_items(300)));
};

}  // namespace marketgen::shopping
