// Accessories: what stands in zones beside the fixtures that they are for. Scales by the produce,
// roll cages in the back room, mirrors over runs along walls, antennas at the way out.
//
// accessories.inc has the rows, accessory_places.inc where they may stand. They are placed last:
// nothing else moves for them, aisles stay as wide as they must be, every front can be got to and
// no free floor is cut off (layout/floor_guard.h).
#pragma once
#include <array>
#include <string_view>
#include <vector>

#include "layout/layout.h"

namespace marketgen::layout {

enum class AccessoryPlace {
#define ACCESSORY_PLACE(name, where) name,
#include "layout/accessory_places.inc"
#undef ACCESSORY_PLACE
};

struct AccessoryRow {
  std::string_view id;                     // "scales"
  std::vector<std::string_view> kinds;     // fixture kinds; each store has one of them, drawn
  std::vector<AccessoryPlace> places;      // the first that has a spot is taken
  std::vector<std::string_view> zones;     // zone types that have it; none for what is at doors
  std::vector<std::string_view> profiles;  // kinds of shop that have it; none: all
  double store_m2;                         // smaller stores have none
  double zone_m2;                          // one for so much floor of a zone; 0: one a zone
  int most;                                // in the whole store
  double chance;                           // that a zone, or the door, has any
  std::string_view source;                 // why so
  bool only_full = false;                  // plan::Outfit::full has it, and nothing else

  bool at_door() const {
    return places.front() == AccessoryPlace::entrance || places.front() == AccessoryPlace::exit ||
           places.front() == AccessoryPlace::way_out;
  }
};

// In the order in which they are placed.
const std::vector<AccessoryRow>& accessory_rows();

// Somebody said how this zone's shelves are, or how many: then there are no others. With a full
// outfit their colour and material do not count.
bool is_described(const plan::Plan& plan, std::size_t zone);

// Equipment of doors, and accessories: in a zone, but none of the fixtures that the zone is for.
bool is_accessory(const Fixture& fixture);

}  // namespace marketgen::layout
