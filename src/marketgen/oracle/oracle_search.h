// How far an oracle looks, and whether it rehearses: the same hand and eyes, other decisions.
#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

namespace marketgen::oracle {

struct OracleSearch {
  bool rehearses = true;
  // It begins with what the others take last: the farthest goal, the item whose grasp is worth
  // least.
  bool other_order = false;
  // At the counter: of an item, those of which postures are sought, ways planned, places looked
  // for; rehearsals of a decision.
  std::size_t max_grasps = 24, max_plans = 6, max_place_searches = 12;
  int max_rehearsals = 8, max_rehearsals_of_item = 3;
  // In the aisles: tries of an item of a SKU, times that it comes to one in vain, times that a way
  // to one is sought in vain, each from other random postures, grasps rehearsed from where the base
  // stands, items of a SKU looked at.
  int max_item_tries = 3, max_unreached = 3, max_unplanned = 3, max_rehearsals_here = 3;
  std::size_t max_items_looked_at = 4;
};

// Of a policy's name. "oracle"; "oracle-plain", which does what it has begun without rehearsing it;
// "oracle-thorough", which begins elsewhere and looks two to four times as far. Empty for others.
std::optional<OracleSearch> oracle_search(std::string_view policy);

}  // namespace marketgen::oracle
