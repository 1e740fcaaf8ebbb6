// People in a store: shoppers who walk from shelf to shelf and look at goods, and staff, each at
// any time.
//
// Everybody follows a round that takes round_s and begins anew: stand before a shelf, turn, walk
// along the shortest way, turn to the next shelf. Rounds are drawn one person after another from
// streams of their own, so that more people change nobody, and are kept only when their person
// never comes too near to anybody before them. So nobody ever walks into a fixture or into anybody.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "assets/people/person.h"
#include "base/result.h"
#include "collect/floor_way.h"
#include "scene/scene.h"

namespace marketgen::collect {

inline constexpr double round_s = 120;
inline constexpr int max_people = 200;

// Speeds of walking people, m/s: comfortable gait is 0.94 to 1.43 m/s over age and sex (Bohannon
// and Williams Andrews, Physiotherapy 97, 2011); who looks at shelves on the way is slower.
inline constexpr double min_walk_m_s = 0.6, max_walk_m_s = 1.4;

// From which a store's own people are drawn.
Seed people_seed(const scene::Scene& scene);

// One piece of a round.
struct PersonAct {
  double begin_s = 0, length_s = 0;
  Vec2 position;  // standing, turning
  double heading_rad = 0, turn_rad = 0;
  std::shared_ptr<const FloorWay> way = {};  // walking
  double walk_m = 0;                         // of the way, from its beginning
  int steps = 0;
};

// Somebody's round.
struct PersonRound {
  assets::PersonLook look;
  std::vector<PersonAct> acts;  // end to end from 0 to round_s
  double ahead_s = 0;           // how far they are in their round at time 0
  bool basket = false, carries = false;
  double head_down_rad = 0.2, head_left_rad = 0;
  double room_m = 0;  // StorePeople::room_m() of who stands
};

class StorePeople {
 public:
  // `count` people, 0 to max_people; one in five is staff, who stand near tills and before shelves.
  // Deterministic for any thread count. `scene` is not kept. Errors: usage.bad_flag for another
  // count; people.no_room, with how many found a place, where the free floor holds no more; those
  // of drive_graph().
  static Result<StorePeople> make(const scene::Scene& scene, int count, Seed seed);

  std::size_t count() const { return rounds_.size(); }
  const PersonRound& round(std::size_t person) const { return rounds_[person]; }
  // Where a person's origin is; O(log acts).
  assets::WayPlace place(std::size_t person, double time_s) const;
  // The radius about it that body, feet and things carried keep.
  double room_m(std::size_t person, double time_s) const;
  // Posed.
  assets::PlacedPerson person(std::size_t person, double time_s) const;
  std::vector<assets::PlacedPerson> at(double time_s) const;

 private:
  std::vector<PersonRound> rounds_;
};

}  // namespace marketgen::collect
