// What photos of a shop say, as wishes for its plan, and as a person reads it.
#pragma once
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "intake/brief.h"
#include "intake/understanding.h"

namespace marketgen::intake {

// Sets Understanding::photographed from the brief's photos, by both of their readers
// (intake/settled_look.h): what is sure and neither said by a flag nor by the words. A style that
// was asked for says materials, lamps and light. Where flag, words or style say something else than
// a sure photo, that is a Conflict. Precondition: flags were applied (intake/conflicts.h).
void apply_photos(const Brief& brief, const catalog::Catalog& catalog, Understanding& found);

// "floor wood 0.83, lamps panel 0.90 (not sure: wall, levels)"
std::string words_of(const photo::PhotoReading& photo);

// The attributes that are not relied upon: "wall, levels"; empty when all are.
std::string not_sure_of(const photo::PhotoReading& photo);

}  // namespace marketgen::intake
