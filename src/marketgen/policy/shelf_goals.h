// What `classical` is to fetch from shelves: the product that a goal's words mean most likely, what
// it looks like, and what may be taken for it.
#pragma once
#include <string>
#include <vector>

#include "agent/aisle_map.h"
#include "agent/known_products.h"
#include "agent/policy.h"
#include "perception/goal_reader.h"
#include "perception/look_library.h"
#include "perception/target_choice.h"

namespace marketgen::policy {

struct ShelfGoal {
  std::string sku, words;  // as it was told: by SKU, words are empty
  int wanted = 1, fetched = 0, tries = 0;
  const perception::ProductLook* look = nullptr;
  std::vector<const perception::ProductLook*> rivals, close_rivals;
  Vec2 hint;  // where its category stands
  std::string failure = "NotFound";

  bool is_due() const;
  // As it is looked for from where many shelves are seen.
  perception::WantedProduct wanted_afar() const;
  // From before its shelf, where prints are large enough to tell it from whatever else it may be.
  // What that looks like is learnt when it is asked for first. Errors: of KnownProducts::product
  // and LookLibrary::of.
  Result<perception::WantedProduct> wanted_close(agent::KnownProducts& products,
                                                 perception::LookLibrary& looks);
};

// What cannot be read is never due. Errors: episode.impossible where no hint says where a category
// stands; catalog.unknown_sku; others of goal_skus and LookLibrary::of.
Result<std::vector<ShelfGoal>> learn_shelf_goals(const std::vector<agent::TaskGoal>& told,
                                                 const perception::GoalReader* reader,
                                                 const std::vector<agent::CategoryHint>& hints,
                                                 agent::KnownProducts& products,
                                                 perception::LookLibrary& looks);

}  // namespace marketgen::policy
