// Whether a task of a track may ask for a product of a store.
#pragma once
#include <cstdint>
#include <optional>
#include <set>
#include <string>

namespace marketgen::episodes {

struct GoalChance {
  std::string why_not;  // a word; empty: it may
  // Rows in the scene's fixtures, off which it is taken then; none: off any that it stands on.
  std::optional<std::set<std::uint32_t>> fixtures = {};
};

}  // namespace marketgen::episodes
