// What a robot found on shelves so far and may still take. Store frame, metres.
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "policy/aisle_sight.h"
#include "policy/shelf_goals.h"

namespace marketgen::policy {

struct KnownFind {
  ShelfFind place;
  double worth = 0;  // score, less what it stands off its category's place
  int tries = 0;
  int moves = 0;  // to elsewhere, since it was out of reach from where it was looked at again
  // From where it is taken it is hidden, as goods on low boards are by the robot's own arms: it is
  // looked at again from farther off; once it was found there, it is taken without another look.
  bool is_hidden_there = false, is_found_again = false;
};

class ShelfFinds {
 public:
  // Its worth; nothing when it is one that was refused. Of the same place the better score is kept.
  std::optional<double> remember(const ShelfFind& find, Vec2 hint);
  // Of each goal that is due the finds worth so much that are about as good as its best; of these
  // the nearest.
  std::optional<std::size_t> next(const std::vector<ShelfGoal>& goals,
                                  const robots::BasePlace& from,
                                  double min_worth) const;
  // Taken, or not to be taken: it is not found again. Those after it move up.
  void refuse(std::size_t number);

  KnownFind& operator[](std::size_t number) { return finds_[number]; }

 private:
  std::vector<KnownFind> finds_;
  std::vector<ShelfFind> refused_;
};

}  // namespace marketgen::policy
