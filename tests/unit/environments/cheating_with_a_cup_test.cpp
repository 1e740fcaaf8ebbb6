// A cup at the counter that stops while it holds: at the stop it lets go, and what falls from high
// up was not put down. Those of fingers: cheating_policies_test.cpp.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "environments/run_episode.h"
#include "episodes/checkout/checkout_world.h"
#include "io/json.h"
#include "support/arm_waypoints.h"
#include "support/cup_pack.h"

namespace marketgen {
namespace {

class CheatsWithACup : public testing::Test {
 protected:
  // Takes the pack that hangs under its lip to a place over the area, and stops there.
  episodes::EpisodeResult stopped_over_area(double tip_m) {
    catalog::Product pack = box_pack();  // small and light: an arm that begins at once peels others
    pack.size_mm = {80, 60, 80};
    pack.mass_kg = 0.1;
    const auto reset = world_.reset(under_the_lip(world_, pack), {pack});
    if (!reset.ok()) fatal(to_string(reset.error()).c_str());
    seal();
    const auto& center = world_.station().unloading.center_m;
    Waypoints policy(world_.robot(),
                     {{{center[0], center[1], tip_m + 0.15}, 0, 0.2},
                      {{center[0], center[1], tip_m}, 0, 0.2},
                      {{center[0], center[1], tip_m}, 0, 0.2}});
    auto result = environments::run_policy(world_, policy, "cheat");
    if (!result.ok()) fatal(to_string(result.error()).c_str());
    return std::move(result).value();
  }

  // The lip is a millimetre over the pack.
  void seal() {
    agent::Action action = episodes::still_action(world_.observe());
    action.tools.front().opening_m = 0;
    for (int step = 0; step < 20; ++step)
      taken_from(world_.step(action));
    EXPECT_EQ(world_.watched(0).held_by, 0) << "it does not hold";
  }

  bool is_on_area() const {
    const Vec3 at = world_.item_pose(0).position;
    return world_.station().unloading.area().holds(at.x, at.y) && at.z < 0.1;
  }

  std::string where() const {
    const Vec3 at = world_.item_pose(0).position;
    return fmt::format("{:.3f}, {:.3f}, {:.3f}", at.x, at.y, at.z);
  }

  episodes::CheckoutWorld world_ = world_with("suction");
};

TEST_F(CheatsWithACup, StoppingWithAPackOverTheAreaIsWorthNothing) {
  const episodes::EpisodeResult result = stopped_over_area(0.25);
  EXPECT_EQ(result.hits, 0) << io::write_json(result);
  EXPECT_FALSE(result.success_strict);
  EXPECT_TRUE(is_on_area()) << "it fell elsewhere: " << where();
}

// The rule is the fall, not the stop: from just above it is put down.
TEST_F(CheatsWithACup, StoppingWithAPackOnTheAreaPutsItDown) {
  const episodes::EpisodeResult result = stopped_over_area(0.095);
  EXPECT_TRUE(is_on_area()) << "it fell elsewhere: " << where();
  EXPECT_EQ(result.hits, 1) << io::write_json(result);
}

}  // namespace
}  // namespace marketgen
