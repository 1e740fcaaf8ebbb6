// A language model that sees pictures chooses the masks; how the product lies in one is fitted as
// ever. Where the model fails, the choice without one stands in.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "perception/mark_question.h"
#include "perception/target_choice.h"

namespace marketgen::perception {

// What the catalogue calls a product, by its SKU: for goals that were told by SKU, which says
// nothing to a model.
using ProductWords = std::function<std::string(const std::string& sku)>;
// How the task, or else the catalogue, calls what is wanted.
std::string words_of(const WantedProduct& wanted, const ProductWords& by_sku);

// One question a look for each goal, whatever its words may mean; one more for each further copy.
class ModelTargets : public TargetChoice {
 public:
  // `poses` must outlive it.
  ModelTargets(std::shared_ptr<MarkQuestioner> questioner,
               const PoseSource& poses,
               std::unique_ptr<TargetChoice> offline,
               ProductWords by_sku)
      : questioner_(std::move(questioner)),
        poses_(poses),
        offline_(std::move(offline)),
        by_sku_(std::move(by_sku)) {}

  std::vector<FoundProduct> find(const std::vector<WantedProduct>& wanted,
                                 const std::vector<ViewCloud>& views,
                                 const std::vector<MaskedView>& masked) const override;

 private:
  // Products that the same words may mean.
  struct Goal {
    std::string words;
    std::vector<std::size_t> readings;  // numbers of the wanted
  };
  std::vector<Goal> goals_of(const std::vector<WantedProduct>& wanted) const;
  // Nothing when the model failed before it had chosen any.
  std::optional<std::vector<FoundProduct>> chosen(const Goal& goal,
                                                  const std::vector<WantedProduct>& wanted,
                                                  const std::vector<ViewCloud>& views,
                                                  std::vector<MaskedView> masked) const;
  // Fitted from the chosen mask, and from those beside it and of the other views.
  std::optional<FoundProduct> best_reading(const Goal& goal,
                                           const std::vector<WantedProduct>& wanted,
                                           const std::vector<ViewCloud>& views,
                                           const std::vector<MaskedView>& masked,
                                           const Mark& mark) const;
  std::vector<FoundProduct> found_offline(const std::vector<std::size_t>& numbers,
                                          const std::vector<WantedProduct>& wanted,
                                          const std::vector<ViewCloud>& views,
                                          const std::vector<MaskedView>& masked) const;

  std::shared_ptr<MarkQuestioner> questioner_;
  const PoseSource& poses_;
  std::unique_ptr<TargetChoice> offline_;
  ProductWords by_sku_;
};

}  // namespace marketgen::perception
