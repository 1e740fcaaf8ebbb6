// On from where people hold a base up: round them, or out of their way and back, or later.
#pragma once
#include <optional>
#include <span>

#include "motion/plan_drive.h"

namespace marketgen::motion {

// Of a body about its shoulders: half of a mean bideltoid breadth of 0.49 m (ANSUR II).
inline constexpr double person_radius_m = 0.24;

struct WayRound {
  std::optional<BaseFollower> aside = {};  // first, to where people can get past
  double wait_s = 0;                       // there
  BaseFollower on;                         // then
};

// Where a base that shuts the nearest of the people in lets them out: the nearest place within 6 m
// that it can get to without them, and with it there they get to where they cannot while it stands
// at `base`. Nothing where it shuts nobody in. `room_mm`: from the middle of the base to the middle
// of somebody who gets past.
std::optional<PointMm> passing_place(const navigation::FreeSpace& space,
                                     PointMm base,
                                     std::span<const MovingDisc> people,
                                     int room_mm);

// The nearest place that the base can get to without the nearest of the people and that is 3 m from
// them; the farthest from them where none is. Nothing where it cannot get away.
std::optional<PointMm> place_away(const navigation::FreeSpace& space,
                                  PointMm base,
                                  std::span<const MovingDisc> people,
                                  int room_mm);

// From rest. Round them where there is room; otherwise by a passing place; otherwise it waits a
// little and then drives as if nobody were there, and is held up again where they still are. When
// it has `waited` in vain it goes away from them first: they may see no way past it where it does.
// Errors: those of plan_drive.
Result<WayRound> plan_way_round(const navigation::VisibilityGraph& graph,
                                const robots::Robot& robot,
                                std::span<const double> state,
                                const FloorPlace& from,
                                const FloorPlace& to,
                                std::span<const MovingDisc> people,
                                bool waited = false);

}  // namespace marketgen::motion
