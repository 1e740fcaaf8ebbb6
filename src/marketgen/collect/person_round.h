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
  bool operator==(const StandingPlace&) const = default;
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

// Of somebody who decides as they go: they turn to their way, walk it, turn to what they look at
// there and stand; with less than two points they stand where they are. Store frame.
struct PersonWalk {
  StandingPlace from;
  std::vector<PointMm> points = {};
  double heading_rad = 0;  // in the end
  double speed_m_s = 1, stay_s = 0;
  int steps_cut = 0;  // stopped after so many of them, at least two, and stood there; 0: not

  bool walks() const { return points.size() > 1; }
  bool operator==(const PersonWalk&) const = default;
  template <class Archive, class Self>
  static void bytes(Archive& archive, Self& self) {
    archive(self.from.position.x, self.from.position.y, self.from.heading_rad, self.points);
    archive(self.heading_rad, self.speed_m_s, self.stay_s, self.steps_cut);
  }
};
std::vector<PersonAct> acts_of_walk(const PersonWalk& walk);
// Metres of its way that somebody has walked.
double walked_in_act(const PersonAct& act, double time_s);
// Of the acts, the one that is walked; nothing where none is.
const PersonAct* walked_act(const std::vector<PersonAct>& acts);
// What somebody who walks so fast needs until they stand.
double stopping_m(double speed_m_s);

// A whole round in one place.
std::vector<PersonAct> acts_of_standing(const StandingPlace& place);

// Where they are, `time_s` after the beginning of the round, 0 to round_s.
assets::WayPlace place_in_round(const PersonRound& person, double time_s);
double room_in_round(const PersonRound& person, double time_s);
assets::PersonPose pose_in_round(const PersonRound& person, double time_s);
assets::PlacedPerson placed_in_round(const PersonRound& person, double time_s);

}  // namespace marketgen::collect
