// A draft as it would be built: turned to the entrance's wall, with doors, in the store frame.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "intake/floor_draft.h"
#include "intake/understanding.h"
#include "plan/plan.h"

namespace marketgen::intake {

struct Candidate {
  Slice root;
  RectMm floor;
  std::vector<RectMm> rects;            // by zone index
  std::vector<plan::Opening> openings;  // entrance and exit first
  DraftedFloor drafted;
  double door_off_m = 0;  // of the drafted entrance from the one on the floor plan
};

// Whether the wall of the entrance lies east to west.
bool front_runs_east(const Candidate& candidate);

// The wall that the entrance is to be in; south when nobody says.
plan::Wall entrance_wall_of(const Understanding& found);

// A floor that is cut already, in the store frame: doors that are not drawn stand at the tills, and
// away from them. Its `drafted` is empty.
Candidate make_candidate(Slice root, const StoreProgram& program, const Understanding& found);

Candidate make_candidate(const FloorDraft& draft,
                         const StoreProgram& program,
                         const Understanding& found,
                         const catalog::Catalog& catalog);

}  // namespace marketgen::intake
