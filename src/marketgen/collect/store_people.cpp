#include "collect/store_people.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "collect/person_round.h"

namespace marketgen::collect {
namespace {

constexpr double sample_s = 0.04;  // two people at 1.4 m/s come 0.11 m nearer
constexpr double apart_m = 0.06;   // beside their rooms; half of that 0.11 m
constexpr std::size_t samples = 3000;
static_assert(samples * sample_s == round_s);
constexpr int rounds_tried = 40, starts_tried = 24;
constexpr double share_of_standing = 0.25;

struct Stand {
  Vec2 position;
  double room_m;
};
using Stands = std::vector<Stand>;  // at each sample of the round, as time goes

Stands stands_of(const PersonRound& person) {
  Stands stands;
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) * sample_s;
    stands.push_back({place_in_round(person, t).position, room_in_round(person, t)});
  }
  return stands;
}

bool keeps_away(const Stands& a, std::size_t ahead, const Stands& b) {
  for (std::size_t i = 0; i < samples; ++i) {
    const Stand& p = a[(i + ahead) % samples];
    const double dx = p.position.x - b[i].position.x, dy = p.position.y - b[i].position.y;
    const double least = p.room_m + b[i].room_m + apart_m;
    if (dx * dx + dy * dy < least * least) return false;
  }
  return true;
}

class Company {
 public:
  explicit Company(const PeopleFloor& floor) : floor_(floor) {}

  // Takes the person in with the first round drawn that never comes near to anybody. In a store
  // full of walkers somebody who walks, too, finds more room than who stands.
  bool add(PersonRound person, Seed seed) {
    Stream draw = seed.child("round").stream();
    const bool stands = person.carries || draw.chance(share_of_standing);
    return take_round(person, !stands, draw) || stand_anywhere(person, draw) ||
           take_round(person, true, draw);
  }

  std::vector<PersonRound> rounds() { return std::move(rounds_); }

 private:
  bool take_round(PersonRound& person, bool walks, Stream& draw) {
    for (int i = 0; i < rounds_tried; ++i) {
      auto acts = draw_acts(floor_, person, walks, draw);
      if (!acts) continue;
      person.acts = std::move(*acts);
      if (start(person, walks ? starts_tried : 1)) return true;
    }
    return false;
  }

  // Where no round is free any more, some place before a shelf may be.
  bool stand_anywhere(PersonRound& person, Stream& draw) {
    std::vector<StandingPlace> places = floor_.shelves;
    draw.shuffle(std::span(places));
    return std::any_of(places.begin(), places.end(), [&](const StandingPlace& place) {
      person.acts = acts_of_standing(place);
      return start(person, 1);
    });
  }

  bool start(PersonRound& person, int starts) {
    const Stands stands = stands_of(person);
    for (int i = 0; i < starts; ++i) {
      const std::size_t ahead =
          samples / static_cast<std::size_t>(starts_tried) * static_cast<std::size_t>(i);
      if (!std::all_of(stands_.begin(), stands_.end(), [&](const Stands& other) {
            return keeps_away(stands, ahead, other);
          }))
        continue;
      person.ahead_s = static_cast<double>(ahead) * sample_s;
      Stands as_time_goes(samples);
      for (std::size_t s = 0; s < samples; ++s)
        as_time_goes[s] = stands[(s + ahead) % samples];
      stands_.push_back(std::move(as_time_goes));
      rounds_.push_back(person);
      return true;
    }
    return false;
  }

  const PeopleFloor& floor_;
  std::vector<PersonRound> rounds_;
  std::vector<Stands> stands_;
};

double in_round(const PersonRound& person, double time_s) {
  const double t = std::fmod(time_s + person.ahead_s, round_s);
  return t < 0 ? t + round_s : t;
}

}  // namespace

Seed people_seed(const scene::Scene& scene) {
  return Seed(scene.seed).child("people");
}

Result<StorePeople> StorePeople::make(const scene::Scene& scene, int count, Seed seed) {
  if (count < 0 || count > max_people)
    return Error{"usage.bad_flag", "people", fmt::format("give 0 to {} people", max_people)};
  StorePeople people;
  if (count == 0) return people;
  MARKETGEN_TRY(const PeopleFloor floor, people_floor(scene));
  Company company(floor);
  for (int i = 0; i < count; ++i) {
    const Seed own = seed.child("person", static_cast<std::uint64_t>(i));
    if (!company.add(new_person(scene, i, own), own))
      return Error{"people.no_room",
                   "people",
                   fmt::format("the free floor holds {} of {} people who keep clear of one "
                               "another; ask for fewer",
                               i,
                               count)};
  }
  people.rounds_ = company.rounds();
  return people;
}

assets::WayPlace StorePeople::place(std::size_t person, double time_s) const {
  return place_in_round(rounds_[person], in_round(rounds_[person], time_s));
}

double StorePeople::room_m(std::size_t person, double time_s) const {
  return room_in_round(rounds_[person], in_round(rounds_[person], time_s));
}

assets::PlacedPerson StorePeople::person(std::size_t person, double time_s) const {
  return placed_in_round(rounds_[person], in_round(rounds_[person], time_s));
}

std::vector<assets::PlacedPerson> StorePeople::at(double time_s) const {
  std::vector<assets::PlacedPerson> people;
  for (std::size_t i = 0; i < rounds_.size(); ++i)
    people.push_back(person(i, time_s));
  return people;
}

}  // namespace marketgen::collect
