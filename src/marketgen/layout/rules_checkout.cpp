// Rules about the tills.
#include <algorithm>
#include <optional>

#include "layout/rule_facts.h"

namespace marketgen::layout {
namespace {

constexpr double farthest_exit_m = 15;
constexpr double tight_clearance_share = 0.6;  // of the profile's clearance

// The plan says that there are none: orders are picked, or paid for at a desk.
bool wants_no_tills(const RuleFacts& facts) {
  if (!facts.design.plan.equipment) return false;
  return std::ranges::any_of(*facts.design.plan.equipment, [&](const plan::EquipmentSpec& spec) {
    const catalog::FixtureKind* kind = facts.catalog().fixture_kind(spec.kind);
    return spec.count == 0 && kind != nullptr && kind->role == catalog::FixtureRole::checkout;
  });
}

}  // namespace

Findings checkout_missing(const RuleFacts& facts) {
  // This kind of shop can do without, or this one shall.
  if (facts.profile().checkouts_per_100_m2 <= 0 || wants_no_tills(facts)) return {};
  for (std::size_t i = 0; i < facts.kinds.size(); ++i) {
    if (facts.is_checkout(i)) return {};
  }
  const Doorway* exit = exit_of(facts.design.floor, facts.shell());
  return {{"checkout",
           0,
           1,
           "there is no checkout",
           exit == nullptr ? std::optional<PointMm>{} : exit->approach.center()}};
}

Findings checkout_not_at_exit(const RuleFacts& facts) {
  const Doorway* exit = exit_of(facts.design.floor, facts.shell());
  std::optional<std::size_t> nearest;
  double nearest_m = 0;
  for (std::size_t i = 0; i < facts.kinds.size() && exit != nullptr; ++i) {
    if (!facts.is_checkout(i)) continue;
    const double away = 1e-3 * distance_mm(facts.footprints[i], point_rect(exit->threshold));
    if (nearest && away >= nearest_m) continue;
    nearest = i;
    nearest_m = away;
  }
  if (!nearest || nearest_m <= farthest_exit_m) return {};
  return {{facts.layout.fixtures[*nearest].id,
           nearest_m,
           farthest_exit_m,
           "the checkouts are far from the exit",
           facts.footprints[*nearest].center()}};
}

Findings checkout_tight(const RuleFacts& facts) {
  Findings found;
  const int limit = static_cast<int>(tight_clearance_share * facts.profile().checkout_clear_mm);
  for (std::size_t i = 0; i < facts.kinds.size(); ++i) {
    if (!facts.is_checkout(i) || facts.kinds[i]->generator != "checkout_lane") continue;
    const RectMm& rect = facts.footprints[i];
    const std::array<Side, 2> ends = rect.depth() > rect.width()
                                         ? std::array{Side::south, Side::north}
                                         : std::array{Side::west, Side::east};
    int room = limit;
    for (const Side end : ends) {
      const RectMm needed = strip_beyond(rect, end, limit);
      if (!facts.design.floor.bounds.contains(needed)) {
        room = std::min(
            room, distance_beyond(rect, end, strip_beyond(facts.design.floor.bounds, end, 1)));
      }
      for (std::size_t k = 0; k < facts.footprints.size(); ++k) {
        if (k != i && marketgen::overlap(facts.footprints[k], needed)) {
          room = std::min(room, distance_beyond(rect, end, facts.footprints[k]));
        }
      }
    }
    if (room >= limit) continue;
    found.push_back({facts.layout.fixtures[i].id,
                     static_cast<double>(room),
                     static_cast<double>(limit),
                     "only " + in_mm(room) + " are free before or after checkout " +
                         facts.layout.fixtures[i].id,
                     rect.center()});
  }
  return found;
}

}  // namespace marketgen::layout
