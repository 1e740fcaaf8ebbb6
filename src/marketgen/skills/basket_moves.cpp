#include "skills/basket_moves.h"

#include <algorithm>
#include <array>

namespace marketgen::skills {
namespace {

constexpr double held_over_rim_m = 0.07, hand_over_rim_m = 0.05;
constexpr double close_s = 0.6, firm_s = 0.2;
constexpr double min_lift_m = 0.05, draw_back_m = 0.12;
constexpr std::array lift_shares{1.0, 0.85, 0.7}, raise_shares{1.0, 0.7, 0.4};
constexpr double aside_share = 0.4;  // of the way to the middle

}  // namespace

void close_hand(ArmExecutor& arm, double force_n) {
  arm.set_subtask(agent::Subtask::grasp);
  arm.wait(close_s, 0, touch_n);
  arm.wait(firm_s, 0, force_n);
}

Result<void> lift_out(ArmExecutor& arm,
                      const BasketSurroundings& basket,
                      double lowest_m,
                      Vec3 middle,
                      double force_n) {
  const double up = std::max(min_lift_m, basket.rim_z_m + held_over_rim_m - lowest_m);
  const Pose begin = arm.tip();
  const Vec3 aside{
      (middle.x - begin.position.x) * aside_share, (middle.y - begin.position.y) * aside_share, 0};
  arm.set_subtask(agent::Subtask::lift);
  Result<void> lifted;
  const auto goes = [&](const Surroundings& around, Vec3 by) {
    lifted = arm.straight(around, {begin.position + by, begin.rotation}, 0, force_n);
    return lifted.ok();
  };
  for (const Surroundings* around : {&basket.around, &basket.counter})
    for (const double share : lift_shares)
      if (goes(*around, {0, 0, up * share})) return lifted;
  for (const double share : lift_shares)
    if (goes(basket.around, aside + Vec3{0, 0, up * share})) return lifted;
  return lifted;
}

Result<void> draw_back(ArmExecutor& arm,
                       const BasketSurroundings& basket,
                       double opening_m,
                       double force_n) {
  arm.set_subtask(agent::Subtask::retreat);
  for (const auto& [around, by] : {std::pair{&basket.around, draw_back_m},
                                   {&basket.around, draw_back_m / 2},
                                   {&basket.counter, draw_back_m}}) {
    if (arm.straight(*around, arm.tip() * Pose{{0, 0, -by}, {}}, opening_m, force_n).ok()) break;
  }
  const Pose back = arm.tip();
  const double up_m = basket.rim_z_m + hand_over_rim_m - back.position.z;
  if (up_m <= 0) return {};
  Result<void> raised;
  for (const double share : raise_shares) {
    const Pose up{back.position + Vec3{0, 0, up_m * share}, back.rotation};
    raised = arm.straight(basket.around, up, opening_m, force_n);
    if (raised.ok()) break;
  }
  return raised;
}

}  // namespace marketgen::skills
