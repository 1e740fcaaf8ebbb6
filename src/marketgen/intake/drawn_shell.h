// The floor plan of a brief: read once, and held against what flags and words say.
#pragma once
#include <string>
#include <vector>

#include "intake/brief.h"
#include "intake/understanding.h"

namespace marketgen::intake {

struct Drawn {
  Brief brief;                        // with its shell and zones
  std::vector<std::string> warnings;  // of what was read, for a person: "FILE: …"
};

// Reads the brief's floor plan, if it has one that was not read yet. Where the drawing says no
// scale, --size or a size in the words does. Errors: those of drawing::read_floor_plan,
// usage.bad_flag for the scale and for more than one picture. A picture of zones is read as well
// (drawing::read_zone_drawing): it gives the shell where no floor plan does.
Result<Drawn> with_drawing(Brief brief, const catalog::Catalog& catalog);

// The drawn shell as it will be built: flags beat words, words beat the drawing, and each loss is a
// Conflict. A size that was said stretches the drawing; a door that is said to be in another wall
// takes one that is drawn there, or is left to be placed. Sets Understanding::drawn_front.
// Precondition: the brief has a shell, and flags were applied.
plan::Shell settled_shell(const Brief& brief, Understanding& found);

}  // namespace marketgen::intake
