#include "policy/felt_contacts.h"

#include <algorithm>

#include "geometry/rotation_axes.h"

namespace marketgen::policy {
namespace {

constexpr double same_grasp_m = 0.012, same_grasp_rad = 0.3, same_place_m = 0.05;

}  // namespace

void FeltContacts::forget() {
  grasps_.clear();
  counts_.clear();
  places_.clear();
}

void FeltContacts::note_grasp(const Pose& base_from_tip, const perception::ProductLook& look) {
  grasps_.push_back(base_from_tip);
  ++counts_[&look];
}

bool FeltContacts::has_grasp(const Pose& base_from_tip) const {
  return std::ranges::any_of(grasps_, [&](const Pose& grasp) {
    return length(grasp.position - base_from_tip.position) < same_grasp_m &&
           turn_between(grasp.rotation, base_from_tip.rotation) < same_grasp_rad;
  });
}

bool FeltContacts::has_place(Vec3 tip) const {
  return std::ranges::any_of(places_,
                             [&](Vec3 place) { return length(place - tip) < same_place_m; });
}

int FeltContacts::count(const perception::ProductLook& look) const {
  const auto counted = counts_.find(&look);
  return counted == counts_.end() ? 0 : counted->second;
}

}  // namespace marketgen::policy
