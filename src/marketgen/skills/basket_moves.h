// What a hand does at a basket on a counter between a grasp and a place: lifts out, draws back.
// Each move says what it is for: a grasp, a lift, a retreat.
//
// Base frame of the arm, SI units.
#pragma once
#include "skills/arm_executor.h"

namespace marketgen::skills {

struct BasketSurroundings {
  Surroundings around;   // everything that is known
  Surroundings counter;  // the counter alone: where something is touched, no line begins past it
  double rim_z_m = 0;    // that is to be cleared
};

// Of the pads until both of them touch: one alone pushes what it takes against what lies beside it.
constexpr double touch_n = 12;
// The hand shuts where it is, gently first.
void close_hand(ArmExecutor& arm, double force_n);

// Straight up until the lowest point of what is held, which is so high now, is well over the rim,
// or nearly; where nothing else goes, up and towards `middle`. Error of the line that was tried
// last.
Result<void> lift_out(ArmExecutor& arm,
                      const BasketSurroundings& basket,
                      double lowest_m,
                      Vec3 middle,
                      double force_n);

// The open hand back along itself, as far as it goes, and up over the rim, or a part of the way
// there. Error of the way up when not even that goes.
Result<void> draw_back(ArmExecutor& arm,
                       const BasketSurroundings& basket,
                       double opening_m,
                       double force_n);

}  // namespace marketgen::skills
