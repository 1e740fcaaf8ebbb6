// Whether the goals of Checkout Unloading are met: a function of where things are and how they came
// there (docs: benchmark.md, "Goals, and what does not count").
#pragma once
#include <string>
#include <vector>

#include "base/fields.h"
#include "episodes/checkout_station.h"
#include "episodes/episode_spec.h"

namespace marketgen {

constexpr double rest_m_s = 0.02, least_rest_s = 1.0;
constexpr double judged_after_s = 2.0;  // the agent's stop
constexpr double most_impact_m_s = 1.0;
constexpr double least_volume_share = 0.5;
constexpr double most_tilt_deg = 15;

// What is known of an item when it is judged.
struct ItemState {
  std::string sku;
  Pose pose;                 // station_from_product
  Vec3 center_of_mass;       // product frame
  std::vector<Vec3> volume;  // points spread evenly through it, product frame
  bool touched = false;      // by the gripper
  double rested_s = 0;       // for how long it has been slower than rest_m_s
  double impact_m_s = 0;     // greatest speed at which it met something since it was let go
};

// Its centre of mass, and at least half of its volume, are over the area and not under it.
bool inside(const AreaRow& area, const ItemState& item);
bool in_place(const AreaRow& area, const ItemState& item);

struct GoalOutcome {
  std::string sku;
  int count = 0, reached = 0;
  static constexpr auto fields =
      field_list(field("sku", &GoalOutcome::sku, "product"),
                 field("count", &GoalOutcome::count, "how many were asked for"),
                 field("reached", &GoalOutcome::reached, "how many are in place"));
};

struct CheckoutOutcome {
  std::vector<GoalOutcome> goals;
  int asked = 0;
  int hits = 0;          // in place, less the wrong items; 0 when void
  int wrong = 0;         // items in the area that are no goal, or more than were asked for
  bool is_void = false;  // the basket was tilted too far
};
CheckoutOutcome judge_checkout(const AreaRow& area,
                               const std::vector<EpisodeGoal>& goals,
                               const std::vector<ItemState>& items,
                               double most_basket_tilt_deg);

}  // namespace marketgen
