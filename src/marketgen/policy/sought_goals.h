// What `classical` is asked for at a counter, and how much of it a look shows: of the products that
// a goal's words may mean, the one that is found best is the one that is meant.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "perception/target_choice.h"
#include "policy/checkout_sight.h"
#include "policy/goal_skus.h"

namespace marketgen::policy {

constexpr std::size_t max_readings = 4;          // of a goal, that are looked for
constexpr std::size_t sight_patch_points = 160;  // of a mask

class SoughtGoals {
 public:
  using Catalogue = std::vector<const perception::ProductLook*>;

  // `catalogue`: looks of all that the agent knows, which must outlive this. What the reader cannot
  // read stays without readings. Errors: catalog.unknown_sku; others of goal_skus.
  Result<void> learn(const std::vector<agent::TaskGoal>& told,
                     const perception::GoalReader* reader,
                     const Catalogue& catalogue);

  // Readings of all goals, to be looked for. Empty until narrow(), when a goal has too many.
  const std::vector<perception::WantedProduct>& wanted() const { return wanted_; }
  // Of a goal that may mean many products, those that something in sight looks most like.
  void narrow(const Sight& sight, const Catalogue& catalogue);

  std::size_t size() const { return goals_.size(); }
  int count(std::size_t goal) const { return goals_[goal].count; }
  int tries(std::size_t goal) const { return goals_[goal].tries; }
  bool is_read(std::size_t goal) const { return !goals_[goal].readings.empty(); }
  std::vector<std::string> skus_of(std::size_t goal) const;  // that it may mean
  const perception::ProductLook& look_of(const perception::FoundProduct& found) const {
    return *wanted_[found.look].look;
  }
  // Of one product: that which was taken before, or else the goal's reading that was found best.
  // Once one was put down, what is much less like it is left out.
  std::vector<const perception::FoundProduct*> found_of(const Sight& sight, std::size_t goal) const;
  bool is_unloaded(const perception::FoundProduct& found, const agent::WorkArea& unloading) const;
  // How many are there. What was put down counts until as many are seen elsewhere.
  int there_of(const Sight& sight, std::size_t goal, const agent::WorkArea& unloading) const;
  bool is_there(const Sight& sight, std::size_t goal, const agent::WorkArea& unloading) const {
    return there_of(sight, goal, unloading) >= count(goal);
  }
  // Something is missing of which it is known what it is.
  bool may_find_more(const Sight& sight, const agent::WorkArea& unloading) const;

  // `likeness`: of the find that it was taken as.
  void note_taken(std::size_t goal, const perception::ProductLook& look, double likeness);
  void note_put_down(std::size_t goal);

 private:
  struct Goal {
    Catalogue readings;  // the likeliest first
    std::string words;   // that it was told in
    int count = 1, put_down = 0, tries = 0;
    const perception::ProductLook* taken_as = nullptr;
    double taken_likeness = 0, sure_likeness = 0;  // of the last taken; of the best put down
  };
  Result<Goal> read(const agent::TaskGoal& told,
                    const perception::GoalReader* reader,
                    const Catalogue& catalogue) const;
  void want_readings(const Catalogue& catalogue);

  std::vector<Goal> goals_;
  std::vector<perception::WantedProduct> wanted_;
  std::vector<std::size_t> of_goal_;  // of those wanted
};

}  // namespace marketgen::policy
