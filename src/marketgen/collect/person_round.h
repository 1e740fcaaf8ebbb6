// Rounds of people, drawn one at a time: see store_people.h.
#pragma once
#include <optional>
#include <vector>

#include "collect/store_people.h"

namespace marketgen::collect {

// Where somebody may stand and what they look at.
struct StandingPlace {
  Vec2 position;
  double heading_rad = 0;
};

struct PeopleFloor {
  navigation::VisibilityGraph graph;   // for a person with what they carry
  std::vector<StandingPlace> shelves;  // before stocked fixtures
  std::vector<StandingPlace> tills;    // beside tills, looking at them
};
// Errors: those of drive_graph().
Result<PeopleFloor> people_floor(const scene::Scene& scene);

// Person `number`; nothing when the floor gives no round. Of who they are only the seed decides.
PersonRound new_person(const scene::Scene& scene, int number, Seed seed);
std::optional<std::vector<PersonAct>> draw_acts(const PeopleFloor& floor,
                                                const PersonRound& person,
                                                bool walks,
                                                Stream& draw);

// A whole round in one place.
std::vector<PersonAct> acts_of_standing(const StandingPlace& place);

// Where they are, `time_s` after the beginning of the round, 0 to round_s.
assets::WayPlace place_in_round(const PersonRound& person, double time_s);
bool stands_in_round(const PersonRound& person, double time_s);
double room_in_round(const PersonRound& person, double time_s);
assets::PersonPose pose_in_round(const PersonRound& person, double time_s);

}  // namespace marketgen::collect
