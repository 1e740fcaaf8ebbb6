// The checkout lanes of a store: at which of them Checkout Unloading can happen, and how its
// station stands there.
//
// The robot's counter takes the lane's place. It stands where the cashier sat, and the lane's belt
// brings the goods (assets/fixtures/checkout_lane.cpp says from where): the station's X is over the
// counter to the shoppers' passage, its Y along the belt against the goods' way. Counter and lane
// have one middle.
#pragma once
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "episodes/checkout/checkout_station.h"
#include "episodes/episode_spec.h"
#include "scene/scene.h"

namespace marketgen::episodes {

struct StationPlace {
  Vec3 origin;            // of the station frame, on the floor; store frame
  int quarter_turns = 0;  // yaw / 90
};
StationPlace place_at_lane(const CheckoutStation& station, const layout::Fixture& lane);

struct CheckoutLanes {
  std::vector<std::string> suited;  // ids of fixtures, in the layout's order
  std::vector<LaneExclusion> left_out;
};
// A lane suits when nothing but itself stands where the arm may come to: no part of another
// fixture, no wall and no column.
CheckoutLanes checkout_lanes(const scene::Scene& store,
                             const catalog::Catalog& catalog,
                             const CheckoutStation& station);

// The episode at one of the suited lanes, drawn from its own seed; in a room of its own when there
// is none. All else of it stays.
EpisodeSpec at_a_lane(EpisodeSpec spec, const CheckoutLanes& lanes);

}  // namespace marketgen::episodes
