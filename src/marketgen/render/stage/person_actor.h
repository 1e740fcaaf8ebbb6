// People as actors of a picture: each one body, posed as they stand, of the category "person".
#pragma once
#include <span>
#include <vector>

#include "assets/people/person.h"
#include "render/stage/actor.h"

namespace marketgen::render {

inline constexpr std::string_view person_category = "person";

// near for up to 20 people in a picture, of whom each takes some 200,000 triangles and a second of
// one core; far, a quarter of that, for more.
assets::PersonDetail detail_of_company(std::size_t people);

// Named "person". Meshes are made side by side on all threads: about a second of one core each.
Actor person_actor(const assets::PlacedPerson& person,
                   assets::PersonDetail detail = assets::PersonDetail::near);
std::vector<Actor> person_actors(std::span<const assets::PlacedPerson> people,
                                 assets::PersonDetail detail = assets::PersonDetail::near);

}  // namespace marketgen::render
