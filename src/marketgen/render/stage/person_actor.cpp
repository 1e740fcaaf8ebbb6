#include "render/stage/person_actor.h"

#include <algorithm>

#include "base/parallel.h"

namespace marketgen::render {

assets::PersonDetail detail_of_company(std::size_t people) {
  constexpr std::size_t max_near = 20;
  return people <= max_near ? assets::PersonDetail::near : assets::PersonDetail::far;
}

Actor person_actor(const assets::PlacedPerson& person, assets::PersonDetail detail) {
  ActorBody body;
  body.name = "body";
  body.world_from_body = person.world_from_person;
  for (assets::PersonPart& part : assets::person_parts(person.look, person.pose, detail)) {
    std::fill(part.mesh.surfaces.begin(),
              part.mesh.surfaces.end(),
              static_cast<std::uint16_t>(body.surfaces.size()));
    body.mesh.append(part.mesh);
    body.surfaces.push_back({part.color, part.roughness, 0, part.scatter_m});
  }
  Actor actor{std::string(person_category), {}, std::string(person_category)};
  actor.bodies.push_back(std::move(body));
  return actor;
}

std::vector<Actor> person_actors(std::span<const assets::PlacedPerson> people,
                                 assets::PersonDetail detail) {
  return parallel_map(people.size(),
                      [&](std::size_t i) { return person_actor(people[i], detail); });
}

}  // namespace marketgen::render
