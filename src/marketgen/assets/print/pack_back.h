// The back and sides of a pack: small print, nutrition table, bar code.
#pragma once
#include "assets/print/canvas.h"
#include "assets/print/pack_art.h"

namespace marketgen::assets {

// All in millimetres on the canvas; the ground has been painted in a colour on which `type` reads.
struct InfoField {
  Area area;
  Color type;
};

// Brand, description, ingredients, dates, recycling mark and, at the lower right, the EAN on white.
// Returns what is left.
Area draw_back(Canvas& canvas, const PackArt& art, const InfoField& field);
// The same with the nutrition table, where it fits: for packs that have no side for it.
void draw_full_back(Canvas& canvas, const PackArt& art, const InfoField& field);
// The nutrition table (food) or the directions (other goods).
void draw_nutrition_side(Canvas& canvas, const PackArt& art, const InfoField& field);
// Picture, brand and a sentence.
void draw_story_side(Canvas& canvas, const PackArt& art, const InfoField& field);
// Dates and lot alone.
void draw_bottom(Canvas& canvas, const PackArt& art, const InfoField& field);

}  // namespace marketgen::assets
