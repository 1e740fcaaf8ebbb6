// How people walk: where their feet and arms are after so many metres of a way.
//
// A foot that stands does not move in the store, on curves either: footprints lie at equal steps of
// the way, and between two of them the foot swings. The share of stance (62 %) and the feet's
// angles at heel strike and toe-off are those of normal gait (Perry and Burnfield, "Gait Analysis",
// 2010); step lengths follow the walk ratio of adults, 0.0065 m per step a minute (Sekiya and
// Nagasaki 1998).
#pragma once
#include <functional>

#include "assets/people/person.h"

namespace marketgen::assets {

struct WayPlace {
  Vec2 position;           // store frame, metres
  double heading_rad = 0;  // about Z from X
};
// Somebody's way over the floor by metres walked, without a corner.
using Way = std::function<WayPlace(double)>;

// The usual length of a step at a speed, metres.
double step_length_m(double speed_m_s);

// After `walked_m` of `length_m`, in so many steps (one at least); standing at both ends.
PersonPose walking_pose(
    const PersonLook& look, const Way& way, double length_m, int steps, double walked_m);

// Turning on the spot by `turn_rad` (left is more than 0, half a turn at most): after the share
// `done`, 0 to 1. The person frame has turned by turned_rad() of it.
PersonPose turning_pose(const PersonLook& look, double turn_rad, double done);
double turned_rad(double turn_rad, double done);

}  // namespace marketgen::assets
