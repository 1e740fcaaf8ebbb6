#include "episodes/aisle/people_around.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "collect/drive_graph.h"
#include "motion/plan_drive.h"

namespace marketgen::episodes {
namespace {

constexpr double clear_start_m = 1.5;
constexpr double person_height_m = 2.0;
constexpr double beside_others_m = 0.05;  // beside the rooms of two people
constexpr double give_way_m = 0.05;       // so much nearer they come to get past a robot
constexpr int first_steps = 2;            // granted together: who walks one only shuffles
constexpr double samples_a_step = 3;
// Shoppers stand 12 s before what they buy (Dickson and Sawyer, "The Price Knowledge and Search of
// Supermarket Shoppers", Journal of Marketing 54, 1990).
constexpr double min_stay_s = 4, max_stay_s = 20;
constexpr double waiting_stay_s = 20;
constexpr double near_wish_m = 6, min_way_m = 0.8;
constexpr std::size_t near_wishes = 8, far_wishes = 6, max_refuges = 24;
constexpr double farther_m = 0.4;    // from the robot: worth turning round
constexpr int max_off_ways_mm = 60;  // corners are cut by less
// Who walks turns no faster than this, and so is slower at a sharp corner, but not slower than
// that.
constexpr double max_turn_rad_s = 2.8, min_corner_m_s = 0.3;

// From somebody's body there to the nearest of the discs.
double gap_m(Vec2 person, std::span<const FloorDisc> robot) {
  double gap = std::numeric_limits<double>::infinity();
  for (const FloorDisc& disc : robot)
    gap = std::min(gap, distance(person, disc.at) - disc.radius_m - person_radius_m);
  return gap;
}

// About all of the robot, with what people keep from it.
std::vector<navigation::DiscMm> room_of(std::span<const FloorDisc> robot) {
  if (robot.empty()) return {};
  Vec2 middle{};
  for (const FloorDisc& disc : robot)
    middle = middle + disc.at * (1.0 / static_cast<double>(robot.size()));
  double radius = 0;
  for (const FloorDisc& disc : robot)
    radius = std::max(radius, distance(middle, disc.at) + disc.radius_m);
  radius += person_radius_m + stop_before_robot_m;
  return {{floor_mm(middle), static_cast<int>(std::ceil(radius * 1e3))}};
}

// About each part of it, with what who squeezes past keeps from it; not those within another.
std::vector<navigation::DiscMm> parts_of(std::span<const FloorDisc> robot) {
  std::vector<navigation::DiscMm> parts;
  for (std::size_t i = 0; i < robot.size(); ++i) {
    const auto hides = [&](std::size_t other) {
      const double spare =
          robot[other].radius_m - robot[i].radius_m - distance(robot[i].at, robot[other].at);
      return other != i && (spare > 0 || (spare == 0 && other < i));
    };
    bool hidden = false;
    for (std::size_t other = 0; other < robot.size() && !hidden; ++other)
      hidden = hides(other);
    const double radius = robot[i].radius_m + person_radius_m + min_gap_m;
    if (!hidden)
      parts.push_back({floor_mm(robot[i].at), static_cast<int>(std::ceil(radius * 1e3))});
  }
  return parts;
}

double step_m(const collect::PersonAct& walk) {
  return walk.walk_m / walk.steps;
}

double end_s(const collect::PersonAct& act) {
  return act.begin_s + act.length_s;
}

}  // namespace

Result<PeopleAround> PeopleAround::make(const scene::Scene& scene,
                                        double per_m2,
                                        Seed seed,
                                        Vec2 robot) {
  PeopleAround around;
  const double wanted = per_m2 * collect::free_floor_m2(scene, person_height_m);
  const std::size_t count = std::min(static_cast<std::size_t>(wanted), max_count);
  if (count == 0) return around;
  MARKETGEN_TRY(collect::PeopleFloor floor, collect::people_floor(scene));
  MARKETGEN_TRY(navigation::FreeSpace sight, collect::open_floor(scene, person_height_m));
  auto company = std::make_shared<Company>(Company{std::move(floor), std::move(sight), {}, {}});
  for (std::size_t i = 0; i < count; ++i) {
    const Seed own = seed.child("person", i);
    collect::PersonRound who = collect::new_person(scene, static_cast<int>(i), own);
    Stream draw = own.child("begin").stream();
    std::vector<collect::StandingPlace> places = company->floor.shelves;
    draw.shuffle(std::span(places));
    const auto place = std::ranges::find_if(places, [&](const collect::StandingPlace& at) {
      if (distance(at.position, robot) <= clear_start_m) return false;
      for (std::size_t other = 0; other < around.walkers_.size(); ++other) {
        const Vec2 there = around.walkers_[other].now.walk.from.position;
        const double rooms = who.room_m + company->who[other].room_m + beside_others_m;
        if (distance(at.position, there) < rooms) return false;
      }
      return true;
    });
    if (place == places.end()) continue;
    Walker walker;
    walker.now.walk.from = *place;
    walker.now.walk.stay_s = draw.uniform(min_stay_s, max_stay_s);
    around.walkers_.push_back(std::move(walker));
    company->who.push_back(std::move(who));
    company->seeds.push_back(own);
  }
  around.company_ = std::move(company);
  around.know_acts();
  return around;
}

void PeopleAround::know_acts() {
  rounds_.clear();
  if (!company_) return;
  for (std::size_t i = 0; i < walkers_.size() && i < company_->who.size(); ++i) {
    rounds_.push_back(who(i));
    rounds_[i].acts = collect::acts_of_walk(walkers_[i].now.walk);
  }
}

void PeopleAround::begin(std::size_t person, collect::PersonWalk walk) {
  Walker& walker = walkers_[person];
  rounds_[person].acts = collect::acts_of_walk(walk);
  walker.now = {std::move(walk), 0};
  walker.granted = 0;
}

collect::StandingPlace PeopleAround::stands_at(std::size_t person) const {
  const assets::WayPlace at = collect::place_in_round(rounds_[person], walkers_[person].now.time_s);
  return {at.position, at.heading_rad};
}

Vec2 PeopleAround::place(std::size_t person) const {
  return stands_at(person).position;
}

// Where somebody is, and all along to the last step that they were granted, which is the last.
std::vector<Vec2> PeopleAround::held_by(std::size_t person) const {
  std::vector<Vec2> held{place(person)};
  const collect::PersonAct* walk = collect::walked_act(rounds_[person].acts);
  const Walker& walker = walkers_[person];
  if (walk == nullptr || walker.now.time_s >= end_s(*walk)) return held;
  const double piece = step_m(*walk) / samples_a_step, end = walker.granted * step_m(*walk);
  for (double s = collect::walked_in_act(*walk, walker.now.time_s) + piece; s < end; s += piece)
    held.push_back(walk->way->at(s).position);
  held.push_back(walk->way->at(end).position);
  return held;
}

// From the robot, on this walk.
double PeopleAround::keeps_m(std::size_t person) const {
  return walkers_[person].squeezes ? min_gap_m : stop_before_robot_m - give_way_m;
}

bool PeopleAround::may_step(std::size_t person, int step, Robot robot) const {
  const collect::PersonAct& walk = *collect::walked_act(rounds_[person].acts);
  const Vec2 here = place(person);
  const double gap_here = gap_m(here, robot);
  std::vector<Vec2> there;
  for (int i = 1; i <= samples_a_step; ++i)
    there.push_back(walk.way->at(step_m(walk) * (step - 1 + i / samples_a_step)).position);
  for (const Vec2 at : there) {
    const double gap = gap_m(at, robot);
    if (gap < std::min(keeps_m(person), gap_here - give_way_m)) return false;
    if (gap < std::min(min_gap_m, gap_here)) return false;
  }
  for (std::size_t other = 0; other < count(); ++other) {
    if (other == person) continue;
    const double rooms = who(person).room_m + who(other).room_m + beside_others_m;
    for (const Vec2 theirs : held_by(other))
      for (const Vec2 at : there)
        if (distance(at, theirs) < std::min(rooms, distance(here, theirs))) return false;
  }
  return true;
}

// False where not so many steps from the beginning are free; then no more than before are granted.
bool PeopleAround::grant(std::size_t person, int steps, Robot robot) {
  Walker& walker = walkers_[person];
  const int before = walker.granted;
  while (walker.granted < steps) {
    if (!may_step(person, walker.granted + 1, robot)) {
      walker.granted = before;
      return false;
    }
    ++walker.granted;
  }
  return true;
}

void PeopleAround::cut(std::size_t person, int steps) {
  Walker& walker = walkers_[person];
  walker.granted = steps;
  walker.now.walk.steps_cut = steps;
  walker.now.walk.stay_s = waiting_stay_s;
  rounds_[person].acts = collect::acts_of_walk(walker.now.walk);
}

// Whether time may go on to `to_s`, within the walk. Where no further step is granted in time to
// stop before it, the walk ends with the last that was; where the robot has come to where steps
// were granted, as soon as may be; and where that is too late, they stand still in their stride.
bool PeopleAround::walk_on(std::size_t person,
                           const collect::PersonAct& walk,
                           double to_s,
                           Robot robot) {
  Walker& walker = walkers_[person];
  if (walker.granted == 0) return grant(person, std::min(first_steps, walk.steps), robot);
  const double to_m = collect::walked_in_act(walk, to_s), step = step_m(walk);
  const double gap_here = gap_m(place(person), robot);
  if (gap_m(walk.way->at(to_m).position, robot) < std::min(min_gap_m, gap_here)) return false;
  const double stands_m = to_m + collect::stopping_m(walker.now.walk.speed_m_s);
  const int soonest = std::min(walk.steps, static_cast<int>(std::ceil(stands_m / step)));
  if (!grant(person, soonest, robot)) {
    cut(person, walker.granted);
    return true;
  }
  const int last = std::max(soonest, first_steps);
  if (last >= walker.granted || walker.now.walk.steps_cut == walker.granted) return true;
  const double gap_there = gap_m(walk.way->at(step * walker.granted).position, robot);
  if (gap_there < std::min(keeps_m(person), gap_here - give_way_m)) cut(person, last);
  return true;
}

// Of who stands where their walk led. Who looked for a way in vain stands until they look again.
bool PeopleAround::has_stood_enough(std::size_t person, double dt_s, Robot robot) {
  Walker& walker = walkers_[person];
  const bool waits = walker.now.walk.steps_cut > 0 || walker.found_none;
  const bool is_asked = gap_m(place(person), robot) < asks_for_room_m;
  walker.stopped_s = waits || is_asked ? walker.stopped_s + dt_s : 0;
  const bool is_over = walker.now.time_s >= end_s(rounds_[person].acts.back());
  return is_over || (walker.stopped_s > patience_s && !walker.found_none);
}

// Those who are farther may have gone when the person comes there.
PeopleAround::Discs PeopleAround::others_in_the_way(std::size_t person) const {
  Discs discs;
  const Vec2 here = place(person);
  for (std::size_t other = 0; other < count(); ++other) {
    if (other == person || distance(place(other), here) > near_wish_m) continue;
    const double rooms = who(person).room_m + who(other).room_m + beside_others_m;
    discs.push_back({floor_mm(held_by(other).back()), static_cast<int>(std::ceil(rooms * 1e3))});
  }
  return discs;
}

std::optional<collect::PersonWalk> PeopleAround::walk_to(std::size_t person,
                                                         const collect::StandingPlace& to,
                                                         const Discs& past,
                                                         double stay_s) const {
  const navigation::VisibilityGraph& ways = company_->floor.graph;
  collect::PersonWalk walk{.from = stands_at(person), .heading_rad = to.heading_rad};
  const PointMm here = floor_mm(walk.from.position);
  const PointMm from = ways.space().nearest_free(here, max_off_ways_mm);
  auto path = ways.shortest_path_past(from, floor_mm(to.position), past);
  if (!path.ok() || path->length_m < min_way_m) return {};
  walk.points = std::move(path->points);
  walk.points.front() = here;
  const double own_m_s = company_->seeds[person].child("speed").stream().uniform(
      collect::min_walk_m_s, collect::max_walk_m_s);
  const collect::FloorWay way({walk.points, 0}, collect::WayTurning::even);
  const double corner_m_s = max_turn_rad_s / std::max(way.sharpest_rad_m(), 1e-3);
  walk.speed_m_s = std::min(own_m_s, std::max(corner_m_s, min_corner_m_s));
  walk.stay_s = stay_s;
  return walk;
}

// First where they were going; then what is near, which who looks for something looks at next.
std::vector<collect::StandingPlace> PeopleAround::wishes(std::size_t person, Stream& draw) const {
  std::vector<collect::StandingPlace> wished;
  const collect::PersonWalk& walk = walkers_[person].now.walk;
  const Vec2 here = place(person);
  if (walk.steps_cut > 0)
    wished.push_back(
        {{walk.points.back()[0] * 1e-3, walk.points.back()[1] * 1e-3}, walk.heading_rad});
  std::vector<collect::StandingPlace> places = company_->floor.shelves;
  draw.shuffle(std::span(places));
  const auto take = [&](std::size_t count, bool near) {
    for (const collect::StandingPlace& place : places) {
      if (count == 0) return;
      if ((distance(place.position, here) < near_wish_m) != near) continue;
      wished.push_back(place);
      --count;
    }
  };
  take(near_wishes, true);
  take(far_wishes, false);
  return wished;
}

// Those who are farther off from the robot, the nearest first; above them those to which it does
// not come too near.
std::vector<collect::StandingPlace> PeopleAround::refuges(std::size_t person, Robot robot) const {
  const Vec2 here = place(person);
  const double gap_here = gap_m(here, robot);
  std::vector<collect::StandingPlace> places;
  for (const collect::StandingPlace& place : company_->floor.shelves)
    if (gap_m(place.position, robot) > gap_here + farther_m) places.push_back(place);
  std::ranges::stable_sort(places, {}, [&](const collect::StandingPlace& place) {
    const bool too_near = gap_m(place.position, robot) < asks_for_room_m;
    return std::pair(too_near, distance(place.position, here));
  });
  places.resize(std::min(places.size(), max_refuges));
  return places;
}

bool PeopleAround::goes_to(std::size_t person,
                           const collect::StandingPlace& to,
                           const Discs& past,
                           double stay_s,
                           Robot robot) {
  auto walk = walk_to(person, to, past, stay_s);
  if (!walk) return false;
  begin(person, std::move(*walk));
  // Steps that the robot itself allows: as a disc it may leave more room than it does.
  const int steps = std::min(first_steps, collect::walked_act(rounds_[person].acts)->steps);
  if (!grant(person, steps, robot)) return false;
  ++walkers_[person].walks;
  return true;
}

bool PeopleAround::goes_elsewhere(std::size_t person, Stream& draw, Robot robot) {
  Discs past = others_in_the_way(person);
  const Discs room = room_of(robot);
  past.insert(past.end(), room.begin(), room.end());
  const double stay_s = draw.uniform(min_stay_s, max_stay_s);
  return std::ranges::any_of(wishes(person, draw), [&](const collect::StandingPlace& wish) {
    return gap_m(wish.position, robot) >= asks_for_room_m &&
           goes_to(person, wish, past, stay_s, robot);
  });
}

// Of who found no way: past the robot, nearer than they like, or away from it.
bool PeopleAround::gets_away(std::size_t person, Stream& draw, Robot robot) {
  Discs past = others_in_the_way(person);
  const Discs parts = parts_of(robot);
  past.insert(past.end(), parts.begin(), parts.end());
  const double stay_s = draw.uniform(min_stay_s, max_stay_s);
  walkers_[person].squeezes = true;
  return std::ranges::any_of(refuges(person, robot), [&](const collect::StandingPlace& to) {
    return goes_to(person, to, past, stay_s, robot);
  });
}

void PeopleAround::decide(std::size_t person, Robot robot) {
  Walker& walker = walkers_[person];
  Stream draw = company_->seeds[person].child("decision", walker.decisions++).stream();
  walker.squeezes = false;
  const bool goes =
      goes_elsewhere(person, draw, robot) || (walker.found_none && gets_away(person, draw, robot));
  walker.found_none = !goes;
  if (goes) {
    walker.stopped_s = 0;
    return;
  }
  collect::PersonWalk stays{.from = stands_at(person)};
  stays.stay_s = looks_again_s;
  begin(person, std::move(stays));
}

void PeopleAround::pass(double dt_s, Robot robot) {
  for (std::size_t i = 0; i < count(); ++i) {
    Walker& walker = walkers_[i];
    const Vec2 from = place(i);
    const collect::PersonAct* walk = collect::walked_act(rounds_[i].acts);
    const double next = walker.now.time_s + dt_s;
    const bool before_end = walk != nullptr && walker.now.time_s < end_s(*walk);
    if (before_end && next > walk->begin_s) {
      if (walk_on(i, *walk, next, robot)) {
        walker.now.time_s = next;
      } else {  // they stand there, turned to their way when they have not begun
        if (walker.granted == 0) walker.now.time_s = walk->begin_s;
        walker.stopped_s += dt_s;
        if (walker.stopped_s > patience_s) decide(i, robot);
      }
    } else {
      walker.now.time_s = next;
      const bool stands = next >= rounds_[i].acts.back().begin_s;
      if (stands && has_stood_enough(i, dt_s, robot)) decide(i, robot);
    }
    walker.speed_m_s = distance(from, place(i)) / dt_s;
  }
}

bool PeopleAround::sees(Vec2 from, std::size_t person) const {
  return company_->sight.sees(floor_mm(from), floor_mm(place(person)));
}

std::vector<PersonMoment> PeopleAround::moments() const {
  std::vector<PersonMoment> moments;
  for (const Walker& walker : walkers_)
    moments.push_back(walker.now);
  return moments;
}

Pose PeopleAround::store_from_person(std::size_t person) const {
  const collect::StandingPlace at = stands_at(person);
  return {{at.position.x, at.position.y, 0}, rotation_about({0, 0, 1}, at.heading_rad)};
}

assets::PlacedPerson PeopleAround::at(std::size_t person, const PersonMoment& moment) const {
  collect::PersonRound round = who(person);
  round.acts = collect::acts_of_walk(moment.walk);
  return collect::placed_in_round(round, moment.time_s);
}

}  // namespace marketgen::episodes
