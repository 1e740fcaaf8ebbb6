// A floor of 20 x 10 m with zones whose relations are known; the diagonal is 22.36 m.
//
//   north wall:  dairy at x = 12-20, y = 8.5-10
//   middle:      canned x = 2-8, y = 4-8; frozen x = 9-11, y = 4-6
//   south wall:  produce x = 0-4, bakery x = 5-8, snacks x = 8-9 (all y = 0-3),
//                checkout x = 14-19, y = 0-2
//   entrance at x = 4, exit at x = 16, both in the south wall
#pragma once
#include <vector>

#include "plan/floor_places.h"

namespace marketgen {

struct NamedShop {
  std::vector<plan::Opening> openings{
      {"entrance", plan::OpeningKind::entrance, plan::Wall::south, 0.2, 2000},
      {"way-out", plan::OpeningKind::exit, plan::Wall::south, 0.8, 2000}};
  std::vector<plan::PlacedZone> zones{{"produce", "produce", {0, 0, 4000, 3000}},
                                      {"bakery", "bakery", {5000, 0, 8000, 3000}},
                                      {"snacks", "snacks", {8000, 0, 9000, 3000}},
                                      {"checkout", "checkout", {14000, 0, 19000, 2000}},
                                      {"canned", "canned", {2000, 4000, 8000, 8000}},
                                      {"frozen", "frozen", {9000, 4000, 11000, 6000}},
                                      {"dairy", "dairy", {12000, 8500, 20000, 10000}}};

  plan::NamedFloor floor() const { return {{0, 0, 20000, 10000}, openings, zones}; }
};

}  // namespace marketgen
