#include "plan/floor_places.h"

#include <cmath>

namespace marketgen::plan {
namespace {

RectMm wall_strip(const RectMm& floor, Wall wall) {
  switch (wall) {
    case Wall::north:
      return {floor.x0, floor.y1 - wall_strip_mm, floor.x1, floor.y1};
    case Wall::south:
      return {floor.x0, floor.y0, floor.x1, floor.y0 + wall_strip_mm};
    case Wall::east:
      return {floor.x1 - wall_strip_mm, floor.y0, floor.x1, floor.y1};
    case Wall::west:
      break;
  }
  return {floor.x0, floor.y0, floor.x0 + wall_strip_mm, floor.y1};
}

RectMm middle_third(const RectMm& floor) {
  return {floor.x0 + floor.width() / 3,
          floor.y0 + floor.depth() / 3,
          floor.x0 + floor.width() * 2 / 3,
          floor.y0 + floor.depth() * 2 / 3};
}

RectMm doorstep(const RectMm& floor, const Opening& opening) {
  const PointMm p = point_inside(floor, opening, doorstep_mm / 2);
  return RectMm{p[0], p[1], p[0], p[1]}.grown(doorstep_mm / 2);
}

bool goes_by(const PlacedZone& zone, std::string_view name) {
  const bool till = name == "checkout" && zone.type == "self_checkout";
  return zone.id == name || zone.type == name || till;
}

}  // namespace

std::vector<NamedPlace> places_named(const NamedFloor& floor, std::string_view name) {
  std::vector<NamedPlace> places;
  if (const auto wall = value_named<Wall>(name))
    places.push_back({PlaceKind::wall, wall_strip(floor.bounds, *wall)});
  if (name == "center") places.push_back({PlaceKind::middle, middle_third(floor.bounds)});
  for (const PlacedZone& zone : floor.zones) {
    if (goes_by(zone, name) && !zone.rect.empty()) places.push_back({PlaceKind::zone, zone.rect});
  }
  for (const Opening& opening : floor.openings) {
    if (opening.id == name || name_of(opening.kind) == name)
      places.push_back({PlaceKind::opening, doorstep(floor.bounds, opening)});
  }
  return places;
}

PointMm inward_from(Wall wall) {
  switch (wall) {
    case Wall::north:
      return {0, -1};
    case Wall::east:
      return {-1, 0};
    case Wall::west:
      return {1, 0};
    case Wall::south:
      break;
  }
  return {0, 1};
}

bool runs_east(Wall wall) {
  return wall == Wall::north || wall == Wall::south;
}

PointMm point_inside(const RectMm& bounds, const Opening& opening, int by_mm) {
  const auto along = [&](int length) {
    return static_cast<int>(std::lround(opening.center * length));
  };
  switch (opening.wall) {
    case Wall::north:
      return {bounds.x0 + along(bounds.width()), bounds.y1 - by_mm};
    case Wall::south:
      return {bounds.x0 + along(bounds.width()), bounds.y0 + by_mm};
    case Wall::east:
      return {bounds.x1 - by_mm, bounds.y0 + along(bounds.depth())};
    case Wall::west:
      break;
  }
  return {bounds.x0 + by_mm, bounds.y0 + along(bounds.depth())};
}

}  // namespace marketgen::plan
