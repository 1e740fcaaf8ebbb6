#include "collect/person_round.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>
#include <utility>

#include "assets/print/color.h"
#include "collect/drive_graph.h"

namespace marketgen::collect {
namespace {

constexpr double floor_room_m = 0.52;  // from a person's middle to whatever stands on the floor
constexpr double person_height_m = 2.0;
constexpr double empty_handed_m = 0.40, basket_room_m = 0.50, carrying_m = 0.48;
constexpr double shelf_distance_m = 0.58, farther_m = 0.12;  // from a shelf's edge
constexpr int distances = 3;
constexpr double speed_up_s = 0.6;
constexpr double turn_piece_rad = 1.05, turn_piece_s = 0.75;
constexpr double min_stay_s = 5;
constexpr double min_way_m = 0.8, next_stop_m = 6;
constexpr double pi = std::numbers::pi;

bool is_free(const navigation::VisibilityGraph& graph, Vec2 at) {
  return graph.space().on_floor(floor_mm(at)) && graph.space().free(floor_mm(at));
}

// Before the middle of a shelf and to both sides of it.
void add_places_before(const scene::Scene& scene,
                       std::uint32_t shelf,
                       const navigation::VisibilityGraph& graph,
                       std::vector<StandingPlace>& places) {
  const Pose pose = scene::world_from_shelf(scene, shelf);
  const Vec3 inward = rotate(pose.rotation, {0, 1, 0});
  const double heading = std::atan2(inward.y, inward.x);
  const double half = scene.shelves[shelf].width_m / 2;
  for (const double aside : {0.0, -0.6 * half, 0.6 * half}) {
    for (int i = 0; i < distances; ++i) {
      const Vec3 at = pose * Vec3{aside, -shelf_distance_m - farther_m * i, 0};
      if (!is_free(graph, {at.x, at.y})) continue;
      places.push_back({{at.x, at.y}, heading});
      break;
    }
  }
}

// One with a belt: where somebody of the staff is.
bool is_till(const scene::Scene& scene, std::uint32_t fixture) {
  return std::ranges::any_of(scene.joints, [&](const scene::SceneJoint& joint) {
    return joint.fixture == fixture && joint.kind == assets::JointKind::belt;
  });
}

void add_places_beside(const RectMm& till,
                       const navigation::VisibilityGraph& graph,
                       std::vector<StandingPlace>& places) {
  const double x = till.center()[0] * 1e-3, y = till.center()[1] * 1e-3;
  const double dx = till.width() * 5e-4 + shelf_distance_m;
  const double dy = till.depth() * 5e-4 + shelf_distance_m;
  for (const StandingPlace& place : {StandingPlace{{x, y + dy}, -pi / 2},
                                     StandingPlace{{x, y - dy}, pi / 2},
                                     StandingPlace{{x - dx, y}, 0},
                                     StandingPlace{{x + dx, y}, pi}}) {
    if (is_free(graph, place.position)) places.push_back(place);
  }
}

// Acts one after another.
class RoundWriter {
 public:
  void stand(const StandingPlace& at, double length_s) {
    add({now_, length_s, at.position, at.heading_rad, 0});
  }
  void turn(Vec2 at, double from_rad, double to_rad) {
    const double whole = std::remainder(to_rad - from_rad, 2 * pi);
    const int pieces = static_cast<int>(std::ceil(std::abs(whole) / turn_piece_rad));
    for (int i = 0; i < pieces; ++i)
      add({now_, turn_piece_s, at, from_rad + whole * i / pieces, whole / pieces});
  }
  // All of it, or so many steps.
  void walk(const std::shared_ptr<const FloorWay>& way, double speed_m_s, int steps_cut = 0) {
    const int all = std::max(
        1, static_cast<int>(std::lround(way->length_m() / assets::step_length_m(speed_m_s))));
    PersonAct act;
    act.begin_s = now_;
    act.way = way;
    act.steps = steps_cut > 0 ? std::min(steps_cut, all) : all;
    act.walk_m = act.steps == all ? way->length_m() : way->length_m() * act.steps / all;
    const double even_s = act.walk_m / speed_m_s;
    act.length_s = even_s + std::min(speed_up_s, even_s);
    add(std::move(act));
  }
  double now() const { return now_; }
  // Of the last act, a walk.
  assets::WayPlace walked_to() const { return acts_.back().way->at(acts_.back().walk_m); }
  std::vector<PersonAct> acts() { return std::move(acts_); }

 private:
  void add(PersonAct act) {
    now_ += act.length_s;
    acts_.push_back(std::move(act));
  }
  std::vector<PersonAct> acts_;
  double now_ = 0;
};

using Ways = std::vector<std::shared_ptr<const FloorWay>>;

// From each stop to the next, and from the last to the first.
std::optional<Ways> ways_between(const PeopleFloor& floor,
                                 const std::vector<StandingPlace>& stops) {
  Ways ways;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const PointMm from = floor_mm(stops[i].position);
    const PointMm to = floor_mm(stops[(i + 1) % stops.size()].position);
    if (from == to) return {};
    auto path = floor.graph.shortest_path(from, to);
    if (!path.ok()) return {};
    ways.push_back(std::make_shared<const FloorWay>(path.value()));
  }
  return ways;
}

// One after another not far away: who looks for something looks about there.
std::vector<StandingPlace> draw_stops(const std::vector<StandingPlace>& places,
                                      int count,
                                      Stream& draw) {
  const auto any = [&](const std::vector<StandingPlace>& from) {
    return from[static_cast<std::size_t>(draw.integer(0, static_cast<int>(from.size()) - 1))];
  };
  std::vector<StandingPlace> stops{any(places)};
  while (static_cast<int>(stops.size()) < count) {
    const Vec2 last = stops.back().position;
    std::vector<StandingPlace> near;
    std::copy_if(
        places.begin(), places.end(), std::back_inserter(near), [&](const StandingPlace& place) {
          const double away = distance(place.position, last);
          return away > min_way_m && away < next_stop_m;
        });
    stops.push_back(any(near.empty() ? places : near));
  }
  return stops;
}

std::vector<PersonAct> write_round(const std::vector<StandingPlace>& stops,
                                   const Ways& ways,
                                   double speed_m_s,
                                   double stay_s) {
  RoundWriter writer;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const StandingPlace& next = stops[(i + 1) % stops.size()];
    const FloorWay& way = *ways[i];
    writer.stand(stops[i], stay_s);
    writer.turn(stops[i].position, stops[i].heading_rad, way.at(0).heading_rad);
    writer.walk(ways[i], speed_m_s);
    writer.turn(next.position, way.at(way.length_m()).heading_rad, next.heading_rad);
  }
  return writer.acts();
}

double end_of(const std::vector<PersonAct>& acts) {
  return acts.back().begin_s + acts.back().length_s;
}

const PersonAct& act_at(const PersonRound& person, double time_s) {
  const auto next = std::upper_bound(
      person.acts.begin() + 1, person.acts.end(), time_s, [](double t, const PersonAct& act) {
        return t < act.begin_s;
      });
  return *(next - 1);
}

double turned_share(const PersonAct& act, double time_s) {
  return std::clamp((time_s - act.begin_s) / act.length_s, 0.0, 1.0);
}

}  // namespace

Result<PeopleFloor> people_floor(const scene::Scene& scene) {
  MARKETGEN_TRY(navigation::VisibilityGraph graph,
                drive_graph(scene, {floor_room_m, person_height_m}, {}, 0));
  PeopleFloor floor{std::move(graph), {}, {}};
  std::set<std::pair<std::uint32_t, std::int32_t>> seen;
  for (std::uint32_t s = 0; s < scene.shelves.size(); ++s) {
    const scene::SceneShelf& shelf = scene.shelves[s];
    if (seen.insert({shelf.fixture, shelf.side}).second)
      add_places_before(scene, s, floor.graph, floor.shelves);
  }
  for (std::uint32_t f = 0; f < scene.fixtures.size(); ++f) {
    if (is_till(scene, f))
      add_places_beside(layout::footprint_of(scene.layout.fixtures[f]), floor.graph, floor.tills);
  }
  return floor;
}

PersonRound new_person(const scene::Scene& scene, int number, Seed seed) {
  constexpr int staff_every = 5, first_staff = 2;
  const bool staff = number % staff_every == first_staff;
  const auto accent = assets::linear_from_hex(scene.layout.look.accent);
  PersonRound person;
  person.look = assets::draw_person(staff ? assets::PersonRole::staff : assets::PersonRole::shopper,
                                    accent.ok() ? accent.value() : Vec3f{0.03F, 0.2F, 0.04F},
                                    seed.child("look"));
  Stream draw = seed.child("habit").stream();
  person.basket = !staff && draw.chance(0.55);
  person.carries = staff && draw.chance(0.6);
  person.head_down_rad = draw.uniform(0.05, 0.40);
  person.head_left_rad = draw.uniform(-0.25, 0.25);
  person.room_m = person.carries ? carrying_m : person.basket ? basket_room_m : empty_handed_m;
  return person;
}

std::optional<std::vector<PersonAct>> draw_acts(const PeopleFloor& floor,
                                                const PersonRound& person,
                                                bool walks,
                                                Stream& draw) {
  const bool at_till = person.look.role == assets::PersonRole::staff && !person.carries;
  const std::vector<StandingPlace>& places =
      at_till && !floor.tills.empty() ? floor.tills : floor.shelves;
  if (places.empty()) return {};
  const int count = walks ? draw.integer(2, 4) : 1;
  const double speed = draw.uniform(min_walk_m_s, max_walk_m_s);
  const std::vector<StandingPlace> stops = draw_stops(places, count, draw);
  if (!walks) return acts_of_standing(stops[0]);
  const std::optional<Ways> ways = ways_between(floor, stops);
  if (!ways) return {};
  const double busy_s = end_of(write_round(stops, *ways, speed, 0));
  const double stay_s = (round_s - busy_s) / count;
  if (stay_s < min_stay_s) return {};
  return write_round(stops, *ways, speed, stay_s);
}

std::vector<PersonAct> acts_of_walk(const PersonWalk& walk) {
  RoundWriter writer;
  if (walk.walks()) {
    const auto way =
        std::make_shared<const FloorWay>(navigation::FloorPath{walk.points, 0}, WayTurning::even);
    writer.turn(walk.from.position, walk.from.heading_rad, way->at(0).heading_rad);
    writer.walk(way, walk.speed_m_s, walk.steps_cut);
    const assets::WayPlace end = writer.walked_to();
    const double heading = walk.steps_cut > 0 ? end.heading_rad : walk.heading_rad;
    writer.turn(end.position, end.heading_rad, heading);
    writer.stand({end.position, heading}, walk.stay_s);
  } else {
    writer.stand(walk.from, walk.stay_s);
  }
  return writer.acts();
}

// Even speed between speeding up and slowing down.
double walked_in_act(const PersonAct& act, double time_s) {
  const double length = act.walk_m, ramp = std::min(speed_up_s, act.length_s / 2);
  const double speed = length / (act.length_s - ramp);
  const double t = std::clamp(time_s - act.begin_s, 0.0, act.length_s), left = act.length_s - t;
  if (t < ramp) return speed * t * t / (2 * ramp);
  if (left < ramp) return length - speed * left * left / (2 * ramp);
  return speed * (t - ramp / 2);
}

const PersonAct* walked_act(const std::vector<PersonAct>& acts) {
  const auto found =
      std::ranges::find_if(acts, [](const PersonAct& act) { return act.way != nullptr; });
  return found == acts.end() ? nullptr : &*found;
}

double stopping_m(double speed_m_s) {
  return speed_m_s * speed_up_s / 2;
}

std::vector<PersonAct> acts_of_standing(const StandingPlace& place) {
  return {{0, round_s, place.position, place.heading_rad, 0}};
}

assets::WayPlace place_in_round(const PersonRound& person, double time_s) {
  const PersonAct& act = act_at(person, time_s);
  if (act.way) return act.way->at(walked_in_act(act, time_s));
  const double turned =
      act.turn_rad == 0 ? 0 : assets::turned_rad(act.turn_rad, turned_share(act, time_s));
  return {act.position, act.heading_rad + turned};
}

double room_in_round(const PersonRound& person, double time_s) {
  // The foot ahead strikes 0.62 of a step before the body and reaches past its ankle.
  constexpr double share_of_step = 0.62, past_ankle_m = 0.23;
  const PersonAct& act = act_at(person, time_s);
  if (!act.way) return person.room_m;
  return std::max(person.room_m, share_of_step * act.walk_m / act.steps + past_ankle_m);
}

assets::PersonPose pose_in_round(const PersonRound& person, double time_s) {
  const PersonAct& act = act_at(person, time_s);
  const assets::PersonLook& look = person.look;
  assets::PersonPose pose = assets::standing_pose(look);
  if (act.way) {
    const FloorWay& way = *act.way;
    pose = assets::walking_pose(
        look,
        [&way](double s) { return way.at(s); },
        act.walk_m,
        act.steps,
        walked_in_act(act, time_s));
  } else if (act.turn_rad != 0) {
    pose = assets::turning_pose(look, act.turn_rad, turned_share(act, time_s));
  } else {  // looking along the goods, and back where it began when the stay ends
    const double share = turned_share(act, time_s);
    const double calm = std::min({1.0, share * act.length_s, (1 - share) * act.length_s});
    pose.head_down_rad = calm * person.head_down_rad;
    pose.head_left_rad = calm * person.head_left_rad * std::cos(6 * pi * share);
  }
  // Who never walks off may hold a hand before the belly.
  if (person.acts.size() == 1 && act.length_s == round_s && person.head_left_rad > 0)
    pose.arms[0] = assets::ArmUse::rest;
  if (person.basket) pose.arms[1] = assets::ArmUse::basket;
  if (person.carries) pose.arms = {assets::ArmUse::carry, assets::ArmUse::carry};
  return pose;
}

assets::PlacedPerson placed_in_round(const PersonRound& person, double time_s) {
  const assets::WayPlace place = place_in_round(person, time_s);
  return {person.look,
          pose_in_round(person, time_s),
          {{place.position.x, place.position.y, 0}, rotation_about({0, 0, 1}, place.heading_rad)}};
}

}  // namespace marketgen::collect
