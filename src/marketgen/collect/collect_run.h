// A collection carried out in physics, and what became of the product and its neighbours: read from
// the simulation, not from the plan.
#pragma once
#include <functional>
#include <string_view>

#include "catalog/rows.h"
#include "collect/collect_plan.h"
#include "physics/world/robot_controller.h"

namespace marketgen::collect {

enum class CollectPhase { reach, close, lift, retreat, hold };
constexpr std::array<std::string_view, 5> names_of(CollectPhase) {
  return {"reach", "close", "lift", "retreat", "hold"};
}

struct CollectResult {
  bool held = false;         // in the gripper at the end, and it moved by less than 10 mm in it
  double slip_m = 0;         // of the product in the tool, from closing to the end
  double raised_m = 0;       // of the product, over where it stood
  double time_s = 0;         // simulated
  double squeeze_n = 0;      // mean of all that presses on the product at the end
  int neighbours_moved = 0;  // that came to rest more than 20 mm from where they stood
  int neighbours_toppled = 0;

  static constexpr auto fields =
      field_list(field("held", &CollectResult::held, "in the gripper at the end"),
                 field("slip_m", &CollectResult::slip_m, "in the tool, from closing to the end"),
                 field("raised_m", &CollectResult::raised_m, "over where it stood"),
                 field("time_s", &CollectResult::time_s, "simulated"),
                 field("squeeze_n", &CollectResult::squeeze_n, "all that presses on it at the end"),
                 field("neighbours_moved", &CollectResult::neighbours_moved, "by more than 20 mm"),
                 field("neighbours_toppled", &CollectResult::neighbours_toppled, "fell over"));
};

// Called every `watch_every_s` and at the end.
using CollectWatch =
    std::function<Result<void>(const physics::World&, const physics::RobotActor&, CollectPhase)>;

// `tool_id`'s frictions come from `frictions` (catalog.frictions). Errors: those of World::create
// and of `watch`.
Result<CollectResult> run_collect(const scene::Scene& scene,
                                  const robots::Robot& robot,
                                  const CollectPlan& plan,
                                  const std::vector<catalog::FrictionRow>& frictions,
                                  const CollectWatch& watch = {},
                                  double watch_every_s = 0.1);

}  // namespace marketgen::collect
