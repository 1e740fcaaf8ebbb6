// People as actors of a picture: each one body, posed as they stand, of the category "person".
#pragma once
#include <span>
#include <vector>

#include "assets/people/person.h"
#include "render/stage/actor.h"

namespace marketgen::render {

inline constexpr std::string_view person_category = "person";

// Named "person". Meshes are made side by side on all threads: about a second of one core each.
Actor person_actor(const assets::PlacedPerson& person,
                   assets::PersonDetail detail = assets::PersonDetail::near);
std::vector<Actor> person_actors(std::span<const assets::PlacedPerson> people,
                                 assets::PersonDetail detail = assets::PersonDetail::near);

}  // namespace marketgen::render
