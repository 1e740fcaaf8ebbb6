// Parts of a track's task as tasks of their own: a curriculum for learners. The worlds, robots and
// limits are those of the whole task.
#pragma once
#include <array>
#include <string_view>

namespace marketgen::episodes {

// drive   aisle: from somewhere near to where the robot can take one product
// pick    aisle: from there, the open hand before the product, until it is off its shelf
// place   checkout: one box that stands on the counter goes into the basket
// open    aisle: from before a glass door, the open hand before its bar, until it stands open
enum class Stage { whole, drive, pick, place, open };
constexpr std::array<std::string_view, 5> names_of(Stage) {
  return {"whole", "drive", "pick", "place", "open"};
}

// Of an episode: those who learn have shorter limits of their own, at which nothing is judged.
constexpr double stage_limit_s = 60;

}  // namespace marketgen::episodes
