// Shelves that a drawing has in its zones, as runs of the program's zones.
#pragma once
#include "intake/candidate.h"

namespace marketgen::intake {

// Sets ProgramZone::drawn_runs, and the runs of zones of shelves where the words count neither
// fixtures nor runs there; a number in words that differs from the drawing's is a conflict, and so
// are drawn runs that have no room. Precondition: the program is drawn.
void settle_runs(StoreProgram& program,
                 const Candidate& candidate,
                 const Concessions& concessions,
                 Understanding& found);

// Lowers the runs of zones that a layout of the plan has no room for, each a conflict, so that no
// zone has to give up drawn floor for them. False when all had room.
bool lower_runs(StoreProgram& program,
                const plan::Plan& plan,
                const catalog::Catalog& catalog,
                Understanding& found);

// The aisle between runs that are drawn: as usual, or narrower where that many need it, but no
// narrower than the profile allows. Precondition: the zone has drawn runs.
int drawn_aisle_mm(const ProgramZone& zone,
                   const RectMm& floor,
                   int usual_mm,
                   const catalog::ProfileRow& profile);

}  // namespace marketgen::intake
