// A product in a hand, as an arm planner sees it.
#pragma once
#include <vector>

#include "assets/product_model.h"
#include "motion/arm_checker.h"

namespace marketgen::skills {

// The pack as a store has it: one solid, which may stand out beyond the pieces of
// make_product_body(). What is carried there must pass with that. Errors: of make_product_body and
// collision_of.
Result<assets::ProductBody> make_store_body(const catalog::Product& product);

// What presses on the hand that puts it down, N, when it has come upon something: its weight and
// what slow motion alone does not bring about.
double putting_force_n(const catalog::Product& product);

// The pack's box, turned: its middle and half size in the frame of `pose`. Exact.
struct TurnedBox {
  Vec3 middle, half;
};
TurnedBox turned_box(const assets::ProductBody& body, const Pose& pose);

// Balls along its longest side, on the link of the tip's frame (in Robot::frames), which may touch
// these links. Edges stand out from between balls: these are a tenth larger than the pack.
motion::AttachedObject held_product(const robots::Robot& robot,
                                    int tip_frame,
                                    const assets::ProductBody& body,
                                    const Pose& tip_from_product,
                                    std::vector<int> may_touch);

}  // namespace marketgen::skills
