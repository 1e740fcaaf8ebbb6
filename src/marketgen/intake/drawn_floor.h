// The floor of a drawing of zones, as the planner would build it.
#pragma once
#include <string>
#include <vector>

#include "intake/candidate.h"

namespace marketgen::intake {

struct DrawnFloor {
  Candidate candidate;
  double fit_iou = 0;  // of the slices, with the drawing
};

// The program's zones where they are drawn. One that is not drawn takes a part of the floor of a
// drawn one: tills of bare floor or of a zone near the exit, as many as have room there where
// nobody counts them; others of the largest. Precondition: the program is drawn.
DrawnFloor drawn_floor(StoreProgram& program, const Understanding& found);

// Words win over the drawing: zones that they refuse although they are drawn, and zones that they
// name although they are not, become conflicts. Precondition: as for drawn_floor.
void settle_zones(const StoreProgram& program, Understanding& found);

// Relations that do not hold on the drawn floor: each is only preferred in the plan, and a
// conflict.
void settle_relations(const Candidate& candidate,
                      const StoreProgram& program,
                      Understanding& found,
                      plan::Plan& plan);

}  // namespace marketgen::intake
