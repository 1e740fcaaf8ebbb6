// Units in line: a few modules of a run that are of another kind than the others, as a spice rack
// among shelves. They stand in the place of modules of the run and take their ids and floor.
//
// Only with plan::Outfit::full. What a zone gets follows from the seed and its own runs alone.
#pragma once
#include <string_view>
#include <vector>

#include "layout/zone_build.h"

namespace marketgen::layout {

struct InLineRow {
  std::string_view kind;                   // fixture kind
  std::string_view among;                  // generator of the modules whose place it takes
  std::vector<std::string_view> zones;     // zone types that have it
  std::vector<std::string_view> profiles;  // kinds of shop that have it; none: all
  int modules;                             // side by side, at most
  double chance;                           // that a zone has any
  std::string_view source;                 // why so
};

const std::vector<InLineRow>& in_line_rows();

// Zones that stand, and those of which somebody said how their shelves are, stay as they are.
void put_in_line(std::vector<Fixture>& fixtures, const Build& build);

// At joints of different kinds each side closes its run: neither has the other's panels.
void close_joints_of_kinds(std::vector<Fixture>& fixtures);

}  // namespace marketgen::layout
