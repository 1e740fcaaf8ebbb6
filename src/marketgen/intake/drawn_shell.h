// The floor plan and the pictures of a brief: read once, and held against what flags and words say.
#pragma once
#include <string>
#include <vector>

#include "intake/brief.h"
#include "intake/understanding.h"

namespace marketgen::intake {

struct Drawn {
  Brief brief;                        // with its shell, zones and photos
  std::vector<std::string> warnings;  // of what was read, for a person: "FILE: …"
};

// Reads the brief's floor plan, if it has one that was not read yet. Where the drawing says no
// scale, --size or a size in the words does. Each picture is a drawing of zones
// (drawing::read_zone_drawing), which gives the shell where no floor plan does, or a photo of a
// shop (photo::read_photo). Errors: those of drawing::read_floor_plan, drawing::read_zone_drawing
// and photo::load_bank; usage.bad_flag for the scale and for more than one drawing of zones;
// photo.not_a_shop.
Result<Drawn> with_drawing(Brief brief, const catalog::Catalog& catalog);

// The drawn shell as it will be built: flags beat words, words beat the drawing, and each loss is a
// Conflict. A size that was said stretches the drawing; a door that is said to be in another wall
// takes one that is drawn there, or is left to be placed. Sets Understanding::drawn_front.
// Precondition: the brief has a shell, and flags were applied.
plan::Shell settled_shell(const Brief& brief, Understanding& found);

}  // namespace marketgen::intake
