// Ways out that a sales floor needs: for how many people it is, how many doors they need, how wide
// together, and where further ones may be.
//
// Figures are those of the International Building Code (2021) for mercantile floors.
#pragma once
#include <vector>

#include "plan/plan.h"

namespace marketgen::plan {

constexpr double egress_mm_per_person = 5.08;  // of door: 0.2 in (1005.3.2)
// Of one leaf and a half, as emergency exits of halls have them; 32 in clear at least (1010.1.1).
constexpr int emergency_door_mm = 1200;

bool leads_outside(const Opening& opening);  // entrances, exits, emergency exits

double people_on(double floor_m2);  // 60 sq ft gross each (table 1004.5)

// How many doors so many people need (1006.2.1, 1006.3.3).
int doors_for(double people);

struct WaysOut {
  double people = 0;  // that the floor is for
  int doors = 0;      // that lead outside
  int width_mm = 0;   // of all of them together
  int needed_doors() const { return doors_for(people); }
  double needed_width_mm() const { return people * egress_mm_per_person; }
};
WaysOut ways_out(const Shell& shell);

// The emergency exits that the shell lacks for its people, each as far as can be from every other
// way out, where there is wall, floor inside it and no other opening. Fewer where walls have no
// room. Their ids are "emergency", "emergency-2"…: none that an opening of the shell has.
std::vector<Opening> lacking_exits(const Shell& shell);

}  // namespace marketgen::plan
