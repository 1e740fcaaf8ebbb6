// A language model that sees pictures chooses among the places on a shelf that look like the
// product; how it stands there is fitted as ever. Where the model fails, the choice without one
// stands in.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "perception/mark_question.h"
#include "perception/model_targets.h"
#include "perception/shelf_choice.h"

namespace marketgen::perception {

class ModelShelfChoice : public ShelfChoice {
 public:
  ModelShelfChoice(std::shared_ptr<MarkQuestioner> questioner,
                   std::unique_ptr<ShelfChoice> offline,
                   ProductWords by_sku)
      : questioner_(std::move(questioner)),
        offline_(std::move(offline)),
        by_sku_(std::move(by_sku)) {}

  // One question, and one more for each further copy that is wanted.
  std::vector<FoundOnShelf> find(const WantedProduct& wanted,
                                 const std::vector<ViewCloud>& views,
                                 const std::vector<BoardAhead>& boards,
                                 const std::vector<ShelfSpot>& spots) const override;
  FittedPose again(const WantedProduct& wanted,
                   const std::vector<ViewCloud>& views,
                   const Pose& base_from_product) const override {
    return offline_->again(wanted, views, base_from_product);
  }

 private:
  // Nothing when the model failed before it had chosen any.
  std::optional<std::vector<FoundOnShelf>> chosen(const WantedProduct& wanted,
                                                  const std::vector<ViewCloud>& views,
                                                  const std::vector<BoardAhead>& boards,
                                                  const std::vector<ShelfSpot>& spots) const;
  // The product as it stands at a spot, whatever else looks like it.
  std::optional<FoundOnShelf> stood_at(const ShelfSpot& spot,
                                       const WantedProduct& wanted,
                                       const std::vector<ViewCloud>& views,
                                       const std::vector<BoardAhead>& boards,
                                       const std::vector<ShelfSpot>& spots) const;

  std::shared_ptr<MarkQuestioner> questioner_;
  std::unique_ptr<ShelfChoice> offline_;
  ProductWords by_sku_;
};

// What the pictures show of a product of this size on each of the spots: mask i of a view is that
// of spot i, empty in all views but the one that shows most of it.
std::vector<MaskedView> masks_of_spots(const std::vector<ViewCloud>& views,
                                       const std::vector<BoardAhead>& boards,
                                       const std::vector<ShelfSpot>& spots,
                                       Vec3f size);

}  // namespace marketgen::perception
