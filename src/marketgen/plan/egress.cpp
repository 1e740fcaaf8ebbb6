#include "plan/egress.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "plan/bsp.h"
#include "plan/floor_places.h"

namespace marketgen::plan {
namespace {

constexpr double m2_per_person = 5.574;  // 60 sq ft
constexpr int door_margin_mm = 600;      // wall beside a door, and to a corner
constexpr int landing_mm = 2000;         // floor inside it (layout/floor.h)
constexpr int step_mm = 500;             // along a wall
constexpr std::array<Wall, 4> walls{Wall::north, Wall::east, Wall::west, Wall::south};

int length_of(Wall wall, const Shell& shell) {
  return runs_east(wall) ? shell.width_mm : shell.depth_mm;
}

// The floor that people cross inside the opening, a margin on either side.
RectMm landing_of(const Opening& opening, const Shell& shell, int deep_mm) {
  const RectMm bounds = shell_rect(shell);
  const PointMm at = point_inside(bounds, opening, 0);
  const int half = opening.width_mm / 2 + door_margin_mm;
  switch (opening.wall) {
    case Wall::north:
      return {at[0] - half, bounds.y1 - deep_mm, at[0] + half, bounds.y1};
    case Wall::south:
      return {at[0] - half, bounds.y0, at[0] + half, bounds.y0 + deep_mm};
    case Wall::east:
      return {bounds.x1 - deep_mm, at[1] - half, bounds.x1, at[1] + half};
    case Wall::west:
      break;
  }
  return {bounds.x0, at[1] - half, bounds.x0 + deep_mm, at[1] + half};
}

// All of the landing is floor, which no other opening, column or corner of a wall takes part of.
bool is_free(const Opening& door, const Shell& shell) {
  const RectMm landing = landing_of(door, shell, landing_mm);
  if (!shell_rect(shell).contains(landing)) return false;
  const PolygonMm floor = floor_of(shell);
  const RectMm inside = landing.grown(-1);
  const auto is_floor = [&](PointMm corner) { return contains(floor, corner); };
  const auto in_landing = [&](PointMm corner) { return inside.contains(corner); };
  if (!std::ranges::all_of(polygon_of(inside), is_floor) || std::ranges::any_of(floor, in_landing))
    return false;
  const auto in_the_way = [&](const Opening& other) {
    return other.wall == door.wall &&
           overlap(landing_of(other, shell, 1), landing_of(door, shell, 1));
  };
  if (std::ranges::any_of(shell.openings, in_the_way)) return false;
  return std::ranges::none_of(
      shell.columns, [&](const Column& column) { return overlap(footprint_of(column), landing); });
}

double nearest_way_out_mm(const Opening& door, const Shell& shell) {
  const RectMm bounds = shell_rect(shell);
  const PointMm at = point_inside(bounds, door, 0);
  double nearest = std::hypot(bounds.width(), bounds.depth());
  for (const Opening& other : shell.openings) {
    if (!leads_outside(other)) continue;
    const PointMm there = point_inside(bounds, other, 0);
    nearest = std::min(nearest, std::hypot(at[0] - there[0], at[1] - there[1]));
  }
  return nearest;
}

std::string unused_id(const Shell& shell) {
  const std::string wanted(name_of(OpeningKind::emergency));
  const auto taken = [&](const std::string& id) {
    return std::ranges::find(shell.openings, id, &Opening::id) != shell.openings.end();
  };
  std::string id = wanted;
  for (int number = 2; taken(id); ++number)
    id = wanted + "-" + std::to_string(number);
  return id;
}

std::optional<Opening> farthest_exit(const Shell& shell) {
  std::optional<Opening> best;
  double best_mm = 0;
  for (const Wall wall : walls) {
    const int length = length_of(wall, shell);
    for (int at = step_mm; at < length; at += step_mm) {
      Opening door{"", OpeningKind::emergency, wall, 0, emergency_door_mm};
      door.center = std::round(1e4 * at / length) * 1e-4;
      const double away_mm = nearest_way_out_mm(door, shell);
      if (away_mm <= best_mm || !is_free(door, shell)) continue;
      best = door;
      best_mm = away_mm;
    }
  }
  if (best) best->id = unused_id(shell);
  return best;
}

}  // namespace

bool leads_outside(const Opening& opening) {
  return opening.kind == OpeningKind::entrance || opening.kind == OpeningKind::exit ||
         opening.kind == OpeningKind::emergency;
}

double people_on(double floor_m2) {
  return floor_m2 / m2_per_person;
}

int doors_for(double people) {
  constexpr double one = 49, two = 500, three = 1000;
  if (people <= one) return 1;
  if (people <= two) return 2;
  return people <= three ? 3 : 4;
}

WaysOut ways_out(const Shell& shell) {
  WaysOut ways;
  ways.people = people_on(area_m2(floor_of(shell)));
  for (const Opening& opening : shell.openings) {
    if (!leads_outside(opening)) continue;
    ++ways.doors;
    ways.width_mm += opening.width_mm;
  }
  return ways;
}

std::vector<Opening> lacking_exits(const Shell& shell) {
  Shell with_exits = shell;
  std::vector<Opening> exits;
  for (WaysOut ways = ways_out(shell);
       ways.doors < ways.needed_doors() || ways.width_mm < ways.needed_width_mm();
       ways = ways_out(with_exits)) {
    const auto exit = farthest_exit(with_exits);
    if (!exit) break;
    exits.push_back(*exit);
    with_exits.openings.push_back(*exit);
  }
  return exits;
}

}  // namespace marketgen::plan
