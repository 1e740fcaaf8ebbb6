// Relations between places, measured on a layout.
//
// Left, right and behind are seen by someone who comes in at the entrance. Distances are between
// the edges of the zones.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "layout/layout.h"

namespace marketgen {

struct RelationResult {
  bool holds = false;
  double value_m = 0, limit_m = 0;  // what was measured and what it is compared with
  std::string message;  // "zone bakery is 9.2 m from entrance; near means 5.7 m at most"
  std::optional<PointMm> at_mm;
};

// A name that the layout does not have makes the relation hold: validation reports such names.
RelationResult check_relation(const Layout& layout, const Relation& relation);

// The places a name stands for: zones by id or type, openings by id or kind, walls, "checkout",
// "center".
std::vector<RectMm> places_named(const Layout& layout, std::string_view name);

double distance_m(const RectMm& a, PointMm b);
double distance_m(const RectMm& a, const RectMm& b);

}  // namespace marketgen
