// Where the things lie that a wish may name: zones, openings, walls, the middle, the tills.
//
// The one home of these names: a plan's validation, planners, layout rules and the audit all ask
// here, so that "the entrance" is the same piece of floor to each of them. Store frame, whole
// millimetres.
#pragma once
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/rectangle.h"
#include "plan/plan.h"

namespace marketgen::plan {

// Names that mean something in every shop, beside its own zones (by id or type) and openings (by id
// or kind).
constexpr std::array<std::string_view, 6> fixed_places = {
    "north", "south", "east", "west", "center", "checkout"};

// What stands at a wall comes this near to it: the deepest wall cabinets of data/fixtures.json are
// 1.1 m, and some decimetres for a divider or a step.
constexpr int wall_strip_mm = 1500;
// The floor right inside a door, as wide and deep: where someone stands who has just come in. Our
// own figure.
constexpr int doorstep_mm = 1000;

enum class PlaceKind { wall, middle, zone, opening };

struct NamedPlace {
  PlaceKind kind = PlaceKind::zone;
  RectMm rect;  // of a wall its strip, of an opening its doorstep, of the middle the middle third
  friend bool operator==(const NamedPlace&, const NamedPlace&) = default;
};

// A zone and the floor that it has; empty when it has none.
struct PlacedZone {
  std::string_view id, type;
  RectMm rect;
};

// A floor with what has a name on it. Views of the plan or layout that it was made from.
struct NamedFloor {
  RectMm bounds;  // of the floor's outline
  std::span<const Opening> openings;
  std::vector<PlacedZone> zones;
};

// Everything that goes by the name; "checkout" means self-checkouts, too. Empty when the floor has
// no such thing.
std::vector<NamedPlace> places_named(const NamedFloor& floor, std::string_view name);

// The unit vector from a wall into the store: the way someone walks who comes in there.
PointMm inward_from(Wall wall);

// Whether a side of the shell runs from west to east.
bool runs_east(Wall wall);

// The point `by_mm` inside the middle of an opening; on the wall's line for 0.
PointMm point_inside(const RectMm& bounds, const Opening& opening, int by_mm);

}  // namespace marketgen::plan
