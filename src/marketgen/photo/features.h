// Numbers that tell looks of shops apart, in groups.
#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "photo/bank.h"
#include "photo/cells.h"
#include "photo/parts.h"

namespace marketgen::photo {

// Of each part its colours, edges and grain, weighted by how surely a square shows it; "light":
// colour of the whole and of what is brightest; "lamps": bright spots above; "lines": directions of
// edges and where they lead; "room": where parts are in the photo; "whole": colours and grain of
// all of it.
constexpr std::array<std::string_view, 10> group_names = {
    "floor", "wall", "ceiling", "fixture", "goods", "light", "lamps", "lines", "room", "whole"};

struct Features {
  std::array<std::vector<double>, group_names.size()> groups;

  // Those of the named groups, one after another. Precondition: names are of group_names.
  std::vector<double> of(const std::vector<std::string>& names) const;
};

Features features_of(const Looked& photo, const Cells& cells, const std::vector<PartShares>& parts);

// How many numbers a group has; 0 for no group.
std::size_t feature_count(std::string_view group);

}  // namespace marketgen::photo
