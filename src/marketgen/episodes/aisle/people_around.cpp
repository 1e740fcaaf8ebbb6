#include "episodes/aisle/people_around.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace marketgen::episodes {
namespace {

constexpr double sample_s = 0.1;   // somebody at 1.4 m/s goes 0.14 m
constexpr double behind_s = 0.12;  // who is less behind is kept clear of by the rounds themselves
constexpr double clear_start_m = 1.5;
constexpr double patience_s = 3, rests_s = 4;
constexpr double back_share = 0.5;  // of the speed ahead
constexpr double give_room_m = 2;   // to a robot that is in the way of who steps back

double distance(Vec2 a, Vec2 b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

// From somebody's body there to the nearest of the discs.
double gap_m(Vec2 person, std::span<const FloorDisc> robot) {
  double gap = std::numeric_limits<double>::infinity();
  for (const FloorDisc& disc : robot)
    gap = std::min(gap, distance(person, disc.at) - disc.radius_m - person_radius_m);
  return gap;
}

}  // namespace

Result<PeopleAround> PeopleAround::make(const scene::Scene& scene,
                                        int max_count,
                                        Seed seed,
                                        Vec2 robot) {
  MARKETGEN_TRY(collect::StorePeople walkers,
                collect::StorePeople::walkers(scene, max_count, seed));
  auto rounds = std::make_shared<const collect::StorePeople>(std::move(walkers));
  Samples samples(rounds->count());
  PeopleAround around;
  for (std::size_t i = 0; i < rounds->count(); ++i) {
    for (double s = 0; s < collect::round_s - sample_s / 2; s += sample_s)
      samples[i].push_back({rounds->place(i, s).position, rounds->room_m(i, s)});
    if (distance(samples[i][0].at, robot) > clear_start_m)
      around.walkers_.push_back({static_cast<std::uint32_t>(i)});
  }
  around.rounds_ = std::move(rounds);
  around.samples_ = std::make_shared<const Samples>(std::move(samples));
  return around;
}

const PeopleAround::Sample& PeopleAround::sample(const Walker& walker, double clock_s) const {
  const std::vector<Sample>& all = (*samples_)[walker.round];
  const auto count = static_cast<long>(all.size());
  const long index = std::lround(clock_s / sample_s) % count;
  return all[static_cast<std::size_t>(index < 0 ? index + count : index)];
}

// On the way that the other, who is behind, has yet to go until then.
bool PeopleAround::meets_later(const Sample& there, const Walker& other, double until_s) const {
  const double from = std::max(other.clock_s, until_s - collect::round_s);
  for (double s = from; s <= until_s; s += sample_s) {
    const Sample& theirs = sample(other, s);
    if (distance(there.at, theirs.at) < there.room_m + theirs.room_m) return true;
  }
  return false;
}

bool PeopleAround::meets_anybody(std::size_t person, double clock_s) const {
  const Walker& walker = walkers_[person];
  const Sample &there = sample(walker, clock_s), &here = sample(walker, walker.clock_s);
  for (std::size_t i = 0; i < walkers_.size(); ++i) {
    if (i == person) continue;
    const Walker& other = walkers_[i];
    if (other.clock_s + behind_s < clock_s && meets_later(there, other, clock_s)) return true;
    const Sample& theirs = sample(other, other.clock_s);  // who has stepped back may be near
    const double apart = distance(there.at, theirs.at);
    if (apart < there.room_m + theirs.room_m && apart < distance(here.at, theirs.at)) return true;
  }
  return false;
}

bool PeopleAround::nears_robot(const Walker& walker,
                               double clock_s,
                               std::span<const FloorDisc> robot) const {
  const double gap = gap_m(rounds_->place(walker.round, clock_s).position, robot);
  return gap < stop_before_robot_m &&
         gap < gap_m(rounds_->place(walker.round, walker.clock_s).position, robot);
}

void PeopleAround::go_ahead(std::size_t person, double dt_s, std::span<const FloorDisc> robot) {
  Walker& walker = walkers_[person];
  const double next = walker.clock_s + dt_s;
  if (nears_robot(walker, next, robot)) {
    walker.held_up_s += dt_s;
    if (walker.held_up_s > patience_s) walker.turn(Going::back);
  } else if (!meets_anybody(person, next)) {
    walker.clock_s = next;
    walker.held_up_s = 0;
  }
}

void PeopleAround::go_back(std::size_t person, double dt_s, std::span<const FloorDisc> robot) {
  Walker& walker = walkers_[person];
  const double next = walker.clock_s - back_share * dt_s;
  const bool out_of_way = rounds_->stands(walker.round, walker.clock_s) &&
                          gap_m(place(person), robot) > give_room_m;
  const bool ends =
      out_of_way || nears_robot(walker, next, robot) || meets_anybody(person, next);
  if (ends)
    walker.turn(Going::rests);
  else
    walker.clock_s = next;
}

void PeopleAround::rest(std::size_t person, double dt_s, std::span<const FloorDisc> robot) {
  Walker& walker = walkers_[person];
  walker.held_up_s += dt_s;
  if (walker.held_up_s <= rests_s) return;
  if (!nears_robot(walker, walker.clock_s + dt_s, robot))
    walker.turn(Going::ahead);
  else if (gap_m(place(person), robot) < give_room_m)
    walker.turn(Going::back);
}

void PeopleAround::pass(double dt_s, std::span<const FloorDisc> robot) {
  for (std::size_t i = 0; i < walkers_.size(); ++i) {
    const Vec2 from = place(i);
    switch (walkers_[i].going) {
      case Going::ahead:
        go_ahead(i, dt_s, robot);
        break;
      case Going::back:
        go_back(i, dt_s, robot);
        break;
      case Going::rests:
        rest(i, dt_s, robot);
        break;
    }
    walkers_[i].speed_m_s = distance(from, place(i)) / dt_s;
  }
}

Vec2 PeopleAround::place(std::size_t person) const {
  return rounds_->place(walkers_[person].round, walkers_[person].clock_s).position;
}

std::vector<double> PeopleAround::clocks() const {
  std::vector<double> clocks;
  for (const Walker& walker : walkers_)
    clocks.push_back(walker.clock_s);
  return clocks;
}

Pose PeopleAround::store_from_person(std::size_t person) const {
  const Walker& walker = walkers_[person];
  const assets::WayPlace place = rounds_->place(walker.round, walker.clock_s);
  return {{place.position.x, place.position.y, 0}, rotation_about({0, 0, 1}, place.heading_rad)};
}

double PeopleAround::stature_m(std::size_t person) const {
  return rounds_->round(walkers_[person].round).look.stature_m;
}

assets::PlacedPerson PeopleAround::at(std::size_t person, double clock_s) const {
  return rounds_->person(walkers_[person].round, clock_s);
}

}  // namespace marketgen::episodes
