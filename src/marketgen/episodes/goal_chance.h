// Whether a task of a track may ask for a product of a store.
#pragma once
#include <cstdint>
#include <set>
#include <string>

namespace marketgen::episodes {

struct GoalChance {
  std::string why_not;  // a word; empty: it may
  // Rows in the scene's fixtures, off which it is taken where it may be asked for.
  std::set<std::uint32_t> fixtures;
};

}  // namespace marketgen::episodes
