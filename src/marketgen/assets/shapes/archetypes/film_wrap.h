// The film wall of multipacks: drawn tight around upright pieces in rows, sunk a little where two
// pieces meet.
#pragma once
#include <vector>

#include "assets/shapes/archetypes/outline_wall.h"
#include "assets/shapes/archetypes/pack_faces.h"

namespace marketgen::assets {

// Printed levels take the carton's sides: front, right, back, left.
void add_film_wall(PackBuilder& pack, const FilmForm& form, const std::vector<WallLevel>& levels);

// Where piece (i, k) stands: i from the left, k from the front.
Vec3f piece_place(const PackBuilder& pack, const FilmForm& form, int i, int k);

}  // namespace marketgen::assets
