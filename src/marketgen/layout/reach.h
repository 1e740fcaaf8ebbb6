// Where people and wheelchairs get to, and the local repair that opens what is shut off.
#pragma once
#include <set>
#include <string>
#include <vector>

#include "layout/design.h"
#include "layout/layout.h"
#include "navigation/occupancy.h"

namespace marketgen::layout {

constexpr int person_width_mm = 850;  // a shopper with a basket (docs/design, aisles)
constexpr int robot_width_mm =
    840;  // swept base of the robot that NAV is measured for (audit/audit.h)

// The free floor for something round of this width, and the part of it that is connected to the
// entrance.
struct Reach {
  navigation::OccupancyGrid grid;
  navigation::Components components;
  int from_entrance = 0;  // label; 0 when the entrance itself is shut

  bool reached(std::size_t cell) const {
    return from_entrance != 0 && components.label[cell] == from_entrance;
  }
  // Some cell within the rectangle can be got to.
  bool reaches(const RectMm& rect) const;
};

// What of a grid's free cells is connected to the entrance.
Reach reach_on(navigation::OccupancyGrid grid, const Floor& floor, const plan::Shell& shell);

Reach reach_of(const Floor& floor,
               const plan::Shell& shell,
               const std::vector<Fixture>& fixtures,
               int width_mm);

// Where a shopper stands before the fixture's front; `side` 1 is the back of a double-sided one.
RectMm standing_place(const Fixture& fixture, int side, int width_mm);

// Takes away the fewest modules that shut off floor or stand where nobody can get to. Those of
// `standing` zones, by id, are not taken away.
std::vector<Fixture> opened_up(const Design& design,
                               std::vector<Fixture> fixtures,
                               const std::set<std::string>& standing = {});

}  // namespace marketgen::layout
