// Do the relations that were asked for hold on the floor of a candidate?
//
// They are measured as everywhere (plan/relation.h). A planner keeps a margin, because layouts
// shift what it planned by some decimetres.
#pragma once
#include <optional>

#include "intake/candidate.h"
#include "plan/relation.h"

namespace marketgen::intake {

// The candidate's floor with its zones and openings. Views of both.
plan::NamedFloor named_floor(const Candidate& candidate, const StoreProgram& program);

// The slack that the planner asks for: a tenth of the limit, a decimetre at least. Our own figure.
double planner_margin_m(const plan::RelationMeasure& measure);

// How badly the wish is missed: 0 when it holds with the planner's margin, otherwise 1 and more
// with the distance in store diagonals added; 2 when it cannot be judged here. Precondition: a
// relation.
double miss_of(const plan::Requirement& wish, const plan::NamedFloor& floor);

// How far a relation that holds is from being plain to see, in store diagonals; 0 when anyone would
// say so. "Near" is said of what is a few steps away, "left of" of what lies more to the left than
// ahead, "between" of what lies on the way. Our own figures, tighter than those of
// plan/relation.h.
double strain_of(const plan::Requirement& wish, const plan::NamedFloor& floor);

// Along which axis the fronts of what faces one another look, where they can. Fixtures on walls
// look away from them, those of other zones can be turned so.
std::optional<plan::Axis> sight_of(const plan::Requirement& wish, const plan::NamedFloor& floor);

}  // namespace marketgen::intake
