// The shopper's way: in at the entrance, to a till from the shop's side, past it, out at the exit.
#pragma once
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "layout/layout.h"
#include "navigation/occupancy.h"

namespace marketgen::layout {

struct Route {
  std::vector<navigation::GridPath>
      legs;  // entrance to the queue before a till, past the till, to the exit
  bool complete = false;
};

// On a 100 mm grid for a person with a basket.
Route shopper_route(const Layout& layout, const catalog::Catalog& catalog);

// Where shoppers come to a till from the shop, and where they stand to pay.
struct PayingPlace {
  PointMm queue, till;
  std::string fixture;  // id of the till
  RectMm floor;         // where they stand to pay: a lane's passage, or what lies before a machine
};
std::vector<PayingPlace> paying_places(const Layout& layout, const catalog::Catalog& catalog);

}  // namespace marketgen::layout
