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

using Places = std::vector<Vec2>;  // at each sample of the round, as time goes

Places places_of(const PersonRound& person) {
  Places places;
  for (std::size_t i = 0; i < samples; ++i)
    places.push_back(place_in_round(person, static_cast<double>(i) * sample_s).position);
  return places;
}

bool keeps_away(const Places& a, std::size_t ahead, const Places& b, double distance_m) {
  const double least = distance_m * distance_m;
  for (std::size_t i = 0; i < samples; ++i) {
    const Vec2& p = a[(i + ahead) % samples];
    const double dx = p.x - b[i].x, dy = p.y - b[i].y;
    if (dx * dx + dy * dy < least) return false;
  }
  return true;
}

class Company {
 public:
  explicit Company(const PeopleFloor& floor) : floor_(floor) {}

  // Takes the person in with the first round drawn that never comes near to anybody.
  bool add(PersonRound person, Seed seed) {
    Stream draw = seed.child("round").stream();
    const bool stands = person.carries || draw.chance(share_of_standing);
    for (int i = 0; i < rounds_tried; ++i) {
      auto acts = draw_acts(floor_, person, !stands, draw);
      if (!acts) continue;
      person.acts = std::move(*acts);
      if (start(person, stands ? 1 : starts_tried)) return true;
    }
    return stand_anywhere(person, draw);
  }

  std::vector<PersonRound> rounds() { return std::move(rounds_); }

 private:
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
    const Places places = places_of(person);
    for (int i = 0; i < starts; ++i) {
      const std::size_t ahead =
          samples / static_cast<std::size_t>(starts_tried) * static_cast<std::size_t>(i);
      if (!is_free(person, places, ahead)) continue;
      person.ahead_s = static_cast<double>(ahead) * sample_s;
      Places as_time_goes(samples);
      for (std::size_t s = 0; s < samples; ++s)
        as_time_goes[s] = places[(s + ahead) % samples];
      places_.push_back(std::move(as_time_goes));
      rounds_.push_back(person);
      return true;
    }
    return false;
  }

  bool is_free(const PersonRound& person, const Places& places, std::size_t ahead) const {
    for (std::size_t i = 0; i < rounds_.size(); ++i) {
      const double distance = person.room_m + rounds_[i].room_m + apart_m;
      if (!keeps_away(places, ahead, places_[i], distance)) return false;
    }
    return true;
  }

  const PeopleFloor& floor_;
  std::vector<PersonRound> rounds_;
  std::vector<Places> places_;
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

assets::PlacedPerson StorePeople::person(std::size_t person, double time_s) const {
  const PersonRound& round = rounds_[person];
  const double t = in_round(round, time_s);
  const assets::WayPlace place = place_in_round(round, t);
  return {round.look,
          pose_in_round(round, t),
          {{place.position.x, place.position.y, 0}, rotation_about({0, 0, 1}, place.heading_rad)}};
}

std::vector<assets::PlacedPerson> StorePeople::at(double time_s) const {
  std::vector<assets::PlacedPerson> people;
  for (std::size_t i = 0; i < rounds_.size(); ++i)
    people.push_back(person(i, time_s));
  return people;
}

}  // namespace marketgen::collect
