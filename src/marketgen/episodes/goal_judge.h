// Whether goals are met: a function of where things are and how they came there (docs/episodes.md).
// Every track has a region of its own; the rest is the same.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "base/fields.h"
#include "episodes/episode_spec.h"

namespace marketgen::episodes {

constexpr double rest_m_s = 0.02, min_rest_s = 1.0;
constexpr double judged_after_s = 2.0;  // the agent's stop
constexpr double max_impact_m_s = 1.0;
constexpr double min_volume_share = 0.5;

// What is known of an item when it is judged.
struct ItemState {
  std::string sku;
  Pose pose;                 // in the frame of the region
  Vec3 center_of_mass;       // product frame
  std::vector<Vec3> volume;  // points spread evenly through it, product frame
  bool touched = false;      // by a gripper
  double rested_s = 0;       // for how long it has been slower than rest_m_s
  double impact_m_s = 0;     // greatest speed at which it met something since it was let go
};

struct GoalOutcome {
  std::string sku;
  int count = 0, reached = 0;
  double rested_s = 0;
  static constexpr auto fields =
      field_list(field("sku", &GoalOutcome::sku, "product"),
                 field("count", &GoalOutcome::count, "how many were asked for"),
                 field("reached", &GoalOutcome::reached, "how many are in place"),
                 field("rested_s",
                       &GoalOutcome::rested_s,
                       "for how long all of these had lain there still when it was judged; 0: none "
                       "is in place"));
};

struct EpisodeOutcome {
  std::vector<GoalOutcome> goals;
  int asked = 0;
  int hits = 0;          // in place, less the wrong items; 0 when void
  int wrong = 0;         // items in the region that are no goal, or more than were asked for
  bool is_void = false;  // the track's own rule was broken
};

using HoldsPoint = std::function<bool(Vec3)>;  // a point in the frame of the region

// Its centre of mass, and at least half of its volume, are in the region.
bool is_inside(const HoldsPoint& region, const ItemState& item);
bool is_in_place(const HoldsPoint& region, const ItemState& item);

EpisodeOutcome judge(const HoldsPoint& region,
                     const std::vector<EpisodeGoal>& goals,
                     const std::vector<ItemState>& items);

}  // namespace marketgen::episodes
